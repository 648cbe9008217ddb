#!/usr/bin/env python3
"""Checks that scripts/plot_energies.py draws one named curve for each report: check_plot_energies.py SCRIPT FOLDER."""
import json
import pathlib
import subprocess
import sys
import xml.etree.ElementTree as ElementTree

script, folder = sys.argv[1], pathlib.Path(sys.argv[2])
folder.mkdir(parents=True, exist_ok=True)
runs = {"lbfgs": [2.0, 1.1, 1.0, 1.0], "none": [2.0, 1.5, 1.2, 1.1, 1.05]}
for name, energies in runs.items():
    (folder / f"{name}.json").write_text(json.dumps({"options": {"accelerate": name}, "results": {"energies": energies}}))
output = folder / "energies.svg"
subprocess.run([sys.executable, script, output, *(folder / f"{name}.json" for name in runs)], check=True)

root = ElementTree.parse(output).getroot()
svg = "{http://www.w3.org/2000/svg}"
curves = [[tuple(map(float, p.split(","))) for p in c.get("points").split()] for c in root.iter(svg + "polyline")]
texts = [text.text for text in root.iter(svg + "text")]
assert [len(points) for points in curves] == [3, 5], curves  # a curve ends where it leaves the picture
assert all(name in texts for name in runs), texts
for points in curves:
    assert points == sorted(points), "iterations go to the right"
    assert [y for _, y in points] == sorted(y for _, y in points), "lower energies are lower"
assert curves[0][0] == curves[1][0], "equal energies are in the same place"
