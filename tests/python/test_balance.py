"""Weights, and cells of equal area: the same as the commands' --weights and --balance."""
import os
import pathlib
import subprocess
import tempfile
import unittest

import gvd
import numpy

DATA = pathlib.Path(__file__).parents[2] / "data"
BIN = pathlib.Path(os.environ.get("GVD_BIN", DATA.parent / "build" / "bin"))


class Balance(unittest.TestCase):
    def setUp(self):
        self.mesh = gvd.read(DATA / "figure.obj")
        self.points = self.mesh.farthest(12)

    def test_equal_areas(self):
        found = self.mesh.balance(self.points)
        self.assertTrue(found.converged)
        self.assertEqual(found.tied, [])
        self.assertEqual(found.diagram.check(), [])
        areas = numpy.array([cell.area for cell in found.diagram.cells])
        numpy.testing.assert_allclose(areas, areas.mean(), rtol=1e-6)
        numpy.testing.assert_allclose(areas, found.masses)
        again = self.mesh.voronoi(self.points, weights=found.diagram.weights)
        numpy.testing.assert_array_equal(again.labels, found.diagram.labels)

    def test_shares_and_densities(self):
        shares = 1 + 0.1 * numpy.arange(12, dtype=numpy.float32)
        density = 2 + numpy.sin(self.mesh.vertices[:, 0])
        found = self.mesh.balance(self.points, shares=shares, density=density)
        numpy.testing.assert_allclose(found.masses / found.masses.sum(), shares / shares.sum(), rtol=1e-6)

    def test_the_bytes_of_the_command(self):
        with tempfile.TemporaryDirectory() as folder:
            ours, theirs = pathlib.Path(folder, "a.ply"), pathlib.Path(folder, "b.ply")
            self.mesh.balance(self.points).diagram.segment().to_file(ours)
            subprocess.run([BIN / "gvd-segment", DATA / "figure.obj", "-n", "12", "--balance", "area", "-q", "-o", theirs],
                           check=True)
            self.assertEqual(ours.read_bytes(), theirs.read_bytes())

    def test_refusals(self):
        with self.assertRaisesRegex(gvd.Error, "shares: 2 numbers for 12 generators; shares takes one for each"):
            self.mesh.balance(self.points, shares=[1, 2])
        with self.assertRaisesRegex(gvd.Error, "weights: a list of numbers is needed"):
            self.mesh.voronoi(self.points, weights=[[1.0] * 12])
        with self.assertRaisesRegex(gvd.Error, "weights: numbers are needed"):
            self.mesh.voronoi(self.points, weights="1 2 3")
        with self.assertRaisesRegex(gvd.Error, "density: 3 numbers; give one for each vertex"):
            self.mesh.balance(self.points, density=[1, 2, 3])
        with self.assertRaisesRegex(gvd.Error, "weights needs method='exact'"):
            self.mesh.voronoi(self.points, weights=[0] * 12, method="gbgvd")


if __name__ == "__main__":
    unittest.main()
