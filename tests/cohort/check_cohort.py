#!/usr/bin/env python3
"""Checks examples/cohort on small meshes.

    check_cohort.py steps BIN_FOLDER WORK_FOLDER       its steps and what it gathers, without Snakemake
    check_cohort.py workflow BIN_FOLDER WORK_FOLDER    the workflow: the same results, also after it was killed

Exits with 77 where numpy is missing, or snakemake for the workflow.
"""
import csv
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
EXAMPLE = ROOT / "examples/cohort"
MESHES = {"torus.ply": "torus.ply", "plate.stl": "plate.stl", "it's open.off": "half_sphere.off"}


def find_python():
    """A Python with numpy: Debian's need not be the first one."""
    for python in (sys.executable, "/usr/bin/python3"):
        if subprocess.run([python, "-c", "import numpy"], stderr=subprocess.DEVNULL).returncode == 0:
            return python
    return None


def command(work, bin_folder, results):
    return ["snakemake", "-s", EXAMPLE / "Snakefile", "--profile", EXAMPLE / "local", "-d", work / results, "--cores", "2", "--config",
            f"meshes={work / 'meshes'}", f"bin={bin_folder}", "regions=9", "generators=60", "threads=1"]


def run(call):
    done = subprocess.run(call, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if done.returncode:
        sys.exit(f"{call}: exit code {done.returncode}\n{done.stdout}")
    return done.stdout


def expect(holds, what):
    if not holds:
        sys.exit(f"failed: {what}")


def check_results(folder):
    rows = list(csv.DictReader((folder / "cohort.csv").open()))
    expect([(row["mesh"], row["step"]) for row in rows] ==
           [(mesh, step) for mesh in sorted([*MESHES, "bad.off"]) for step in ("segment", "relax", "remesh")], "a row for each step")
    bad = [row for row in rows if row["mesh"] == "bad.off"]
    expect([row["exit_code"] for row in bad] == ["3", "3", ""] and "bad.off:1: " in bad[0]["error"], "rows of a bad mesh")
    expect(all(row["exit_code"] == "0" and row["input.area"] for row in rows if row["mesh"] != "bad.off"), "rows of good meshes")
    page = (folder / "cohort.html").read_text()
    links = re.findall(r'<a href="([^"]+)"><img alt="[^"]+" src="data:image/png;base64,[^"]{2000,}">', page)
    expect(len(links) == 9 and "it%27s%20open.off/remesh/page.html" in links, "a picture for each result")
    expect("3 done, 1 with errors" in page and "bad.off:1: " in page, "the error on the page")


def kill_midway(call, folder):
    """Kills the workflow and all that it has started as soon as some step is done, and some is not."""
    process = subprocess.Popen(call, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, start_new_session=True)
    while process.poll() is None and not list(folder.glob("*/*/thumbnail.png")):
        time.sleep(0.01)
    os.killpg(process.pid, signal.SIGKILL)
    process.wait()
    expect(not (folder / "cohort.csv").exists(), "killed before its end")


def check_costs():
    sys.path.insert(0, str(EXAMPLE))
    import cost
    counts = {"torus.ply": 1600, "plate.stl": 672, "half_sphere.off": 656}
    expect({name: cost.estimate_faces(ROOT / "data" / name) for name in counts} == counts, "faces by the start of a file")
    expect(5876 <= cost.estimate_faces(ROOT / "data/figure.obj") < 4 * 5876, "faces by the bytes of a file")
    expect(cost.megabytes("relax", ROOT / "data/torus.ply", 60, 2) > cost.megabytes("relax", ROOT / "data/torus.ply", 60), "more memory")


def make_meshes(work):
    shutil.rmtree(work, ignore_errors=True)
    (work / "meshes").mkdir(parents=True)
    for name, source in MESHES.items():
        shutil.copy(ROOT / "data" / source, work / "meshes" / name)
    (work / "meshes/bad.off").write_text("no mesh\n")


def check_steps(python, bin_folder, work):
    """Runs the steps as the workflow does."""
    folder, meshes = work / "steps", sorted([*MESHES, "bad.off"])
    for mesh in meshes:
        def step(name, *call, folder=folder / mesh):
            run([python, EXAMPLE / "step.py", folder / name, "500", "1", *call[:-1], f"{bin_folder}/gvd-{call[-1][0]}",
                 work / "meshes" / mesh, *call[-1][1:], "--threads", "1"])
        step("segment", "--", ("segment", "-n", "9"))
        step("relax", "--", ("lloyd", "-n", "60"))
        step("remesh", "--after", folder / mesh / "relax", "--", ("remesh", "--generators", folder / mesh / "relax/report.json"))
    run([python, "-c", "import os, sys; sys.path.insert(0, sys.argv[1]); os.chdir(sys.argv[2]); import gather; "
         "gather.gather(sys.argv[3:], ['segment', 'relax', 'remesh'], 'cohort.csv', 'cohort.html')", EXAMPLE, folder, *meshes])
    check_results(folder)


def check_tries(python, work):
    """What may end otherwise on another try fails; a mesh that is refused, and too little memory on the last try, are results."""
    for exit_code, message, attempt, is_result in ((5, "out of memory: 1", 1, False), (5, "out of memory: 1", 3, True),
                                                   (4, "two are equal", 1, True), (6, "disk full", 3, False)):
        folder = work / f"try-{exit_code}-{attempt}"
        done = subprocess.run([python, EXAMPLE / "step.py", folder, "9", str(attempt), "--", "sh", "-c",
                               f"echo 'x: error: {message}' >&2; exit {exit_code}"], stderr=subprocess.DEVNULL)
        recorded = (folder / "error.json").read_text() if (folder / "error.json").exists() else ""
        expect(done.returncode == (0 if is_result else exit_code) and (message in recorded) == is_result, f"{message}, try {attempt}")


def check_workflow(python, bin_folder, work):
    compare = [python, ROOT / "tests/cohort/compare.py"]
    whole, killed = command(work, bin_folder, "whole"), command(work, bin_folder, "killed")
    run(whole)
    check_results(work / "whole")
    expect("Nothing to be done" in run(whole), "a run that is done")
    planned = run([word.replace("regions=9", "regions=8") for word in map(str, whole)] + ["-n", "-q"])
    expect("segment" in planned and "relax" not in planned, "another number of regions changes its step")
    kill_midway(killed, work / "killed")
    run([*killed, "--unlock"])
    run(killed)
    print(run([*compare, work / "whole", work / "killed"]))
    (work / "killed/torus.ply/remesh/mesh.ply").write_bytes(b"")
    expect(subprocess.run([*compare, work / "whole", work / "killed"], stdout=subprocess.DEVNULL).returncode == 1, "a half file is seen")


def main():
    task, bin_folder, work = sys.argv[1], pathlib.Path(sys.argv[2]).resolve(), pathlib.Path(sys.argv[3]).resolve()
    python = find_python()
    if python is None or (task == "workflow" and not shutil.which("snakemake")):
        print("skipped: install Debian's snakemake and python3-numpy (scripts/install-deps.sh cohort)")
        return 77
    os.environ["PYTHONDONTWRITEBYTECODE"] = "1"
    make_meshes(work)
    if task == "workflow":
        check_workflow(python, bin_folder, work)
    else:
        check_costs()
        check_tries(python, work)
        check_steps(python, bin_folder, work)
    return 0


if __name__ == "__main__":
    sys.exit(main())
