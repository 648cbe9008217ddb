#!/usr/bin/python3
"""Measures the rows of a distance matrix: exact distances from many generators to every vertex, with all cores.

    PYTHONPATH=build/python bench/distance_rows.py MESH [--generators 1000] [--rows N] [--out FILE.npy]

--rows measures the first N of the rows only, and the time of all is scaled from them. --out writes the rows to a memory-mapped
array. CGAL's exact paths for one row on the same mesh: `gvd-bench -m 1 --method exact --peers MESH`, the time in milliseconds is
the Dijkstra's times the column of the paths.
"""
import argparse
import resource
import time
import warnings

import numpy

import gvd


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("mesh")
    parser.add_argument("--generators", type=int, default=1000)
    parser.add_argument("--rows", type=int, help="default: all")
    parser.add_argument("--out")
    parser.add_argument("--threads", type=int, default=0)
    arguments = parser.parse_args()
    warnings.simplefilter("ignore")
    mesh = gvd.read(arguments.mesh)
    generators = mesh.farthest(arguments.generators)
    rows = arguments.rows or arguments.generators
    some = gvd.Points(generators.face[:rows], generators.bary[:rows])
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    started, processor = time.perf_counter(), time.process_time()
    if arguments.out:
        shape = (rows, len(mesh.vertices))
        matrix = numpy.lib.format.open_memmap(arguments.out, "w+", numpy.float32, shape)
        farthest = mesh.distances(some, each=True, out=matrix, threads=arguments.threads).max()
    else:
        farthest = max(row.max() for row in mesh.distance_rows(some, threads=arguments.threads))
    seconds, processor = time.perf_counter() - started, time.process_time() - processor
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    print(f"{len(mesh.vertices)} vertices, {len(mesh.faces)} faces; {rows} rows of {arguments.generators}: {seconds:.1f} s, "
          f"{processor / rows:.3f} s of processor time a row, {processor / seconds:.2f} cores busy; "
          f"all rows: {seconds / rows * arguments.generators:.0f} s")
    print(f"peak memory {peak / 1024:.0f} MB, {(peak - before) / 1024:.0f} MB more than before the rows; "
          f"the matrix has {8 * len(mesh.vertices) * arguments.generators / 2**20:.0f} MB; largest distance {farthest:.6g}")


if __name__ == "__main__":
    main()
