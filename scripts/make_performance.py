#!/usr/bin/env python3
"""Measures the tables of docs/developer/performance.md in one run, and writes them into the page.

    scripts/make_performance.py BIN_FOLDER      of a build with the benchmarks and CGAL's GPL-licensed parts

A table stands between the lines `<!-- measured: TABLE -->` and `<!-- end -->`; the text around them is kept. Meshes are found as
scripts/figures.py tells. Rows of missing ones are left out, which the page then says. Takes about ten minutes and 4 GB.
"""
import functools
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import time

from count_instructions import describe_build
from figures import find_model

ROOT = pathlib.Path(__file__).resolve().parent.parent
PAGE = ROOT / "docs/developer/performance.md"

FILES = {"eight": "eight.m10.obj", "rotor": "rotor.m15.obj", "elephant": "elephant.m20.obj", "spot": "spot.m30.obj",
         "plate": "plate.m12.obj", "fandisk": "fandisk.obj", "kitten, 16k faces": "kitten_16k.obj", "lucy": "lucy.obj",
         "rocker arm": "rocker_arm.obj", "bear": "bear.m20.obj", "bunny, 28k faces": "bunny_28k.obj",
         "bunny": "bunny_69k_boundary.obj", "kitten": "kitten_106k.obj"}
# The runs of gvd-bench, and the meshes of each.
EXACT = ("-m 30 --runs 7 --threads 2 --method exact", ["spot", "bear", "lucy", "fandisk", "rocker arm", "bunny", "kitten"])
REFINED = ("-m 50 --runs 5 --threads 2 --method exact --refine 5 --save refined.ply", ["spot"])
MARCHED = ("-m 5,30,100 --runs 7 --method gbgvd", ["spot", "elephant", "lucy", "bear", "kitten"])
PEERS = ("-m 5,30 --runs 3 --method exact --peers", list(FILES))
DIAGRAM_ROW = re.compile(r"(\S.*?) +(\d+) +(\d+) (exact|gbgvd) +(.*)")
PEER_ROW = re.compile(r"(\S.*?) +\d+ +(\d+) +[\d.]+ \| +([\d.]+) +([\d.]+) +([\d.]+)")

COLUMNS = ["Dijkstra", "whole diagram", "distances", "bisectors", "growth", "cells", "bytes per face"]
WITH_GENERATORS = ["spot", "elephant", "eight", "rotor", "plate"]  # those of the reference, in a file beside the mesh
ERROR_FLAGS = {"exact, 1e-4 (default)": "", "exact, 1e-6": "--chord-tolerance 1e-6", "gbgvd, circle": "--method gbgvd",
               "gbgvd, planar": "--method gbgvd --front planar"}
LARGE_STEPS = ["read", "check", "generators", "diagram", "segment", "write"]


class Bench:
    """The programs, the meshes that were found, and the results of runs, each of which is made once."""

    def __init__(self, bin_folder, folder):
        self.bin_folder, self.folder, self.load = bin_folder, folder, os.getloadavg()[0]
        found = {name: find_model(file, folder) for name, file in FILES.items()}
        self.meshes = {name: path for name, path in found.items() if path}
        lists = {name: find_model(FILES[name].replace(".obj", ".generators.txt"), folder) for name in WITH_GENERATORS}
        self.generators = {name: path for name, path in lists.items() if path and name in self.meshes}
        self.missing = [FILES[name] for name in FILES if name not in self.meshes]

    def start(self, program, *arguments, **options):
        print(program, *arguments, file=sys.stderr)
        return subprocess.Popen([self.bin_folder / program, *arguments], cwd=self.folder, text=True, **options)

    @functools.cache
    def output(self, flags, names):
        process = self.start("gvd-bench", *flags.split(), "--", *(self.meshes[name] for name in names), stdout=subprocess.PIPE)
        text = process.communicate()[0]
        if process.returncode != 0:
            sys.exit("make_performance.py: gvd-bench failed")
        return text.splitlines()

    def lines(self, run, pattern):
        """The groups of each row of a run of gvd-bench, with the mesh's own name in place of its file's."""
        flags, names = run[0], tuple(name for name in run[1] if name in self.meshes)
        stems = {self.meshes[name].stem: name for name in names}
        for found in filter(None, map(pattern.fullmatch, self.output(flags, names) if names else [])):
            stem, _, level = found[1].partition(" /")
            yield [stems[stem] + (f", each face cut into {level}" if level else ""), *found.groups()[1:]]

    def diagrams(self, run):
        """Rows by mesh, faces, m, and numbers by column."""
        return [Row(mesh, int(faces), int(m), list(map(float, rest.replace("|", "").split())))
                for mesh, faces, m, _, rest in self.lines(run, DIAGRAM_ROW)]

    @functools.cache
    def segment(self, mesh, flags):
        """The report of gvd-segment, with its processor and wall-clock seconds. A relative mesh is one in the folder."""
        start = time.monotonic()
        process = self.start("gvd-segment", str(mesh), *flags.split(), "-q", "--report", "report.json")
        _, status, usage = os.wait4(process.pid, 0)
        if status != 0:
            sys.exit("make_performance.py: gvd-segment failed")
        report = json.loads((self.folder / "report.json").read_text())
        return dict(report, cpu=usage.ru_utime + usage.ru_stime, wall=time.monotonic() - start)


