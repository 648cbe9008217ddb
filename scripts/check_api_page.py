#!/usr/bin/env python3
"""Fails if docs/developer/api.md names a function that its header does not declare, or an example that does not use it.

    scripts/check_api_page.py
"""
import pathlib
import re
import sys

from tracked_files import ROOT, report

PAGE = ROOT / "docs/developer/api.md"
ROW = re.compile(r"\| [^|]+ \| (?P<functions>`[^|]+`[^|]*) \| `(?P<header>gvd/[^`]+)` \| \[[^]]+\]\((?P<example>[^)]+)\) \|")


def check(row):
    headers = [*ROOT.glob("libgvd/include/" + row["header"]), *ROOT.glob("libgvd/*/include/" + row["header"])]
    if not headers:
        yield f"{row['header']} is no public header"
        return
    declared, example = headers[0].read_text(), (PAGE.parent / row["example"]).resolve()
    for function in re.findall(r"`(\w+)`", row["functions"]):
        word = re.compile(rf"\b{function}\b")
        if not word.search(declared):
            yield f"{row['header']} does not declare {function}"
        if not word.search(example.read_text()):
            yield f"{pathlib.Path(row['example']).name} does not use {function}"


if __name__ == "__main__":
    rows = list(ROW.finditer(PAGE.read_text()))
    sys.exit(report(rows, (finding for row in rows for finding in check(row)), "rows"))
