#!/usr/bin/env python3
"""Counts the instructions of runs that cover the three commands, and compares them with the figures of bench/instructions.tsv.

    scripts/count_instructions.py BIN_FOLDER                    fails if a figure is more than 2 % up
    scripts/count_instructions.py BIN_FOLDER --write "REASON"   writes the figures that are more than 2 % up, and all that are down

A figure is all instructions of a run, or those of some functions with everything that they call, by valgrind's callgrind. Two
runs differ by a millionth. Figures that are at most 2 % up are not written, so that small rises add up until one fails.

Counts depend on compiler and system, so the figures name theirs. On another one nothing is compared, and the exit code is 77;
--write then writes every figure.
"""
import argparse
import concurrent.futures
import os
import pathlib
import platform
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
FIGURES_FILE = ROOT / "bench/instructions.tsv"
TOLERANCE = 0.02
# A figure that is down by less is as before: a hundred times what repeated runs differ by.
NOISE = 1e-4
NOT_COMPARABLE = 77

# `data` is that of the repository. The bench computes two diagrams of each mesh. The larger of its meshes is propagated in three
# partitions, those of the commands in one.
RUNS = {
    "diagram": "gvd-bench --method exact -m 30 --runs 1 --refine 1 data/figure.obj",
    "regions": "gvd-segment data/figure.obj -n 100 --method gbgvd -o regions.ply",
    "cut": "gvd-segment data/figure.obj -n 100 --cut -o cut.ply -o cut.obj",
    "lloyd": "gvd-lloyd data/figure.obj -n 100 --iterations 34 -o relaxed.txt",
    "plain lloyd": "gvd-lloyd data/figure.obj -n 30 --accelerate none --iterations 3 -o relaxed.txt",
    "remesh": "gvd-remesh data/figure.obj -n 300 -o coarse.obj",
    "repair": "gvd-remesh data/figure.obj -n 60 --relax none -o coarse.obj",
    "features": "gvd-remesh data/plate.stl -n 40 --features 40 -o coarse.obj",
}
# For each figure its run, and the functions that it adds up; none: everything.
FIGURES = {
    "reading": ("regions", ["read_soup", "build_mesh"]),
    "sampling": ("regions", ["sample_generators"]),
    "distances": ("diagram", ["propagate_windows"]),
    "tracing": ("diagram", ["trace_connected"]),
    "exact diagram": ("diagram", ["compute_diagram"]),
    "gbgvd diagram": ("regions", ["compute_diagram"]),
    "labels": ("regions", ["segment_faces"]),
    "cut": ("cut", ["cut_faces"]),
    "cut and write": ("cut", []),
    "Lloyd": ("lloyd", ["relax_generators"]),
    "plain Lloyd": ("plain lloyd", ["relax_generators"]),
    "remesh": ("remesh", []),
    "remesh with repair": ("repair", []),
    "remesh with features": ("features", []),
}
# The C library chooses its variants of functions by the processor. Without these abilities all processors have the same ones.
ABILITIES = "AVX,AVX2,AVX512F,AVX512VL,AVX512BW,BMI1,BMI2,ERMS,FMA,FMA4,FSRM,LZCNT,MOVBE,POPCNT,RTM,SSE4_1,SSE4_2,SSSE3"
HWCAPS = ",".join(f"-{ability}" for ability in ABILITIES.split(","))


def describe_build(bin_folder):
    """Compiler, flags and system."""
    build = bin_folder.parent
    cache = dict(re.findall(r"^(\w+):\w+=(.*)$", (build / "CMakeCache.txt").read_text(), re.M))
    compiler = next(build.glob("CMakeFiles/*/CMakeCXXCompiler.cmake")).read_text()
    name, version = (re.search(rf'CMAKE_CXX_COMPILER_{key} "(.*)"', compiler)[1] for key in ("ID", "VERSION"))
    kind = cache["CMAKE_BUILD_TYPE"]
    flags = " ".join(f"{cache['CMAKE_CXX_FLAGS']} {cache['CMAKE_CXX_FLAGS_' + kind.upper()]}".split())
    return f"{name} {version} {flags}, unity {cache['GVD_UNITY']}, {os.confstr('CS_GNU_LIBC_VERSION')}, {platform.machine()}"


def count_run(bin_folder, name):
    """The output of callgrind_annotate for a run: inclusive costs by function."""
    program, *arguments = RUNS[name].split()
    options = [] if program == "gvd-bench" else ["--threads", "1", "-q"]
    environment = {"PATH": os.environ["PATH"], "LC_ALL": "C", "GLIBC_TUNABLES": f"glibc.cpu.hwcaps={HWCAPS}"}
    with tempfile.TemporaryDirectory() as folder:
        (pathlib.Path(folder) / "data").symlink_to(ROOT / "data")
        for line in (["valgrind", "-q", "--tool=callgrind", "--callgrind-out-file=costs", bin_folder / program, *arguments, *options],
                     ["callgrind_annotate", "--inclusive=yes", "--threshold=100", "costs"]):
            done = subprocess.run(line, cwd=folder, env=environment, text=True, capture_output=True)
            if done.returncode != 0:
                sys.exit(f"count_instructions.py: exit {done.returncode} of the run '{name}': {RUNS[name]}\n{done.stderr}")
    return done.stdout


