#!/usr/bin/env python3
"""scripts/make_performance.py fills every table of its page: check_make_performance.py REPOSITORY BIN_FOLDER FOLDER.

It works on a copy of the page, with a small mesh under the name of spot. All other meshes are missing.
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys

repository, bin_folder, folder = map(pathlib.Path, sys.argv[1:])
shutil.rmtree(folder, ignore_errors=True)
for name in ("scripts/make_performance.py", "scripts/figures.py", "scripts/count_instructions.py", "docs/developer/performance.md"):
    (folder / "copy" / name).parent.mkdir(parents=True, exist_ok=True)
    shutil.copy(repository / name, folder / "copy" / name)
models = folder / "models"
models.mkdir()
# Each face is cut in four five times, so that few faces are many.
subprocess.run([bin_folder / "gvd-remesh", repository / "data/half_sphere.off", "-n", "60", "-q", "-o", models / "spot.m30.obj"], check=True)
(models / "spot.m30.generators.txt").write_text("".join(f"{2 * k}\n" for k in range(30)))
faces = f"{4 ** 5 * sum(line.startswith('f ') for line in (models / 'spot.m30.obj').read_text().splitlines()):,}"

page = folder / "copy/docs/developer/performance.md"
page.write_text(re.sub(r"(<!-- measured: \w+ -->\n).*?(<!-- end -->)", r"\1stale\n\2", page.read_text(), flags=re.S))
before = page.read_text()
environment = dict(os.environ, GVD_MODELS=str(models.resolve()))
subprocess.run([sys.executable, folder / "copy/scripts/make_performance.py", bin_folder], env=environment, check=True)

text = page.read_text()
tables = dict(re.findall(r"<!-- measured: (\w+) -->\n\n(.*?)\n\n<!-- end -->", text, re.S))
rows = {name: sum(line.startswith("|") for line in content.splitlines()) - 2 for name, content in tables.items()}
refinements, tolerances = 5, 4
assert rows == {"machine": -2, "summary": 10, "diagrams": 2 + refinements, "cgal": 1, "threads": 1 + refinements, "marched": 3,
                "errors": 1, "large": 1, "writing": tolerances}, rows
assert "kitten_106k.obj" in tables["machine"] and "spot" not in tables["machine"], tables["machine"]
assert not re.search(r"\bnan\b|stale", text)
assert f"| {faces} |" in tables["large"] and f"| spot, each face cut into 1024 | {faces} | 50 |" in tables["threads"], tables["large"]
for line in (line for content in tables.values() for line in content.splitlines() if line.startswith("|")):
    assert "|  |" not in line or "gbgvd" in line, f"an empty cell: {line}"
# The text around the tables is as it was.
assert re.sub(r"(<!-- measured: \w+ -->\n).*?(<!-- end -->)", r"\1stale\n\2", text, flags=re.S) == before
