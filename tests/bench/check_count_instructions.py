#!/usr/bin/env python3
"""The guard of instruction counts fires: check_count_instructions.py SCRIPT FOLDER. Made-up counts take the place of valgrind's."""
import os
import pathlib
import shutil
import subprocess
import sys

script, folder = sys.argv[1], pathlib.Path(sys.argv[2])
shutil.rmtree(folder, ignore_errors=True)
figures = folder / "figures.tsv"
FUNCTIONS = ["read_soup", "build_mesh", "sample_generators", "propagate_windows", "trace_connected", "compute_diagram", "segment_faces",
             "cut_faces", "relax_generators"]


def write_program(name, text):
    (folder / "programs").mkdir(parents=True, exist_ok=True)
    (folder / "programs" / name).write_text(f"#!/bin/sh\n{text}\n")
    (folder / "programs" / name).chmod(0o755)


def set_costs(**changed):
    """Every function costs 50 million instructions, a program 100 million, apart from what is `changed`."""
    costs = {"PROGRAM TOTALS": 100_000_000, **{name: 50_000_000 for name in FUNCTIONS}, **changed}
    lines = []
    for name, cost in costs.items():
        # An overload that the largest one calls, and one of its lambdas, are not added to it.
        entries = [(cost, name)] if name.startswith("PROGRAM") else [
            (cost, f"???:gvd::{name}(gvd::Mesh const&) [gvd]"), (cost // 2, f"???:gvd::{name}(gvd::Mesh const&)::{{lambda()#1}} [gvd]")]
        lines += [f"{value:>12,} (50.00%)  {entry}" for value, entry in entries if cost]
    write_program("callgrind_annotate", "cat <<'END'\n" + "\n".join(lines) + "\nEND")


def set_toolchain(compiler):
    (folder / "build/CMakeFiles/3").mkdir(parents=True, exist_ok=True)
    (folder / "build/CMakeFiles/3/CMakeCXXCompiler.cmake").write_text(
        f'set(CMAKE_CXX_COMPILER_ID "GNU")\nset(CMAKE_CXX_COMPILER_VERSION "{compiler}")\n')
    (folder / "build/CMakeCache.txt").write_text("CMAKE_BUILD_TYPE:STRING=Release\nCMAKE_CXX_FLAGS:STRING=\n"
                                                 "CMAKE_CXX_FLAGS_RELEASE:STRING=-O3\nGVD_UNITY:STRING=ON\n")


def run(*arguments):
    environment = dict(os.environ, PATH=f"{folder.resolve() / 'programs'}:{os.environ['PATH']}")
    done = subprocess.run([sys.executable, script, folder / "build/bin", "--figures", figures, *arguments], env=environment, text=True,
                          capture_output=True)
    return done.returncode, done.stdout + done.stderr


def row(figure):
    return next(line.split("\t")[1:] for line in figures.read_text().splitlines() if line.startswith(figure + "\t"))


def expect(code, *words):
    got, text = run()
    assert got == code and all(word in text for word in words), (got, text)


write_program("valgrind", "echo valgrind-1.0")
set_toolchain("12.2.0")
set_costs()
assert run("--write", "first")[0] == 0
assert row("distances") == ["50.000", "first"] and row("reading") == ["100.000", "first"] and row("remesh") == ["100.000", "first"]
expect(0, "+0.00%")

set_costs(propagate_windows=51_500_000)  # 3 % up
expect(1, "+3.00%", "more than 2% up: distances.")
set_costs(**{"PROGRAM TOTALS": 103_000_000})
expect(1, "more than 2% up: cut and write, remesh, remesh with repair, remesh with features.")

# A small rise passes, and is not written, so that the next one adds to it.
set_costs(propagate_windows=50_900_000)
expect(0, "+1.80%")
assert run("--write", "other")[0] == 0 and row("distances") == ["50.000", "first"]
set_costs(propagate_windows=51_100_000)
expect(1, "+2.20%")
assert run("--write", "straighter arcs")[0] == 0
assert row("distances") == ["51.100", "straighter arcs"] and row("tracing") == ["50.000", "first"]
expect(0)

set_costs(propagate_windows=48_000_000)
expect(0, "more than 2% down, to be held by --write: distances")
assert run("--write", "faster")[0] == 0 and row("distances") == ["48.000", "faster"]

set_costs(propagate_windows=0)  # renamed or inlined
expect(1, "FIGURES needs the function's new name")
set_costs()
write_program("valgrind", 'test "$1" = --version && echo valgrind-1.0')  # each run fails
expect(1, "exit 1 of the run")
write_program("valgrind", "echo valgrind-1.0")

set_toolchain("13.1.0")
expect(77, "NOT COMPARED", "GNU 12.2.0", "GNU 13.1.0")
assert run("--write", "compiler")[0] == 0 and row("tracing") == ["50.000", "compiler"]

# A figure that the file does not have yet fails, too.
figures.write_text("".join(line for line in figures.read_text().splitlines(True) if not line.startswith("cut\t")))
expect(1, "more than 2% up: cut.")
