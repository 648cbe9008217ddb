"""Curves as generators beside closed forms, and beside what the commands say."""
import json
import os
import pathlib
import subprocess
import tempfile
import unittest

import numpy

import gvd
import meshes

BIN = pathlib.Path(os.environ.get("GVD_BIN", meshes.ROOT / "build" / "bin")).resolve()


class Curves(unittest.TestCase):
    def test_in_the_plane_distances_are_those_from_segments(self):
        at, faces = meshes.make_grid(12)
        mesh = gvd.Mesh(at, faces)
        line = mesh.curves([[(0.11, 0.31, 0.0), (0.87, 0.31, 0.0)]])
        beside = numpy.maximum(numpy.maximum(0.11 - at[:, 0], at[:, 0] - 0.87), 0)
        expected = numpy.hypot(beside, at[:, 1] - 0.31)
        numpy.testing.assert_allclose(mesh.distances(line), expected, atol=1e-12)
        numpy.testing.assert_allclose(mesh.distances(line, to=mesh.points(at)), expected, atol=1e-12)

    def test_the_border_between_two_lines_lies_halfway(self):
        mesh = gvd.Mesh(*meshes.make_grid(8))
        lines = mesh.curves([[(0.0, 0.2, 0.0), (1.0, 0.2, 0.0)], [(0.0, 0.7, 0.0), (1.0, 0.7, 0.0)]])
        self.assertEqual(len(lines), 2)
        diagram = mesh.voronoi(lines)
        self.assertEqual(diagram.check(), [])
        border, = diagram.bisectors
        numpy.testing.assert_allclose(border.positions[:, 1], 0.45, atol=1e-12)
        numpy.testing.assert_array_equal(mesh.nearest(lines)[1], diagram.labels)

    def test_boundary_and_creases_have_the_lengths_of_their_edges(self):
        box = gvd.Mesh(*meshes.make_box(1, 2, 3))
        edges, = box.curves("creases").positions
        self.assertAlmostEqual(sum(numpy.linalg.norm(numpy.diff(line, axis=0), axis=1).sum() for line in edges), 24)
        rim, = gvd.read(meshes.HALF_SPHERE).curves("boundary").positions
        numpy.testing.assert_allclose(numpy.linalg.norm(rim[0], axis=1), 1, atol=1e-6)

    def test_a_closed_polyline_comes_back_to_its_first_point(self):
        mesh = gvd.Mesh(*meshes.make_grid(6))
        corners = [(0.2, 0.2, 0.0), (0.8, 0.2, 0.0), (0.8, 0.8, 0.0), (0.2, 0.8, 0.0)]
        middle = [(0.2, 0.5, 0.0)]
        self.assertAlmostEqual(mesh.distances(mesh.curves([corners], closed=True), to=middle)[0], 0)
        self.assertAlmostEqual(mesh.distances(mesh.curves([corners]), to=middle)[0], 0.3)

    def test_files_and_words_are_those_of_the_commands(self):
        mesh = gvd.read(meshes.FIGURE)
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder, "curves.json")
            file.write_text(json.dumps({"curves": [{"points": [{"vertex": v} for v in line]} for line in ([3, 40, 300], [1700, 2000])]}))
            table = pathlib.Path(folder, "distances.csv")
            for given, curves in ((str(file), mesh.curves(file)), (str(file), mesh.curves(os.fsencode(file))), ("creases", mesh.curves("creases"))):
                subprocess.run([BIN / "gvd-distance", meshes.FIGURE, "--curves", given, "-q", "-o", table],
                               check=True)
                written = numpy.loadtxt(table, delimiter=",", skiprows=1, usecols=2)
                numpy.testing.assert_array_equal(mesh.distances(curves), written)

    def test_what_is_no_curve_is_refused(self):
        closed, open_ = gvd.Mesh(*meshes.make_box(1, 1, 1)), gvd.Mesh(*meshes.make_grid(3))
        for reason, call in (("closed", lambda: closed.curves("boundary")),
                             ("no two faces", lambda: open_.curves("creases")),
                             ("angle", lambda: closed.curves("creases", angle=-1)),
                             ("angle", lambda: open_.curves("boundary", angle=30)),
                             ("polylines", lambda: open_.curves("boundary", closed=True)),
                             ("empty", lambda: open_.curves([])),
                             (r"curves\[1\]", lambda: open_.curves([[0, 1], ["x"]])),
                             ("no/such", lambda: open_.curves("no/such.json")),
                             ("0 and 1", lambda: open_.voronoi(open_.curves([[(0.1, 0.5, 0.0), (0.9, 0.5, 0.0)],
                                                                             [(0.5, 0.1, 0.0), (0.5, 0.9, 0.0)]]))),
                             ("weights", lambda: open_.voronoi(open_.curves("boundary"), weights=[1.0])),
                             ("exact", lambda: open_.voronoi(open_.curves("boundary"), method="gbgvd"))):
            with self.subTest(reason), self.assertRaisesRegex(gvd.Error, reason):
                call()


if __name__ == "__main__":
    unittest.main()