class Row:
    def __init__(self, mesh, faces, m, numbers):
        self.mesh, self.faces, self.m, self.numbers = mesh, faces, m, numbers
        self.diagram, self.distances, self.bytes = numbers[1], numbers[2], numbers[6]
        self.threads = numbers[7:]  # milliseconds of one and of two, and their ratio

    def head(self):
        return [self.mesh, f"{self.faces:,}", str(self.m)]

    def cells(self):
        dijkstra, diagram, *steps, size = self.numbers[:7]
        return [f"{dijkstra:.2f} ms", f"{diagram:.1f} x", *(f"{step:.1f}" for step in steps), f"{size:.0f}"]


def table(head, rows):
    return "\n".join(["| " + " | ".join(head) + " |", "|---" * len(head) + "|", *("| " + " | ".join(row) + " |" for row in rows)])


def commands(*runs):
    return "\n".join(f'    make bench BENCH_FLAGS="{flags} MESH ..."' for flags, _ in runs) + "\n\n"


def scientific(value):
    mantissa, exponent = f"{value:.1e}".split("e")
    return f"{mantissa}e{int(exponent)}"


def exact_rows(bench):
    return bench.diagrams(EXACT) + bench.diagrams(REFINED)[1:]


def peer_rows(bench):
    """For each mesh the row of 30 generators, CGAL's three times, and the ratios of the distances with 30 and with 5."""
    peers = {(mesh, int(m)): list(map(float, times)) for mesh, m, *times in bench.lines(PEERS, PEER_ROW)}
    rows = {(row.mesh, row.m): row for row in bench.diagrams(PEERS)}
    ratio = {key: peers[key][0] / row.distances for key, row in rows.items()}
    return [(row, *peers[mesh, m], ratio[mesh, 30], ratio[mesh, 5]) for (mesh, m), row in rows.items() if m == 30]


def errors(bench, name):
    """For each of ERROR_FLAGS E, and the mean and the maximum of the difference along the bisectors."""
    common = f"--generators {bench.generators[name]} --verify -o regions.ply"
    reports = [bench.segment(bench.meshes[name], f"{common} {flags}") for flags in ERROR_FLAGS.values()]
    return [[report["diagram"]["verify"][f"error_{kind}"] for kind in ("integral", "mean", "max")] for report in reports]


def large(bench):
    bench.diagrams(REFINED)  # writes the mesh
    return bench.segment("refined.ply", "-n 50 -o regions.ply")


def make_machine(bench):
    model = re.search(r"model name\s*: (.*)", pathlib.Path("/proc/cpuinfo").read_text())
    commit = subprocess.run(["git", "describe", "--always", "--dirty", "--abbrev=8"], cwd=ROOT, text=True, stdout=subprocess.PIPE).stdout
    missing = f" Rows of these missing meshes are left out: {', '.join(bench.missing)}." if bench.missing else ""
    return (f"Machine: {model[1] if model else 'unknown processor'}, {os.cpu_count()} cores, {bench.load:.1f} other processes at the\n"
            f"start; {describe_build(bench.bin_folder)}. Source: {commit.strip() or 'unknown'}.{missing}")


def make_diagrams(bench):
    marched = {row.mesh: row for row in bench.diagrams(MARCHED) if row.m == 30}
    rows = []
    for row in exact_rows(bench):
        rows.append([*row.head(), "exact", *row.cells()])
        rows += [["", "", "", "gbgvd", *marched[row.mesh].cells()]] if row.mesh in marched else []
    return commands(EXACT, REFINED) + table(["mesh", "faces", "m", "method", *COLUMNS], rows)


def make_marched(bench):
    return commands(MARCHED) + table(["mesh", "faces", "m", *COLUMNS], [[*row.head(), *row.cells()] for row in bench.diagrams(MARCHED)])


def make_cgal(bench):
    head = ["mesh", "faces", "exact distances here, m = 30", "`Surface_mesh_shortest_path` (exact)", "ratio", "with m = 5",
            "`Heat_method_3` (approximate), with factorisation", "a second solution"]
    rows = [[*row.head()[:2], f"{row.distances:.1f} x", f"{paths:.0f} x", f"{ratio:.1f}", f"{ratio_5:.1f}", f"{heat:.0f} x",
             f"{again:.1f} x"] for row, paths, heat, again, ratio, ratio_5 in peer_rows(bench)]
    return commands(PEERS) + table(head, rows)


