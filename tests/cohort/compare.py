#!/usr/bin/env python3
"""Fails unless two folders of results of examples/cohort have the same files with the same bytes, but for times and memory.

    compare.py FOLDER FOLDER
"""
import csv
import io
import json
import pathlib
import sys


def content(path):
    """The bytes of a file; without the members and columns that tell times and memory."""
    if path.name == "report.json":
        report = json.loads(path.read_text())
        for varies in ("timings_ms", "peak_memory_bytes"):
            del report[varies]
        for output in ("output", "report", "view", "max_memory", "generators"):  # names of files, and the memory of a further try
            report["options"].pop(output)
        return report
    if path.name == "cohort.csv":
        rows = list(csv.DictReader(io.StringIO(path.read_text())))
        return [{k: v for k, v in row.items() if k not in ("peak_memory_bytes", "milliseconds")} for row in rows]
    return path.read_bytes()


def contents(folder):
    return {str(path.relative_to(folder)): content(path) for path in sorted(pathlib.Path(folder).rglob("*"))
            if path.is_file() and ".snakemake" not in str(path.relative_to(folder)) and path.parent.name != "slurm"}


first, second = map(contents, sys.argv[1:3])
differing = [name for name in sorted(first.keys() | second.keys()) if first.get(name) != second.get(name)]
print(f"{len(first)} files" + "".join(f"\ndiffers: {name}" for name in differing))
sys.exit(1 if differing or not first else 0)
