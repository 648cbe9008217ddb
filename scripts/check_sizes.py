#!/usr/bin/env python3
"""Fails where functions, classes or parameter lists have grown beyond what CONTRIBUTING.md allows, or tests are too few.

    scripts/check_sizes.py [--list]     --list names the functions of more than 25 lines too

The limits hold for all sources but the tests, whose functions are not counted. Needs universal-ctags.
"""
import json
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent

USUAL_FUNCTION_LINES = 25
SHARE_OF_USUAL_FUNCTIONS = 0.95
MOST_FUNCTION_LINES = 45
MOST_CLASS_LINES = 200
MOST_PARAMETERS = 5
TEST_LINES_PER_LINE = 0.7

# A class of more lines says why in the comment above it, in a sentence that begins like this.
REASON = "Long because"


def sources():
    listed = subprocess.check_output(["git", "ls-files", "*.cpp", "*.hpp"], cwd=ROOT, text=True)
    return [name for name in listed.split() if (ROOT / name).exists()]


def read_tags(names):
    """Functions and classes as dictionaries of ctags: path, name, kind, line, end, signature."""
    command = ["ctags", "--output-format=json", "--fields=+neS", "--kinds-C++=fcs", "-L", "-", "-f", "-"]
    output = subprocess.run(command, cwd=ROOT, input="\n".join(names), text=True, check=True, stdout=subprocess.PIPE)
    tags = [json.loads(line) for line in output.stdout.splitlines()]
    return [tag for tag in tags if "end" in tag]


def count_lines(tag):
    return tag["end"] - tag["line"] + 1


def count_parameters(tag):
    inside = tag.get("signature", "()").strip()[1:-1].strip()
    if inside in ("", "void"):
        return 0
    depth = commas = 0
    for character in inside:
        depth += (character in "<({[") - (character in ">)}]")
        commas += character == "," and depth == 0
    return commas + 1


def gives_reason(tag):
    """Whether the comment above a class says why it is long."""
    above = (ROOT / tag["path"]).read_text().splitlines()[: tag["line"] - 1]
    while above and above[-1].lstrip().startswith(("//", "template")):
        if REASON in above.pop():
            return True
    return False


def check_functions(functions):
    findings = [f"{t['path']}:{t['line']}: {t['name']} has {count_lines(t)} lines (at most {MOST_FUNCTION_LINES})"
                for t in functions if count_lines(t) > MOST_FUNCTION_LINES]
    findings += [f"{t['path']}:{t['line']}: {t['name']} has {count_parameters(t)} parameters (at most {MOST_PARAMETERS})"
                 for t in functions if count_parameters(t) > MOST_PARAMETERS]
    long = [t for t in functions if count_lines(t) > USUAL_FUNCTION_LINES]
    if "--list" in sys.argv[1:]:
        for t in sorted(long, key=count_lines):
            print(f"{t['path']}:{t['line']}: {t['name']} has {count_lines(t)} lines")
    share = 1 - len(long) / len(functions)
    print(f"{len(functions)} functions, {share:.1%} of at most {USUAL_FUNCTION_LINES} lines")
    if share < SHARE_OF_USUAL_FUNCTIONS:
        findings.append(f"{len(long)} functions have more than {USUAL_FUNCTION_LINES} lines: "
                        f"{1 - share:.1%} of all, at most {1 - SHARE_OF_USUAL_FUNCTIONS:.0%} (--list names them)")
    return findings


def check_classes(classes):
    return [f"{t['path']}:{t['line']}: {t['name']} has {count_lines(t)} lines (at most {MOST_CLASS_LINES}, or a sentence "
            f"above it that begins with '{REASON}')"
            for t in classes if count_lines(t) > MOST_CLASS_LINES and not gives_reason(t)]


def check_tests(names):
    lines = {True: 0, False: 0}
    for name in names:
        lines[name.startswith("tests/")] += len((ROOT / name).read_text().splitlines())
    ratio = lines[True] / lines[False]
    print(f"{lines[True]} lines of tests, {lines[False]} of other code: {ratio:.3f}")
    return [f"tests have {ratio:.3f} lines for each line of other code (at least {TEST_LINES_PER_LINE})"
            ] if ratio < TEST_LINES_PER_LINE else []


def main():
    names = sources()
    tags = read_tags([name for name in names if not name.startswith("tests/")])
    findings = check_functions([t for t in tags if t["kind"] == "function"])
    findings += check_classes([t for t in tags if t["kind"] in ("class", "struct")])
    findings += check_tests(names)
    for finding in findings:
        print(finding)
    print(f"{len(findings)} findings")
    return 1 if findings else 0


if __name__ == "__main__":
    sys.exit(main())
