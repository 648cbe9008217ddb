#!/usr/bin/env python3
"""Runs gvd-paper on small meshes and make_paper.py on what it measured.

    check_paper.py GVD_PAPER FOLDER

Fails unless every table has rows, unless make_paper.py refuses a missing table and a number that is not finite, and unless the
figures of its sentences come from what was measured or from the numbers of the paper.
"""
import ast
import json
import pathlib
import re
import subprocess
import sys

SCRIPT = pathlib.Path(__file__).resolve().parent.parent.parent / "scripts" / "make_paper.py"
ROWS = {"1": 6, "2": 7, "3": 9, "4": 7, "sets": 1, "5": 5, "fig10": 2, "crowd": 4}
HEADINGS = ["Figure 1", "Table 1", "Table 2", "Table 3", "Table 4", "10 sets", "Table 5", "Figure 10", "Section 5.4",
            "Numbers that are not met"]

# Numbers that a sentence may have although they are neither measured nor the paper's: references, numbers of its sections,
# figures and tables, an angle, and the bits of an index.
NAMES = re.compile(r"\[\d+\]|[Ss]ections? \d+(\.\d+)?|[Ff]igures? \d+( and \d+)?|[Tt]ables? \d+|angle below 30 degrees|below 30°"
                   r"|32-bit")
FIGURE = re.compile(r"\d*\.\d+|\d{2,}")


def render(document, folder):
    """Whether make_paper.py accepts the document. If not, it has to say why in one line of its own."""
    measured = folder / "measured.json"
    measured.write_text(json.dumps(document))
    command = [sys.executable, str(SCRIPT), str(measured), str(folder)]
    run = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    require(run.returncode == 0 or run.stderr.startswith("make_paper.py: "), f"make_paper.py fails with {run.stderr}")
    return run.returncode == 0


def require(condition, message):
    if not condition:
        sys.exit(f"check_paper.py: {message}")


def check_refusals(document, folder):
    for key in ROWS:
        rest = {name: rows for name, rows in document["tables"].items() if name != key}
        require(not render({**document, "tables": rest}, folder), f"the pages are made without table {key}")
    for key, methods in (("5", 7), ("3", 5), ("4", 6)):
        for index in range(methods):
            broken = json.loads(json.dumps(document))
            broken["tables"][key][0]["methods"][index]["e"]["mean"] = None
            require(not render(broken, folder), "the pages are made with an E that is not finite")
    require("infinite" in (folder / "paper.md").read_text(), "an infinite E is not in the page")


def check_gallery(document, folder):
    """The section with the pictures is there exactly where the folder has one."""
    require("Figures 1 and 9" not in (folder / "paper.md").read_text(), "a gallery without a picture")
    (folder / "pictures").mkdir(exist_ok=True)
    (folder / "pictures" / "lucy.webp").write_bytes(b"")
    require(render(document, folder), "the pages are not made with a picture")
    for page in ("paper.md", "paper.html"):
        text = (folder / page).read_text()
        require("Figures 1 and 9" in text and "pictures/lucy.webp" in text, f"no gallery in {page}")
        require("pictures/kitten.webp" not in text, f"a picture in {page} that is not there")
    (folder / "pictures" / "lucy.webp").unlink()


def check_figures(document, folder):
    """A line of pictures is there where all of it is."""
    names = [f"plate_{suffix}" for suffix in ("rvd", "lrvd", "planar", "exact")]
    for name in names + ["figure_10_planar"]:
        (folder / "pictures" / f"{name}.webp").write_bytes(b"")
    require(render(document, folder), "the pages are not made with pictures of figures")
    for page in ("paper.md", "paper.html"):
        text = (folder / page).read_text()
        require(all(f"pictures/{name}.webp" in text for name in names), f"no pictures of figure 11 in {page}")
        require("figure_10_planar" not in text, f"a line of figure 10 in {page} of which pictures are missing")
    require("pages/plate.html" in (folder / "paper.html").read_text(), "a picture does not lead to its page")
    for name in names + ["figure_10_planar"]:
        (folder / "pictures" / f"{name}.webp").unlink()


def literals(tree):
    """The strings of a module that are parts of sentences: not its docstrings, not single words."""
    documented = (ast.Module, ast.FunctionDef, ast.ClassDef)
    docstrings = {ast.get_docstring(node, clean=False) for node in ast.walk(tree) if isinstance(node, documented)}
    for node in ast.walk(tree):
        if isinstance(node, ast.Constant) and isinstance(node.value, str) and " " in node.value and node.value not in docstrings:
            yield node.value


