#!/usr/bin/env python3
"""Holds the guide and the schema of reports against the options that the commands describe (--print-options).

    scripts/check_described_options.py BIN             prints what differs, and exits with 1 if anything does
    scripts/check_described_options.py BIN --write     writes the schema's part on options anew

In the guide's tables whose first column is headed "option", each option must exist, with the choices and the default that it has;
and the guide must name each option of a command. A placeholder of the library's texts must name an option, too.
"""
import json
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
COMMANDS = ["segment", "lloyd", "remesh", "distance"]
SCHEMA = ROOT / "docs/schema/gvd-report-2.schema.json"


def describe(bin_folder, command):
    done = subprocess.run([f"{bin_folder}/gvd-{command}", "--print-options"], stdout=subprocess.PIPE, check=True)
    return json.loads(done.stdout)["options"]


# ---- the schema

def property_of(option):
    """The schema of an option's value in a report."""
    kind = option["kind"]
    if kind == "flag":
        return {"type": "boolean"}
    if kind == "switch":
        return {"type": ["boolean", "null"]}
    if kind in ("number", "whole number"):
        made = {"type": ["number" if kind == "number" else "integer", "null"]}
        if "choices" in option:  # words such as "none", which stand for a number
            made["type"].insert(1, "string")
            made["pattern"] = f"^({'|'.join(option['choices'])})$"
        if option["name"] != "threads":
            for key, name in (("least", "minimum"), ("above", "exclusiveMinimum"), ("most", "maximum"), ("below", "exclusiveMaximum")):
                if key in option:
                    made[name] = option[key]
        return made
    if kind == "choice":
        return {"enum": option["choices"] + [None]}
    if kind == "choices":
        return {"type": ["array", "null"], "items": {"enum": option["choices"]}}
    if kind == "points":
        return {"description": "a file, or vertices", "type": ["string", "array", "null"], "items": {"$ref": "#/$defs/index"}}
    if kind == "vertices":
        return {"type": ["array", "null"], "items": {"$ref": "#/$defs/index"}}
    if kind == "counts":
        return {"type": ["array", "null"], "items": {"type": "integer", "minimum": 1}}
    if kind == "bytes":
        return {"type": ["integer", "null"], "minimum": 1}
    if kind == "bound":
        return {"description": "mesh units, or percent of the diagonal", "type": ["number", "string", "null"], "exclusiveMinimum": 0}
    if kind == "crease angle":
        return {"type": ["number", "string", "null"], "exclusiveMinimum": 0, "maximum": 180, "pattern": "^(auto|none)$"}
    if option["repeatable"] and option["name"] != "input":  # each run has one input
        return {"type": "array", "items": {"type": "string"}}
    return {"type": "string" if option["name"] == "input" else ["string", "null"]}


def merge(one, other):
    """The schema of an option that two commands have: of formats, each has its own."""
    if one == other:
        return one
    if "items" in one and "enum" in one["items"]:
        names = one["items"]["enum"] + [n for n in other["items"]["enum"] if n not in one["items"]["enum"]]
        return {**one, "items": {"enum": names}}
    raise SystemExit(f"two commands have an option of one name and other values: {one}, {other}")


def make_properties(described):
    made, everywhere = {}, None
    for options in described.values():
        for option in options:
            value = property_of(option)
            if option["unit"]:
                value = {"description": option["unit"], **value}
            made[option["name"]] = merge(made[option["name"]], value) if option["name"] in made else value
        names = [o["name"] for o in options]
        everywhere = names if everywhere is None else [n for n in everywhere if n in names]
    return everywhere, made


def schema_text(described):
    """The schema's text, with its `options` as described: one property a line."""
    required, made = make_properties(described)
    lines = ",\n".join(f'        {json.dumps(name)}: {json.dumps(value)}' for name, value in made.items())
    names = ",\n".join(f'        "{name}"' for name in required)
    options = ('"options": {\n'
               '      "description": "every option of the command, with its value as the run understood it; null for one without a value",\n'
               f'      "type": "object",\n      "required": [\n{names}\n      ],\n      "properties": {{\n{lines}\n      }}\n    }}')
    return re.sub(r'"options": \{\n.*?\n    \}(?=,\n    "seed")', lambda _: options, SCHEMA.read_text(), flags=re.DOTALL)


