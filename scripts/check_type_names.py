#!/usr/bin/env python3
"""Fails if two files define a type of the same name in a namespace.

    scripts/check_type_names.py [FOLDER...]

Two definitions of one name break C++'s one-definition rule as soon as both reach one program: the linker keeps one copy of
each inline function and template that uses them, for both. Types in unnamed namespaces are apart, but a reader who searches for
a name should find one type. Types inside other types have the name of these before their own. In unnamed namespaces, `using` may
give a type of elsewhere the same short name in several files. The folders are libgvd, apps, python and web. Needs universal-ctags.
"""
import collections
import json
import subprocess
import sys

from tracked_files import ROOT, report, tracked

FOLDERS = ("libgvd", "apps", "python", "web")
TYPES = {"class", "struct", "union", "enum"}


def types_of(files):
    """(name, file, line) of the types that are defined in a namespace."""
    listed = subprocess.run(
        ["ctags", "--output-format=json", "--languages=C++", "--map-C++=+.hpp.cpp.h", "--c++-kinds=cgsut", "--fields=+nsK", "-L", "-"],
        input="".join(f"{f}\n" for f in files), check=True, capture_output=True, text=True).stdout
    for line in listed.splitlines():
        tag = json.loads(line)
        scope, inside = tag.get("scope", ""), tag.get("scopeKind")
        if tag.get("kind") in TYPES and inside == "namespace" or tag.get("kind") == "typedef" and scope == "gvd":
            yield tag["name"], tag["path"], tag["line"]


def main():
    folders = sys.argv[1:] or FOLDERS
    files = [path for path in tracked(*(f"{folder}/*" for folder in folders)) if path.suffix in {".hpp", ".cpp", ".h"}]
    places = collections.defaultdict(dict)
    for name, path, line in types_of(files):
        places[name].setdefault(path, line)
    findings = []
    for name, found in sorted(places.items()):
        if len(found) > 1:
            where = ", ".join(f"{path.removeprefix(str(ROOT) + '/')}:{line}" for path, line in sorted(found.items()))
            findings.append(f"{name} is defined more than once: {where}; rename one")
    return report(files, findings)


if __name__ == "__main__":
    sys.exit(main())
