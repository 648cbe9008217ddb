#!/usr/bin/env python3
"""Checks examples/cohort on small meshes.

    check_cohort.py steps BIN_FOLDER WORK_FOLDER       its steps and what it gathers, without Snakemake
    check_cohort.py workflow BIN_FOLDER WORK_FOLDER    the workflow: the same results, also after it was killed

Needs the Python package gvd, as in PYTHONPATH=build/python. Exits with 77 where snakemake is missing for the workflow.
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
MESHES = {"torus.ply": "torus.ply", "plate.stl": "plate.stl", "it's open.off": "half_sphere.off", "seam.obj": None}
# No mesh, and a closed surface with one side: each step refuses them.
REFUSED = {"bad.off": (3, "bad.off:1: ", "no mesh\n"),
           "one side.off": (4, "only one side", """OFF
6 10 0
0 0 3\n2 0 0\n1 2 0\n-1 2 1\n-2 0 0\n0 -2 0
3 0 1 2\n3 0 2 3\n3 0 3 4\n3 0 4 5\n3 0 5 1\n3 1 2 4\n3 2 3 5\n3 3 4 1\n3 4 5 2\n3 5 1 3
""")}
STEPS = "segment", "relax", "remesh"


def find_python():
    """A Python with the package gvd: Debian's need not be the first one."""
    for python in (sys.executable, "/usr/bin/python3"):
        if subprocess.run([python, "-c", "import gvd"], stderr=subprocess.DEVNULL).returncode == 0:
            return python
    sys.exit("no Python finds the package gvd: run make python, and set PYTHONPATH to build/python")


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


def read_rows(folder):
    with (folder / "cohort.csv").open() as file:
        return list(csv.DictReader(file))


def check_results(folder, left_out=()):
    rows = read_rows(folder)
    expect([(row["mesh"], row["step"]) for row in rows] ==
           [(mesh, step) for mesh in sorted([*MESHES, *REFUSED, *left_out]) for step in STEPS], "a row for each step")
    page = (folder / "cohort.html").read_text()
    for mesh, (exit_code, error, _) in REFUSED.items():
        bad = [row for row in rows if row["mesh"] == mesh]
        expect([row["exit_code"] for row in bad] == [str(exit_code), str(exit_code), ""] and error in bad[0]["error"], f"rows of {mesh}")
        expect(error in page, f"the error of {mesh} on the page")
    expect(all(row["exit_code"] == "0" and row["input.area"] and not row["error"] for row in rows if row["mesh"] in MESHES),
           "rows of good meshes")
    links = re.findall(r'<a href="([^"]+)"><img alt="[^"]+" src="data:image/png;base64,[^"]{1000,}">', page)
    expect(len(links) == 3 * len(MESHES) and "it%27s%20open.off/remesh/page.html" in links, "a picture for each result")
    expect(f"{len(MESHES)} done, {len(REFUSED) + len(left_out)} with errors" in page, "numbers on the page")


def kill_midway(call, folder):
    """Kills the workflow and all that it has started as soon as some step is done, and some is not."""
    process = subprocess.Popen(call, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, start_new_session=True)
    while process.poll() is None and not list(folder.glob("*/*/thumbnail.png")):
        time.sleep(0.01)
    os.killpg(process.pid, signal.SIGKILL)
    process.wait()
    expect(not (folder / "cohort.csv").exists(), "killed before its end")


def check_costs(work):
    sys.path.insert(0, str(EXAMPLE))
    import cost
    counts = {"torus.ply": 1600, "plate.stl": 672, "half_sphere.off": 656}
    expect({name: cost.estimate_faces(ROOT / "data" / name) for name in counts} == counts, "faces by the start of a file")
    damaged = work / "damaged.ply"
    damaged.write_text("ply\nelement face 99999999999999\n")
    expect(cost.estimate_faces(damaged) < 10, "a file has no more faces than its bytes")
    expect(cost.estimate_faces(damaged.with_name("none.ply")) == 0, "a file that is not there")
    expect(5876 <= cost.estimate_faces(ROOT / "data/figure.obj") < 4 * 5876, "faces by the bytes of a file")
    expect(cost.megabytes("relax", ROOT / "data/torus.ply", 60, 2) > cost.megabytes("relax", ROOT / "data/torus.ply", 60), "more memory")


