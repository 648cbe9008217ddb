#!/usr/bin/env python3
"""Compares the figures of the documents with the current output of their commands, or updates them.

    scripts/figures.py check BIN_FOLDER     fails if a document and a run differ by more than a tenth
    scripts/figures.py write BIN_FOLDER     writes the figures of a run into the documents, with as many digits as before

docs/figures.toml has an entry for each sentence or row of a table:

    document   the page
    command    a line for the shell, in a folder where `data` is that of the repository; one run serves all entries with it
    text       the sentence in the page, with {} for each figure
    values     for each {} a Python expression; `report["results"]` reads report.json, `size("page.html")` counts bytes,
               `printed(PATTERN)` is the first group of a regular expression in the command's output
    models     meshes that the command needs in addition to data/: in the folder GVD_MODELS, in ../shared/models or ../shared/reference,
               or unpacked from Debian's libcgal-demo. If one is missing, the entry is skipped with a message.
    unchecked  true: a time, which differs from machine to machine, or a run of more than a few seconds. Only `write` measures it.
"""
import json
import os
import pathlib
import re
import subprocess
import sys
import tarfile
import tempfile
import tomllib

ROOT = pathlib.Path(__file__).resolve().parent.parent
TOLERANCE = 0.1
NUMBER = r"(-?[0-9][0-9,]*(?:\.[0-9]+)?(?:e-?[0-9]+)?|\.[0-9]+)"
CORPUS = pathlib.Path("/usr/share/doc/libcgal-demo/data.tar.gz")


def find_model(name, folder):
    """A mesh by its file name; one of the corpus is unpacked into `folder`. None if it is missing."""
    given = [pathlib.Path(os.environ["GVD_MODELS"])] if "GVD_MODELS" in os.environ else []
    for place in given + [ROOT / "../shared/models", ROOT / "../shared/reference"]:
        if (place / name).exists():
            return (place / name).resolve()
    member = f"data/meshes/{name}"
    if CORPUS.exists():
        with tarfile.open(CORPUS) as archive:
            if member in archive.getnames():
                (folder / name).write_bytes(archive.extractfile(member).read())
                return folder / name
    return None


class Run:
    """One command, its files and its output."""

    def __init__(self, command, models, bin_folder, folder):
        self.folder = folder
        (folder / "data").symlink_to(ROOT / "data")
        self.missing = None
        for name in models:
            path = find_model(name, folder)
            if path is None:
                self.missing = name
                return
            if path.parent != folder:
                (folder / name).symlink_to(path)
        environment = dict(os.environ, PATH=f"{bin_folder}:{os.environ['PATH']}")
        done = subprocess.run(["sh", "-ec", command], cwd=folder, env=environment, text=True, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT)
        self.output = done.stdout
        if done.returncode != 0:
            raise SystemExit(f"figures.py: exit {done.returncode} of: {command}\n{done.stdout}")

    def printed(self, pattern):
        found = re.search(pattern, self.output)
        if not found:
            raise SystemExit(f"figures.py: nothing like {pattern} in what was printed:\n{self.output}")
        return float(found[1].replace(",", ""))

    def evaluate(self, expression):
        names = {path.stem: json.loads(path.read_text()) for path in self.folder.glob("*.json")}
        names.update(size=lambda name: (self.folder / name).stat().st_size, printed=self.printed)
        return float(eval(expression, names))  # the expressions are our own


def format_like(value, text):
    """`value` with as many decimals and the separators that `text` has."""
    if "e" in text:
        digits = len(text.split("e")[0].replace(".", "").lstrip("-"))
        mantissa, exponent = f"{value:.{digits - 1}e}".split("e")
        return f"{mantissa}e{int(exponent)}"
    decimals = len(text.split(".")[1]) if "." in text else 0
    written = f"{value:,.{decimals}f}" if "," in text or value >= 10000 else f"{value:.{decimals}f}"
    return written[1:] if text.startswith(".") and written.startswith("0.") else written


def differ(value, text):
    shown = float(text.replace(",", ""))
    return abs(shown - value) > TOLERANCE * max(abs(value), abs(shown))


def handle(entry, run, write):
    """Messages about one entry; with `write` its document is changed instead."""
    page = ROOT / entry["document"]
    content = page.read_text()
    pattern = NUMBER.join(re.escape(part).replace(r"\ ", r"\s+") for part in entry["text"].split("{}"))
    found = re.search(pattern, content)
    if not found or len(found.groups()) != len(entry["values"]):
        return [f"{entry['document']}: does not have the text: {entry['text']}"]
    values = [run.evaluate(expression) for expression in entry["values"]]
    if not write:
        return [f"{entry['document']}: {text} where a run gives {format_like(value, text)}: {entry['text']}"
                for value, text in zip(values, found.groups()) if differ(value, text)]
    for group in range(len(values), 0, -1):
        begin, end = found.span(group)
        content = content[:begin] + format_like(values[group - 1], found[group]) + content[end:]
    page.write_text(content)
    return []


def main():
    if len(sys.argv) != 3 or sys.argv[1] not in ("check", "write"):
        raise SystemExit(__doc__)
    write, bin_folder = sys.argv[1] == "write", pathlib.Path(sys.argv[2]).resolve()
    entries = tomllib.loads((ROOT / "docs/figures.toml").read_text())["figure"]
    entries = [entry for entry in entries if write or not entry.get("unchecked")]
    runs, findings, figures = {}, [], 0
    with tempfile.TemporaryDirectory() as top:
        for entry in entries:
            command = entry["command"]
            if command not in runs:
                folder = pathlib.Path(top) / str(len(runs))
                folder.mkdir()
                runs[command] = Run(command, entry.get("models", []), bin_folder, folder)
            if runs[command].missing:
                print(f"skipped, no {runs[command].missing}: {entry['document']}: {entry['text']}")
                continue
            findings += handle(entry, runs[command], write)
            figures += len(entry["values"])
    print("\n".join(findings + [f"{figures} figures of {len(runs)} commands, {len(findings)} findings"]))
    return 1 if findings else 0


if __name__ == "__main__":
    sys.exit(main())
