#!/usr/bin/env python3
"""Runs gvd-paper on small meshes and make_paper.py on what it measured.

    check_paper.py GVD_PAPER FOLDER

Fails unless every table has rows, and unless make_paper.py refuses a missing table and a number that is not finite.
"""
import json
import pathlib
import subprocess
import sys

SCRIPT = pathlib.Path(__file__).resolve().parent.parent.parent / "scripts" / "make_paper.py"
ROWS = {"1": 6, "2": 7, "3": 9, "4": 7, "sets": 1, "5": 5, "fig10": 2, "why": 3}
HEADINGS = ["Table 1", "Table 2", "Table 3", "Table 4", "ten sets", "Table 5", "Figure 10", "Numbers that are not met"]


def render(document, folder):
    """Whether make_paper.py accepts the document."""
    measured = folder / "measured.json"
    measured.write_text(json.dumps(document))
    command = [sys.executable, str(SCRIPT), str(measured), str(folder)]
    return subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT).returncode == 0


def require(condition, message):
    if not condition:
        sys.exit(f"check_paper.py: {message}")


def check_refusals(document, folder):
    for key in ROWS:
        rest = {name: rows for name, rows in document["tables"].items() if name != key}
        require(not render({**document, "tables": rest}, folder), f"the pages are made without table {key}")
    broken = json.loads(json.dumps(document))
    broken["tables"]["5"][0]["methods"][0]["e"]["mean"] = None
    require(not render(broken, folder), "the pages are made with an E that is not finite")


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
    check_sets(document)
    check_gallery(document, folder)
    check_figures(document, folder)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
