#!/usr/bin/env python3
"""Holds the documents against the table of formats, as the commands describe it (--print-options).

    scripts/check_described_formats.py BIN      prints what differs, and exits with 1 if anything does

The tables of docs/guide/formats.md, input.md and distance.md must have a row for each format, and what it holds; and each list of
extensions in a document that follows from what formats carry must be complete.
"""
import json
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent

# Sentences with a list of extensions: the page, the text around the list, the word before its last member, what the formats in it carry
# some of, and what they don't carry. Where a text has "{all}", their further extensions are in the list, too.
SENTENCES = [
    ("docs/guide/formats.md", "`--no-curves` leaves the bisectors out of {}. It is", "and", {"curves"}, set()),
    ("docs/guide/formats.md", "- {} have doubles and keep every bit", "and", {"doubles"}, set()),
    ("docs/guide/commands.md", "| leave the bisectors out of {} |", "and", {"curves"}, set()),
    ("docs/guide/distance.md", "Paths and isolines go to {}", "and", {"curves", "isolines"}, set()),
    ("docs/guide/remesh.md", "texture coordinates to {}, and materials", "and", {"texture coordinates"}, set()),
    ("docs/guide/segment.md", "all with the same scale. {} have texture coordinates", "and", {"texture coordinates"}, set()),
    ("docs/guide/segment.md", "`--vertex-labels` also takes {all}, `--vertex-distances`", "and", {"vertex labels"}, {"surface"}),
    ("docs/guide/segment.md", "`--vertex-distances` also {all}, as", "and", {"distances"}, {"surface"}),
    ("python/gvd/_object.py", " {} (FreeSurfer) hold meshes", "and", {"surface"}, set()),
    ("python/gvd/_object.py", "hold meshes, {} labels of vertices", "and", {"vertex labels"}, {"surface"}),
    ("python/gvd/_object.py", "labels of vertices, {} their distances", "and", {"distances"}, {"surface"}),
    ("libgvd/c/include/gvd/gvd.h", "Writes the mesh in the format of the extension: {}. */", "or", {"surface"}, set()),
]


def describe(bin_folder):
    done = subprocess.run([f"{bin_folder}/gvd-segment", "--print-options"], stdout=subprocess.PIPE, check=True)
    return json.loads(done.stdout)["formats"]


def carries(entry, *contents):
    return any(content in entry["carries"] for content in contents)


def rows(page, *headings):
    """The number and the cells of each row of the table with these first headings."""
    inside = found = False
    for number, line in enumerate((ROOT / page).read_text().split("\n"), 1):
        cells = [cell.strip() for cell in re.split(r"(?<!\\)\|", line)[1:-1]]
        if cells[:len(headings)] == list(headings):
            inside = found = True
        elif not line.startswith("|"):
            inside = False
        elif inside and not line.startswith("|---"):
            yield number, cells
    if not found:
        raise SystemExit(f"{page}: no table begins with the columns {', '.join(headings)}")


def extensions_in(cell):
    return re.findall(r"\.([a-z]+(?:\.[a-z]+)?)", cell)


def check_names(page, wanted, listed):
    """Each extension that is wanted must be listed, and no other."""
    findings = [f"{page}: the table lacks .{name}" for name in wanted if name not in listed]
    return findings + [f"{page}: the table has .{name}, which is no such format" for name in listed if name not in wanted]


def check_outputs(formats):
    """What each format holds, by the cells of its row."""
    page = "docs/guide/formats.md"
    by_name = {name: entry for entry in formats if entry["is_written"] for name in entry["extensions"]}
    listed, findings = [], []
    for number, cells in rows(page, "extension", "opens in", "geometry"):
        names = extensions_in(cells[0])
        listed += names
        entry = by_name.get(names[0])
        if entry is None or carries(entry, "diagram"):  # a diagram has all of it in its own way
            continue
        geometry = "" if not carries(entry, "surface") else "doubles" if carries(entry, "doubles") else "32-bit floats"
        expected = [geometry, carries(entry, "face labels", "vertex labels", "colours"), carries(entry, "distances"), carries(entry, "curves")]
        found = [re.sub(" as text$", "", cells[2]), *(bool(cell) for cell in cells[3:6])]
        if found != expected:
            findings.append(f"{page}:{number}: the row has {found}, and .{names[0]} carries {', '.join(entry['carries'])}")
    meshes = [name for entry in formats if carries(entry, "surface", "vertex labels", "distances", "diagram") and entry["is_written"]
              for name in entry["extensions"]]
    return findings + check_names(page, meshes, listed)


def check_inputs(formats):
    page = "docs/guide/input.md"
    first_cells = [cells[0] for _, cells in rows(page, "extension", "what is read")]
    read = [entry for entry in formats if entry["is_read"]]
    findings = []
    for entry in read:
        # The last extension stands for all; formats whose files are called anything have the name of their program.
        is_anything = not entry["extensions"] or entry["input_extensions"]
        name = entry["title"] if is_anything else "." + entry["extensions"][-1]
        if not any(re.search(rf"(?<![\w.]){re.escape(name)}(?![\w.])", cell) for cell in first_cells):
            findings.append(f"{page}: the table of formats lacks {name}")
    for path in (page, "README.md"):
        text = (ROOT / path).read_text()
        for entry in read:
            if not re.search(rf"\b(an|is)\b[^.]*\b{re.escape(entry['title'])}\b[^.]* (file|mesh)", text):
                findings.append(f"{path}: the sentence on INPUT does not name {entry['title']}")
    return findings


def check_distances(formats):
    page = "docs/guide/distance.md"
    listed = [name for _, cells in rows(page, "`-o`", "content") for name in extensions_in(cells[0])]
    contents = ["distances", "rows of distances", "distances of targets", "paths", "isolines", "curves"]
    return check_names(page, [entry["extensions"][0] for entry in formats if entry["is_written"] and carries(entry, *contents)], listed)


def check_sentences(formats):
    findings = []
    for page, sentence, last, some, none in SENTENCES:
        named = [entry for entry in formats if entry["is_written"] and carries(entry, *some) and not carries(entry, *none)]
        names = [name for entry in named for name in entry["extensions"][:None if "{all}" in sentence else 1]]
        form = {".md": "`.{}`", ".py": ".{}", ".h": "{}"}[pathlib.Path(page).suffix]
        names = [form.format(name) for name in names]
        listed = names[0] if len(names) == 1 else f"{', '.join(names[:-1])} {last} {names[-1]}"
        wanted = sentence.format(listed, all=listed)
        if wanted not in " ".join((ROOT / page).read_text().split()):
            findings.append(f"{page}: should say: {wanted}")
    return findings


def main():
    formats = describe(sys.argv[1])
    findings = check_outputs(formats) + check_inputs(formats) + check_distances(formats) + check_sentences(formats)
    for finding in findings:
        print(finding)
    return 1 if findings else 0


if __name__ == "__main__":
    sys.exit(main())