def seam():
    """A grid of 8 x 8 squares whose texture has a seam in the middle: .ply has it as a list for each face."""
    lines = [f"v {x} {y} {x * y / 16}" for x in range(9) for y in range(9)]
    lines += [f"vt {x / 8 + side / 2} {y / 8}" for side in (0, 1) for x in range(5) for y in range(9)]
    for x in range(8):
        for y in range(8):
            corners = [(x, y), (x + 1, y), (x + 1, y + 1), (x, y + 1)]
            lines.append("f " + " ".join(f"{9 * a + b + 1}/{45 * (x // 4) + 9 * (a - 4 * (x // 4)) + b + 1}" for a, b in corners))
    return "\n".join(lines) + "\n"


def make_meshes(work):
    shutil.rmtree(work, ignore_errors=True)
    (work / "meshes").mkdir(parents=True)
    for name, source in MESHES.items():
        if source:
            shutil.copy(ROOT / "data" / source, work / "meshes" / name)
    (work / "meshes/seam.obj").write_text(seam())
    for name, (_, _, text) in REFUSED.items():
        (work / "meshes" / name).write_text(text)


def check_steps(python, bin_folder, work):
    """Runs the steps as the workflow does."""
    folder, meshes = work / "steps", sorted([*MESHES, *REFUSED])
    for mesh in meshes:
        def step(name, *call, folder=folder / mesh):
            run([python, EXAMPLE / "step.py", folder / name, "500", "1", *call[:-1], f"{bin_folder}/gvd-{call[-1][0]}",
                 work / "meshes" / mesh, *call[-1][1:], "--threads", "1"])
        step("segment", "--", ("segment", "-n", "9"))
        step("relax", "--", ("lloyd", "-n", "60"))
        step("remesh", "--after", folder / mesh / "relax", "--", ("remesh", "--generators", folder / mesh / "relax/report.json"))
    gather(python, folder, meshes)
    check_results(folder)
    check_failures(python, folder, meshes)


def gather(python, folder, meshes, left_out="{}"):
    run([python, "-c", "import os, sys; sys.path.insert(0, sys.argv[1]); os.chdir(sys.argv[2]); import gather; "
         f"gather.gather(sys.argv[3:], {STEPS!r}, 'cohort.csv', 'cohort.html', {left_out})", EXAMPLE, folder, *meshes])


def check_failures(python, folder, meshes):
    """Whatever is missing or damaged has an error in its row, and the other meshes have theirs."""
    def fail(name, *command, attempt="1"):
        subprocess.run([python, EXAMPLE / "step.py", folder / name, "500", attempt, "--", *command], stderr=subprocess.DEVNULL)
    shutil.rmtree(folder / "plate.stl/segment")  # as Snakemake does with the folder of a step that failed
    fail("plate.stl/segment", "sh", "-c", "echo 'x: error: disk full' >&2; exit 6", attempt="3")
    shutil.rmtree(folder / "plate.stl/segment")
    shutil.rmtree(folder / "plate.stl/relax")  # its job was killed
    (folder / "plate.stl/remesh/report.json").write_text('{"results"')
    (folder / "seam.obj/segment/mesh.ply").write_text("ply\n")
    run([python, "-c", "import pathlib, sys; sys.path.insert(0, sys.argv[1]); import step; "
         "step.draw_picture(pathlib.Path(sys.argv[2]), 'y')", EXAMPLE, folder / "seam.obj/segment"])
    (folder / "seam.obj/segment/thumbnail.png").unlink()
    fail("torus.ply/relax", "sh", "-c", "kill -SEGV $$", attempt="3")
    gather(python, folder, meshes, "{'a{b}.off': 'rename the file'}")
    errors = {(row["mesh"], row["step"]): row["error"] for row in read_rows(folder) if row["error"] and row["mesh"] not in REFUSED}
    expected = {("a{b}.off", "segment"): "rename the file", ("a{b}.off", "relax"): "rename the file",
                ("a{b}.off", "remesh"): "rename the file", ("plate.stl", "segment"): "x: error: disk full",
                ("plate.stl", "relax"): "no result (FileNotFoundError)", ("plate.stl", "remesh"): "no result (JSONDecodeError)",
                ("seam.obj", "segment"): "no picture: Error: ", ("torus.ply", "relax"): "crashed or was killed (SIGSEGV)"}
    expect(errors.keys() == expected.keys() and all(expected[step] in errors[step] for step in errors), f"errors: {errors}")
    page = (folder / "cohort.html").read_text()
    expect(all(error in page for error in expected.values()), "errors on the page")
    expect('<a href="seam.obj/segment/page.html">segment: 9 cells</a>' in page, "a result without a picture is on the page")


