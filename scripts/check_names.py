#!/usr/bin/env python3
"""Fails if a document names, in backticks, a file or a piece of code that does not exist in this repository.

    scripts/check_names.py

Documents are README.md, CONTRIBUTING.md, the pages of docs/ and the README of every folder. Paths may be given from the
repository, from the page's folder, from an include folder, or below libgvd/src; a source's extension may be omitted. Words in
capitals stand for anything (apps/NAME). Code is searched among the words of sources, scripts and CMake files.

In the tables of the paper map, each function is named in a file of its row.

Also fails if CTest can't run a test by its name. After an unclosed bracket, CMake joins the following names into one; CTest takes a
name that begins with a dash for an option.
"""
import re
import sys

from tracked_files import ROOT, report, tracked

# Names that are not in the sources, and why.
FOREIGN = {
    "snake_case": "a way of writing names",
    "build/site": "a folder that `make site` makes",
    "Kd": "a keyword of OBJ's material files",
    "MaterialIds": "an array of VTK",
    "data/meshes": "a folder of Debian's libcgal-demo",
    "test_diagram": "a target that add_gvd_tests of tests/CMakeLists.txt puts together",
    "test_geodesic": "likewise",
}

FENCE = re.compile(r"^(```|~~~).*?^\1", re.MULTILINE | re.DOTALL)
CODE = re.compile(r"`([^`\n]+)`")
PATH = re.compile(r"\.?[\w-][\w.-]*(/[\w.-]+)*/?")
SOURCE_NAME = re.compile(r".+\.(hpp|cpp|py|sh|md|cmake|js|mjs)")
# Identifiers in the style of this project: with an underscore inside, or CamelCase; possibly qualified or called.
IDENTIFIER = re.compile(r"(?:[A-Za-z]\w*::)*(?:[A-Za-z]\w*_\w+|[A-Z][A-Za-z0-9]*[a-z]\w*)(?:\(\))?")
PLACEHOLDER = re.compile(r"(?<![A-Za-z])[A-Z]{4,}(?![A-Za-z])")


def is_page(path):
    name = path.relative_to(ROOT)
    return path.name in ("README.md", "CONTRIBUTING.md") or (name.parts[0] == "docs" and path.suffix == ".md")


def collect_words(files):
    """All identifiers of the sources, and the names of all files without extension."""
    words = {path.stem for path in files}
    for path in files:
        code = path.suffix in (".hpp", ".cpp", ".h", ".in", ".py", ".sh", ".cmake", ".js", ".mjs", ".json", ".yml")
        if code or path.name in ("CMakeLists.txt", "Makefile", "run"):
            words.update(re.findall(r"\w+", path.read_text(errors="ignore")))
    return words


def path_exists(name, page):
    """Whether a path leads to a file or a folder, from one of the places where the paths of a page may begin."""
    pattern = PLACEHOLDER.sub("*", name.rstrip("/"))
    include = [ROOT / "libgvd" / part / "include" for part in ("", "segment", "lloyd", "remesh", "operations", "verify", "c")]
    for start in [ROOT, page.parent, ROOT / "libgvd/src", ROOT / "apps", ROOT / "web", *include]:
        if any(start.glob(pattern)) or any(start.glob(pattern + ".[ch]pp")):
            return True
    return False


def is_path(text, tops):
    """Whether a piece of code is a path that could be one of ours."""
    return PATH.fullmatch(text) is not None and ("/" in text and text.split("/")[0] in tops
                                                 or SOURCE_NAME.fullmatch(text) is not None)


def is_missing(text, page, tops, words, names):
    if text in FOREIGN or text.startswith("std::"):
        return False
    if is_path(text, tops):
        return not path_exists(text, page) and text not in names
    if not IDENTIFIER.fullmatch(text) or PLACEHOLDER.search(text):
        return False
    return any(word not in words for word in re.findall(r"\w+", text))


def unusable_test_names(files):
    """The names of tests that CTest could not run."""
    for path in files:
        if path.suffix != ".cpp":
            continue
        for name in re.findall(r'TEST_CASE\(\s*"((?:[^"\\]|\\.)*)"', path.read_text(errors="ignore")):
            if name.count("[") != name.count("]") or name.startswith("-"):
                yield f'{path.relative_to(ROOT)}: CTest cannot run a test named "{name}"'


def misplaced_functions(page):
    """The functions in a table of `item | file | function | test | ...` that no file of their row names."""
    for line in page.read_text().splitlines():
        cells = line.split("|")[1:-1]
        if len(cells) < 5:
            continue
        places = [ROOT / start / name for name in CODE.findall(cells[1] + cells[3]) for start in ("", "libgvd/src")]
        files = [path for place in places for path in (place.glob("*.*") if place.is_dir() else [place]) if path.is_file()]
        text = " ".join(path.read_text(errors="ignore") for path in files)
        for function in CODE.findall(cells[2]):
            if IDENTIFIER.fullmatch(function) and function.split("::")[-1] not in re.findall(r"\w+", text):
                yield f"{page.relative_to(ROOT)}: names `{function}`, which the files of its row do not have"


def main():
    files = tracked()
    words = collect_words(files)
    names = {path.name for path in files}
    # The first part of a path of ours: a folder of the repository, of libgvd or of libgvd/src.
    folders = [ROOT, ROOT / "libgvd", ROOT / "libgvd/src", ROOT / "libgvd/include", ROOT / "web"]
    tops = {child.name for folder in folders for child in folder.iterdir() if child.is_dir()}
    pages = [path for path in files if is_page(path)]
    findings = list(unusable_test_names(files)) + list(misplaced_functions(ROOT / "docs/developer/paper-map.md"))
    for page in pages:
        own_tops = tops | {child.name for child in page.parent.iterdir() if child.is_dir()}
        for text in sorted(set(CODE.findall(FENCE.sub("", page.read_text())))):
            if is_missing(text, page, own_tops, words, names):
                findings.append(f"{page.relative_to(ROOT)}: names `{text}`, which is not there")
    return report(pages, findings)


if __name__ == "__main__":
    sys.exit(main())
