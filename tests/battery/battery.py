#!/usr/bin/env python3
"""Runs the commands on hostile meshes and checks what they write: battery.py BIN_FOLDER WORK_FOLDER [options]

    --few            the part that CI runs: two seeds, of each mesh the cases marked so
    --seeds A:B      seeds A to B - 1 of the cases and the random meshes (default 1:4)
    --corpus FOLDER  the meshes of a folder too, those of at most --most-faces faces (20000)
    --only TEXT      meshes whose name holds this text only
    --jobs N         processes at a time (2)

Exits with 1 where something is found. WORK_FOLDER/findings has the input and the command of each finding.
"""
import argparse
import concurrent.futures
import pathlib
import shutil
import sys
import tempfile
import time
import traceback

sys.dont_write_bytecode = True  # the sources' folder stays as it is

from cases import cases, fixed_cases, repaired_surface, run_case
from corpus import corpus_meshes
from meshes import families
from surface import Finding


def options():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("bin_folder", type=pathlib.Path)
    parser.add_argument("work_folder", type=pathlib.Path)
    parser.add_argument("--few", action="store_true")
    parser.add_argument("--seeds", default="1:4")
    parser.add_argument("--corpus", type=pathlib.Path)
    parser.add_argument("--most-faces", type=int, default=20000)
    parser.add_argument("--only", default="")
    parser.add_argument("--jobs", type=int, default=2)
    return parser.parse_args()


class Outcome:
    """What came of the cases of one mesh: counts of exit codes, findings, and the costliest run."""

    def __init__(self, name):
        self.name, self.codes, self.findings = name, {}, []
        self.slowest, self.largest = (0.0, ""), (0.0, "")

    def count(self, case, ending):
        self.codes[ending.code] = self.codes.get(ending.code, 0) + 1
        self.slowest = max(self.slowest, (ending.seconds, f"{case} on {self.name}"))
        self.largest = max(self.largest, (ending.peak, f"{case} on {self.name}"))


def keep_finding(mesh, case, message, work_folder):
    """Saves the input and the command, and returns the line about them."""
    folder = work_folder / "findings"
    folder.mkdir(parents=True, exist_ok=True)
    mesh.write(folder / f"{mesh.name}.off")
    line = f"{mesh.name}.off, {case}: {message}"
    with open(folder / "findings.txt", "a") as listing:
        listing.write(line + "\n")
    return line


def run_mesh(job):
    """All cases of one mesh, in a process and a folder of its own."""
    mesh, seeds, chosen = job
    outcome = Outcome(mesh.name)
    listed = [*fixed_cases(mesh), *(case for seed in seeds for case in cases(mesh, seed))]
    case = "reading"
    with tempfile.TemporaryDirectory(dir=chosen.work_folder) as name:
        folder = pathlib.Path(name)
        mesh.write(folder / "in.off")
        try:
            surface = repaired_surface(mesh, chosen.bin_folder, folder)
        except Finding as finding:
            outcome.findings.append(keep_finding(mesh, case, str(finding), chosen.work_folder))
            return outcome
        for case in listed if surface is not None else []:
            if chosen.few and not case.few:
                continue
            for left in folder.glob("[or]*.*"):
                left.unlink()
            try:
                outcome.count(case, run_case(mesh, surface, case, chosen.bin_folder, folder))
            except Finding as finding:
                outcome.findings.append(keep_finding(mesh, case, str(finding), chosen.work_folder))
            except Exception:  # a file that can't be parsed is a finding too
                outcome.findings.append(keep_finding(mesh, case, traceback.format_exc(limit=2), chosen.work_folder))
    return outcome


def show(outcome):
    codes = ", ".join(f"{count} x exit {code}" for code, count in sorted(outcome.codes.items()))
    print(f"{outcome.name}: {codes or 'refused as it should be'}", flush=True)
    for finding in outcome.findings:
        print(f"  FINDING {finding}", flush=True)


def main():
    chosen = options()
    chosen.bin_folder = chosen.bin_folder.resolve()
    shutil.rmtree(chosen.work_folder / "findings", ignore_errors=True)
    chosen.work_folder.mkdir(parents=True, exist_ok=True)
    first, last = map(int, chosen.seeds.split(":"))
    seeds = [first, first + 1] if chosen.few else list(range(first, last))
    meshes = list(families(seeds)) + (corpus_meshes(chosen.corpus, chosen.most_faces) if chosen.corpus else [])
    jobs = [(mesh, seeds, chosen) for mesh in meshes if chosen.only in mesh.name]
    start, outcomes = time.monotonic(), []
    with concurrent.futures.ProcessPoolExecutor(chosen.jobs) as pool:
        for outcome in pool.map(run_mesh, jobs):
            show(outcome)
            outcomes.append(outcome)
    runs = sum(sum(o.codes.values()) for o in outcomes)
    findings = sum(len(o.findings) for o in outcomes)
    for what, unit, (value, where) in [("slowest", "s", max(o.slowest for o in outcomes)),
                                       ("largest", "MB", max((o.largest[0] / 1e6, o.largest[1]) for o in outcomes))]:
        print(f"{what}: {value:.1f} {unit}: {where}")
    print(f"{len(outcomes)} meshes, {runs} runs checked in {time.monotonic() - start:.0f} s, {findings} findings")
    return 1 if findings else 0


if __name__ == "__main__":
    sys.exit(main())