def read_costs(annotated, functions):
    """Instructions of the named functions of namespace gvd, or of the program; of overloads that call each other, the largest."""
    total = 0
    for pattern in [rf":gvd::{function}\(" for function in functions] or [r"PROGRAM TOTALS"]:
        costs = [int(cost.replace(",", "")) for cost in re.findall(rf"^ *([0-9,]+) .*?{pattern}", annotated, re.M)]
        if not costs:
            sys.exit(f"count_instructions.py: nothing like '{pattern}' was called: FIGURES needs the function's new name")
        total += max(costs)
    return total


def measure(bin_folder, jobs):
    """Millions of instructions by figure. Each run is a process of its own, so several at a time do not change its count."""
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        annotated = dict(zip(RUNS, pool.map(lambda name: count_run(bin_folder, name), RUNS)))
    return {figure: read_costs(annotated[run], functions) / 1e6 for figure, (run, functions) in FIGURES.items()}


def read_figures(path):
    """The toolchain of the figures, and of each its millions and its reason."""
    if not path.exists():
        return "", {}
    lines = path.read_text().splitlines()
    rows = [line.split("\t") for line in lines if not line.startswith(("#", "figure\t"))]
    return lines[1].removeprefix("# "), {figure: (float(millions), reason) for figure, millions, reason in rows}


def is_up(old, new):
    return old is None or new > (1 + TOLERANCE) * old


def write_figures(path, toolchain, kept, measured, reason):
    """Keeps the rows of `kept` whose figures are neither more than the tolerance up nor down."""
    def row(figure, new):
        old = kept.get(figure, (None, ""))
        changed = is_up(old[0], new) or new < (1 - NOISE) * old[0]
        return f"{figure}\t{new:.3f}\t{reason}" if changed else f"{figure}\t{old[0]:.3f}\t{old[1]}"

    head = ["# Millions of instructions of the runs of scripts/count_instructions.py, and why each figure was last written, with:",
            f"# {toolchain}", "figure\tmillions\treason"]
    path.write_text("\n".join(head + [row(figure, new) for figure, new in measured.items()]) + "\n")


def print_table(old, measured):
    print(f"{'millions of instructions':<26} {'figure':>12} {'now':>12} {'change':>9}")
    for figure, new in measured.items():
        before = old.get(figure)
        shown, change = ("none", "") if before is None else (f"{before:,.3f}", f"{new / before - 1:+.2%}")
        print(f"{figure:<26} {shown:>12} {new:>12,.3f} {change:>9}{'  up' if is_up(before, new) else ''}")


def compare(old, measured):
    """Says what is to be done, and returns the exit code."""
    up = [figure for figure, new in measured.items() if is_up(old.get(figure), new)]
    down = [figure for figure, new in measured.items() if figure in old and new < (1 - TOLERANCE) * old[figure]]
    if down:
        print(f"more than {TOLERANCE:.0%} down, to be held by --write: {', '.join(down)}")
    if up:
        print(f"more than {TOLERANCE:.0%} up: {', '.join(up)}. A change that means it writes the figures with its reason: "
              'make count COUNT_FLAGS="--write REASON"')
    return 1 if up else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("bin_folder", type=pathlib.Path)
    parser.add_argument("--write", metavar="REASON", help="write the figures that have changed")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="runs at a time (default: all cores)")
    parser.add_argument("--figures", type=pathlib.Path, default=FIGURES_FILE, help=argparse.SUPPRESS)  # for its test
    given = parser.parse_args()
    bin_folder = given.bin_folder.resolve()
    valgrind = subprocess.check_output(["valgrind", "--version"], text=True).strip()
    toolchain = f"{describe_build(bin_folder)}, {valgrind}"
    known, rows = read_figures(given.figures)
    if known != toolchain and given.write is None:
        print(f"instructions NOT COMPARED, another toolchain:\n  figures: {known}\n  here:    {toolchain}")
        return NOT_COMPARABLE
    measured = measure(bin_folder, given.jobs)
    old = {figure: millions for figure, (millions, _) in rows.items()}
    print_table(old, measured)
    if given.write is None:
        return compare(old, measured)
    write_figures(given.figures, toolchain, rows if known == toolchain else {}, measured, given.write)
    return 0


if __name__ == "__main__":
    sys.exit(main())
