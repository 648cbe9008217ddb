"""Pickles: meshes, results and editors come back with their arrays, and compute again what else is asked of them."""
import os
import pathlib
import pickle
import tempfile
import unittest

import numpy

import gvd
import meshes


class Pickles(unittest.TestCase):
    def test_results_come_back_and_compute_again_what_they_must(self):
        mesh = gvd.read(meshes.TORUS)
        for made, arrays, file in (
                (mesh.segment(8, within=(mesh.vertices[:, 0] > 0).astype(int)), ("labels", "areas", "regions"), "json"),
                (mesh.segment(levels=[2, 5]), ("labels",), "ply"), (mesh.voronoi([0, 5, 99]), ("labels", "distances", "areas"), "json"),
                (mesh.segment(4).diagram, ("labels", "face_labels"), "json"), (mesh.segment(4).diagram.cut(uv="logmap"), ("labels", "parents"), "obj"),
                (mesh.lloyd(5), ("energies", "areas"), "csv"), (mesh.remesh(90), (), "ply"), (mesh.remesh(90).map(), (), "json"),
                (gvd.DiagramEditor(mesh, [0, 9]).add(77), ("labels",), "json")):
            again = pickle.loads(pickle.dumps(made))
            with self.subTest(made):
                for name in arrays:
                    numpy.testing.assert_array_equal(getattr(again, name), getattr(made, name))
                self.assertIsNone(again._handle, "what was pickled is not computed again")
                with tempfile.TemporaryDirectory() as folder:
                    ours, theirs = pathlib.Path(folder, f"a.{file}"), pathlib.Path(folder, f"b.{file}")
                    made.to_file(ours)
                    again.to_file(theirs)
                    self.assertEqual(ours.read_bytes().replace(b"a.mtl", b""), theirs.read_bytes().replace(b"b.mtl", b""))

    def test_a_pickle_knows_the_arrays_as_they_were(self):
        mesh = gvd.read(meshes.TORUS)
        parcels, ids = numpy.zeros(len(mesh.faces), numpy.int32), numpy.array([0, 5, 99])
        parcels[:100] = 1
        for made in (mesh.segment(6, within=parcels), mesh.voronoi(ids)):
            parcels[:], ids[:] = 0, (1, 2, 3)
            again = pickle.loads(pickle.dumps(made))
            diagram = getattr(again, "diagram", again)
            self.assertEqual(diagram.length, getattr(made, "diagram", made).length)
            self.assertGreater(diagram.length, 0)

    def test_an_editor_comes_back(self):
        mesh = gvd.read(meshes.TORUS)
        editor = gvd.DiagramEditor(mesh, [0, 9])
        editor.add(77)
        again = pickle.loads(pickle.dumps(editor))
        self.assertEqual(again.move(0, 5).length, editor.move(0, 5).length)


if __name__ == "__main__":
    os.chdir(meshes.ROOT)
    unittest.main()