# ---- the guide

def tables(page):
    """The rows of tables whose first column is headed "option"."""
    lines = page.read_text().split("\n")
    inside = False
    for number, line in enumerate(lines, 1):
        if re.match(r"\| option( |s )*\|", line):
            inside = True
        elif not line.startswith("|"):
            inside = False
        elif inside and not line.startswith("|---"):
            yield number, [cell.replace("\\|", "|").strip() for cell in re.split(r"(?<!\\)\|", line)[1:-1]]


def check_guide(described):
    by_name = {}
    for options in described.values():
        for option in options:
            for name in option["names"]:
                by_name.setdefault(name, []).append(option)
    questions = {"-h", "--help", "--version"}
    findings, seen = [], {"INPUT"}
    for page in sorted((ROOT / "docs/guide").rglob("*.md")):
        seen.update(re.findall(r"(?<![\w-])--?[a-z][a-z-]*", page.read_text()))
        for number, cells in tables(page):
            for name, value in re.findall(r"`(--?[a-z][a-z-]*|-[a-z])(?:[ =]([^`]*))?`", cells[0]):
                where = f"{page.relative_to(ROOT)}:{number}: {name}"
                if name in questions:
                    continue
                if name not in by_name:
                    findings.append(f"{where} is no option of any command")
                    continue
                shown = value.split("|") if value else []
                choices = [set(o.get("choices", [])) for o in by_name[name] if o["kind"] in ("choice", "switch")]
                if len(shown) > 1 and choices and set(shown) not in choices and not all(o["kind"] == "switch" for o in by_name[name]):
                    findings.append(f"{where}: the table has {value}, the command {'|'.join(sorted(choices[0]))}")
            check_default(page, number, cells, by_name, findings)
    for command, options in described.items():
        for option in options:
            if not seen.intersection(option["names"]):
                findings.append(f"docs/guide: no page names {option['names'][-1]} of gvd-{command}")
    return findings


def check_default(page, number, cells, by_name, findings):
    """A default that is one number or name must be the described one."""
    names = re.findall(r"`(--?[a-z][a-z-]*)[^`]*`", cells[0])
    if len(cells) < 3 or len(names) != 1 or names[0] not in by_name:
        return
    shown = re.fullmatch(r"`?([a-z0-9.e-]+)`?", cells[1])
    if not shown or shown[1] in ("off", "none", "uniform", "default"):
        return
    defaults = {option["default"] for option in by_name[names[0]]}
    same = [d for d in defaults if d is not None and (d == shown[1] or as_number(d) == as_number(shown[1]) is not None)]
    if not same:
        findings.append(f"{page.relative_to(ROOT)}:{number}: {names[0]}: the table has the default {shown[1]}, "
                        f"the command {sorted(map(str, defaults))}")


# Options of operations that no command has: describe_for_programs describes them.
OF_PROGRAMS = {"logarithm", "levels", "editable", "move", "add", "remove", "content", "colors", "part"}


def check_placeholders(described):
    names = OF_PROGRAMS | {option["name"] for options in described.values() for option in options}
    for source in sorted((ROOT / "libgvd").rglob("*.[ch]pp")):
        for inside in re.findall(r"\\1\??([a-z_|=]+)", source.read_text()):
            if source.name == "placeholders.hpp":
                continue  # its examples
            for name in re.findall(r"(?:^|\|)([a-z_]+)", inside):
                if name not in names:
                    yield f"{source.relative_to(ROOT)}: \\1{name}\\2 is no option of any command"


def as_number(text):
    try:
        return float(text)
    except ValueError:
        return None


def main():
    described = {command: describe(sys.argv[1], command) for command in COMMANDS}
    text = schema_text(described)
    if "--write" in sys.argv[2:]:
        SCHEMA.write_text(text)
    findings = check_guide(described) + list(check_placeholders(described))
    if text != SCHEMA.read_text():
        findings.append(f"{SCHEMA.relative_to(ROOT)}: its options are not those of the commands; --write mends it")
    for finding in findings:
        print(finding)
    return 1 if findings else 0


if __name__ == "__main__":
    sys.exit(main())