def make_threads(bench):
    rows = [[*row.head(), "{:.1f} ms".format(row.threads[0]), "{:.1f} ms".format(row.threads[1]), "{:.2f} x".format(row.threads[2])]
            for row in exact_rows(bench)]
    return table(["mesh", "faces", "m", "one thread", "two threads", "ratio"], rows)


def make_errors(bench):
    rows = [[name, *(" / ".join(map(scientific, figures)) for figures in errors(bench, name))]
            for name in bench.generators]
    return table(["mesh", *ERROR_FLAGS], rows)


def make_writing(bench):
    rows = []
    for tolerance in ("1e-4", "1e-7", "1e-8", "1e-9") if "spot" in bench.meshes else ():
        report = bench.segment(bench.meshes["spot"], f"-n 30 --chord-tolerance {tolerance} --cut -o cut.ply --view page.html")
        seconds = [f"{report['timings_ms'][step] / 1e3:.2g} s" for step in ("cut", "write view")]
        rows.append([tolerance, f"{report['results']['faces']:,}", *seconds])
    return table(["chord tolerance", "faces after the cut", "`--cut`", "`--view`"], rows)


def make_large(bench):
    if "spot" not in bench.meshes:
        return ""
    report = large(bench)
    faces = report["input"]["faces"]
    row = [f"{faces:,}", f"{report['peak_memory_bytes'] / faces:.0f}", f"{report['cpu']:.1f} s", f"{report['wall']:.1f} s",
           *(f"{report['timings_ms'][step] / 1e3:.1f} s" for step in LARGE_STEPS)]
    return table(["faces", "bytes per face", "processor time", "in all", *(f"`{step}`" for step in LARGE_STEPS)], [row])


def measured(what, value, unit):
    digits = 1 if value < 100 else 0
    return [what, f"{value:.{digits}f} {unit}"]


def make_summary(bench):
    exact = {row.mesh: row for row in exact_rows(bench)}
    marched = {row.mesh: row for row in bench.diagrams(MARCHED) if row.m == 30}
    rows = []
    for row in (exact[name] for name in ("spot", "bunny") if name in exact):
        rows.append(measured(f"exact distances, {row.mesh}, one thread", row.distances, "x Dijkstra"))
        rows.append(measured(f"exact diagram, {row.mesh}, one thread", row.diagram, "x Dijkstra"))
    for row in (exact[name] for name in ["spot, each face cut into 256"] if name in exact):
        rows.append(measured(f"exact diagram, {row.mesh}", row.diagram, "x Dijkstra"))
        rows.append(measured("the same", row.bytes, "bytes per face"))
    rows += [measured(f"`gbgvd` with circles, {name}, m = 30", marched[name].diagram, "x Dijkstra")
             for name in ("spot", "bear", "kitten") if name in marched]
    ratios = {"two threads instead of one, above 50,000 faces": [row.threads[2] for row in exact.values() if row.faces > 50000],
              "CGAL's exact paths, in multiples of exact distances here": [x for row in peer_rows(bench) for x in row[-2:]]}
    rows += [[what, f"{min(values):.2f} to {max(values):.2f} x"] for what, values in ratios.items() if values]
    if "spot" in bench.generators:
        default, fine, circle, planar = errors(bench, "spot")
        rows.append(["E / length, exact, spot at the default tolerance; at 1e-6", f"{scientific(default[1])}; {scientific(fine[1])}"])
        rows.append(["E, `gbgvd` on spot, planar; circle", f"{planar[0]:.3f}; {circle[0]:.3f}"])
        report = large(bench)
        rows.append(measured(f"`gvd-segment -n 50` on {report['input']['faces']:,} faces", report["peak_memory_bytes"] / 2**30, "GiB"))
    return table(["quantity", "measured"], rows)


MAKERS = {"machine": make_machine, "summary": make_summary, "diagrams": make_diagrams, "cgal": make_cgal, "threads": make_threads,
          "marched": make_marched, "errors": make_errors, "large": make_large, "writing": make_writing}


def put(page, name, content):
    text, count = re.subn(rf"(<!-- measured: {name} -->\n).*?(<!-- end -->)", lambda found: f"{found[1]}\n{content}\n\n{found[2]}",
                          page, flags=re.S)
    if count != 1:
        sys.exit(f"make_performance.py: {count} places for the table '{name}' in {PAGE}")
    return text


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    page = PAGE.read_text()
    for name in MAKERS:
        put(page, name, "")  # before the work
    with tempfile.TemporaryDirectory() as folder:
        bench = Bench(pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(folder))
        for name, make in MAKERS.items():
            page = put(page, name, make(bench))
    PAGE.write_text(page)


if __name__ == "__main__":
    main()
