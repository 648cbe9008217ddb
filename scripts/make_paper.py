#!/usr/bin/env python3
"""Makes a Markdown file and an HTML page from the measurements of gvd-paper, beside the numbers of the paper's section 5.

    scripts/make_paper.py MEASURED.json FOLDER [NOTE]      writes FOLDER/paper.md and FOLDER/paper.html

The note, on the machine and the day, follows the introduction. Fails if a table is missing, and after writing the pages if a number
is not finite.
"""
import json
import math
import pathlib
import sys

from paper.diffusion import figure_10, section_5_4
from paper.error_tables import sets, table_3, table_4, table_5
from paper.gallery import FIGURE_10, FIGURE_11, STRAIGHT, ZIGZAG, compare_pictures, gallery
from paper.html_page import to_html
from paper.markdown_page import to_markdown
from paper.not_met import numbers_not_met
from paper.time_tables import figure_1, table_1, table_2

TABLES = ["1", "2", "3", "4", "sets", "5", "fig10", "crowd"]


def introduce(runs):
    return (f"Generators are random vertices, with a different seed in each run. Runs: {runs}. Times are medians; E is the"
            " mean with the standard deviation. Each row names the mesh that stands for the paper's model."
            " The method \"paper\" is the printed number. \"Paper's steps\" is our --method paper, which follows the steps as written.")


def check_tables(tables):
    for key in TABLES:
        if not tables.get(key):
            sys.exit(f"make_paper.py: table {key} is missing")


def numbers_of(value):
    """All leaves of a method's figures except its name."""
    if isinstance(value, dict):
        return [x for key, part in value.items() if key != "method" for x in numbers_of(part)]
    return [x for part in value for x in numbers_of(part)] if isinstance(value, list) else [value]


def check_numbers(tables):
    for key, rows in tables.items():
        for row in rows:
            for method in row["methods"]:
                if not all(isinstance(x, (int, float)) and math.isfinite(x) for x in numbers_of(method)):
                    sys.exit(f"make_paper.py: table {key}, {row['mesh']}, {method['method']}: a number is not finite")


def main(measured, folder, note=""):
    document = json.loads(pathlib.Path(measured).read_text())
    tables = document["tables"]
    check_tables(tables)
    straight, zigzag = table_5(tables["5"]), figure_10(tables["fig10"])
    sections = [figure_1(tables["4"]), table_1(tables["1"]), table_2(tables["2"]), table_3(tables["3"]), table_4(tables["4"]),
                sets(tables["sets"]), zigzag, section_5_4(tables), straight, numbers_not_met(tables["5"])]
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    compare_pictures(straight, STRAIGHT, folder, FIGURE_11)
    compare_pictures(zigzag, ZIGZAG, folder, FIGURE_10)
    sections += gallery(folder)
    text = f"{introduce(document['runs'])} {note}".strip()
    (folder / "paper.html").write_text(to_html(sections, text))
    (folder / "paper.md").write_text(to_markdown(sections, text))
    print(folder / "paper.md")
    check_numbers(tables)


if __name__ == "__main__":
    if len(sys.argv) not in (3, 4):
        sys.exit(__doc__)
    main(*sys.argv[1:])