def check_constants():
    """No sentence has a figure of its own, which would be of another run than the tables."""
    for name in ("time_tables", "error_tables", "diffusion", "not_met"):
        source = (SCRIPT.parent / "paper" / f"{name}.py").read_text()
        for text in literals(ast.parse(source)):
            found = FIGURE.findall(NAMES.sub("", text))
            require(not found, f"{name}.py has {found} as constants in: {text}")


def section_of(folder, title):
    """The text of one section of the page, without its tables."""
    text, = (part for part in (folder / "paper.md").read_text().split("\n## ") if part.startswith(title + ":"))
    return "\n".join(line for line in text.splitlines() if not line.startswith("|"))


def edit(document, table, index, method, **figures):
    """A copy with other figures of a method in one row."""
    copy = json.loads(json.dumps(document))
    one, = (m for m in copy["tables"][table][index]["methods"] if m["method"] == method)
    one.update(figures)
    return copy


def check_sentences(document, folder):
    """Sentences follow what was measured."""
    first = document["tables"]["2"][0]
    steps, = (one for one in first["methods"] if one["method"] == "paper's steps")
    for factor, is_faster in ((0.5, True), (2, False)):
        render(edit(document, "2", 0, "windows [27]", total_ms=factor * steps["total_ms"]), folder)
        told = re.search(r"faster than the paper's steps at ([^.]*)", section_of(folder, "Table 2"))
        require((told is not None and re.search(rf"m = {first['m']}\b", told.group(1)) is not None) == is_faster,
                "where the paper's steps are slower than [27]")
    render(edit(document, "5", 0, "LRVD [28]", by_straight=0.1234), folder)
    require("0.12" in section_of(folder, "Table 5 and figure 11"), "how far borders of LRVD are from bisectors")
    render(edit(document, "crowd", 0, "diffusion [8]", wrong_percent=87.6), folder)
    require("88 %" in section_of(folder, "Section 5.4"), "the wrong labels of diffusion in a crowd")
    require(render(document, folder), "make_paper.py refuses a whole document")
    lucy, = (row for row in document["tables"]["4"] if row["model"] == "Lucy")
    found = section_of(folder, "Figure 1")
    require("0.2 seconds" in found and "58.1 %" in found, "what figure 1 says")
    require(f"{lucy['percent_below_30']:.1f} %" in found, "the share of bad triangles of Lucy")


def check_memory(folder):
    """The paper's memory is not always below that of its meshes."""
    for title, count, below in (("Table 1", 6, 5), ("Table 2", 7, 3)):
        require(f"Of the paper's {count} numbers here, {below} are below" in section_of(folder, title), f"memory of {title}")


def headings_of(page):
    """The headings of a page and the heads of its tables."""
    lines = page.read_text().splitlines()
    return {line for line, after in zip(lines, lines[1:] + [""]) if line.startswith("## ") or after.startswith("|---")}


def check_committed_page(folder):
    """The page of the documents is one that these scripts make."""
    missing = headings_of(folder / "paper.md") - headings_of(SCRIPT.parent.parent / "docs" / "paper.md")
    require(not missing, f"docs/paper.md was made by other scripts: it lacks {sorted(missing)}")


def check_sets(document):
    row, = document["tables"]["sets"]
    for method in row["methods"]:
        require(len(method["errors"]) == 10, "E on Spot is not of ten sets")
        require(max(method["errors"]) == method["e"]["max"], "the largest E is not that of the sets")


def main(program, folder):
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    subprocess.run([program, "--runs", "1", "--scale", "0.05", "-o", str(folder / "paper.json")], check=True)
    document = json.loads((folder / "paper.json").read_text())
    found = {key: len(rows) for key, rows in document["tables"].items()}
    require(found == ROWS, f"rows of the tables are {found}, expected {ROWS}")
    check_refusals(document, folder)
    require(render(document, folder), "make_paper.py refuses a whole document")
    for name in ("paper.md", "paper.html"):
        text = (folder / name).read_text()
        for heading in HEADINGS:
            require(heading in text, f"{name} has no {heading}")
        for size in ("150000 faces", "m = 500"):
            require(size in text, f"{name} lacks the paper's numbers for {size}")
        require("nan" not in text and "inf " not in text, f"{name} has a number that is not finite")
    require((folder / "paper.html").read_text().count("<svg") == 2, "tables 1 and 2 have no plots")
    check_constants()
    check_committed_page(folder)
    check_sets(document)
    check_memory(folder)
    check_sentences(document, folder)
    check_gallery(document, folder)
    check_figures(document, folder)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