def check_tries(python, work):
    """What may end otherwise on another try fails; a mesh that is refused, and too little memory on the last try, are results."""
    for exit_code, message, attempt, is_result in ((5, "out of memory: 1", 1, False), (5, "out of memory: 1", 3, True),
                                                   (4, "two are equal", 1, True), (6, "disk full", 3, False),
                                                   (139, "crash", 2, False), (139, "crash", 3, True), (130, "stop", 3, False)):
        folder = work / f"try-{exit_code}-{attempt}"
        done = subprocess.run([python, EXAMPLE / "step.py", folder, "9", str(attempt), "--", "sh", "-c",
                               f"echo 'x: error: {message}' >&2; exit {exit_code}"], stderr=subprocess.DEVNULL)
        recorded = (folder / "error.json").read_text() if (folder / "error.json").exists() else ""
        expect(done.returncode == (0 if is_result else exit_code) and (message in recorded) == is_result, f"{message}, try {attempt}")


def check_failed_jobs(bin_folder, work):
    """A step that fails on all tries has a row with its reason, and the next call makes up for it."""
    (work / "bin").mkdir()
    for name in ("gvd-lloyd", "gvd-remesh"):
        (work / "bin" / name).symlink_to(bin_folder / name)
    segment = work / "bin/gvd-segment"
    segment.write_text(f"#!/bin/sh\ncase \"$1\" in *plate.stl) echo 'gvd-segment: error: disk full' >&2; exit 6;; esac\n"
                       f"exec {bin_folder}/gvd-segment \"$@\"\n")
    segment.chmod(0o755)
    done = subprocess.run(command(work, work / "bin", "failed"), stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    expect(done.returncode != 0, "a workflow with a failed job fails")
    rows = {(row["mesh"], row["step"]): row for row in read_rows(work / "failed")}
    expect("disk full" in rows["plate.stl", "segment"]["error"] and rows["plate.stl", "remesh"]["exit_code"] == "0", "its row")
    expect(all(rows[mesh, step]["exit_code"] == "0" for mesh in MESHES if mesh != "plate.stl" for step in STEPS), "other rows")
    run(command(work, bin_folder, "failed"))
    check_results(work / "failed", ["a{b}.off", "nowhere.off"])


def check_workflow(python, bin_folder, work):
    compare = [python, ROOT / "tests/cohort/compare.py"]
    whole, killed = command(work, bin_folder, "whole"), command(work, bin_folder, "killed")
    (work / "meshes/a{b}.off").write_text("no mesh\n")
    (work / "meshes/nowhere.off").symlink_to("none.off")
    run(whole)
    check_results(work / "whole", ["a{b}.off", "nowhere.off"])
    expect("Nothing to be done" in run(whole), "a run that is done")
    check_failed_jobs(bin_folder, work)
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
    if task == "workflow" and not shutil.which("snakemake"):
        print("skipped: install Debian's snakemake (scripts/install-deps.sh cohort)")
        return 77
    os.environ["PYTHONDONTWRITEBYTECODE"] = "1"
    make_meshes(work)
    if task == "workflow":
        check_workflow(python, bin_folder, work)
    else:
        check_costs(work)
        check_tries(python, work)
        check_steps(python, bin_folder, work)
    return 0


if __name__ == "__main__":
    sys.exit(main())
