"""Arrays and points of every kind: accepted, or refused in one line."""
import gc
import inspect
import multiprocessing
import os
import pickle
import tempfile
import types
import unittest
import warnings

import numpy

import gvd
import meshes

V, F = meshes.make_grid(6)


class NamedMesh(gvd.Mesh):
    name = ""


class Arrays(unittest.TestCase):
    def test_every_kind_of_array_gives_the_same_mesh(self):
        wide = numpy.zeros((len(V), 6))
        wide[:, ::2] = V
        kinds = {
            "lists": (V.tolist(), F.tolist()), "tuples": (tuple(map(tuple, V)), tuple(map(tuple, F.tolist()))),
            "int32": (V, F.astype(numpy.int32)), "uint64": (V, F.astype(numpy.uint64)), "int8": (V, F.astype(numpy.int8)),
            "Fortran order": (numpy.asfortranarray(V), numpy.asfortranarray(F)), "strides": (wide[:, ::2], F),
            "reversed": (V[::-1][::-1], F[:, ::-1][:, ::-1]), "big endian": (V.astype(">f8"), F.astype(">i4")),
        }
        for name, (vertices, faces) in kinds.items():
            with self.subTest(name):
                mesh = gvd.Mesh(vertices, faces)
                numpy.testing.assert_array_equal(mesh.vertices, V)
                numpy.testing.assert_array_equal(mesh.faces, F)
        numpy.testing.assert_array_equal(gvd.Mesh(V.astype(numpy.float32), F).vertices, V.astype(numpy.float32))

    def test_integer_coordinates_and_polygons(self):
        box = gvd.Mesh(*meshes.make_box(1, 2, 3))
        self.assertEqual(len(box.faces), 12)
        self.assertEqual(gvd.Mesh(meshes.make_box(1, 2, 3)[0].astype(int), box.faces).summary["area"], 22)

    def test_wrong_arrays_are_refused_in_one_line(self):
        nan = V.copy()
        nan[5, 1] = numpy.nan
        beyond, negative, repeated = F.copy(), F.copy(), numpy.concatenate([F, F[:1]])
        beyond[3, 0], negative[2, 1] = len(V), -1
        wrong = {
            "text": ("mesh.obj", F), "text in a list": ([["a", "b", "c"]], F), "bytes": (b"abc", F), "empty": ([], F),
            "no faces": (V, []), "empty faces": (V, numpy.zeros((0, 3), int)), "two columns": (V[:, :2], F),
            "one dimension": (V.ravel(), F), "float faces": (V, F.astype(float)), "edges": (V, F[:, :2]),
            "nan": (nan, F), "infinite": (V + numpy.inf, F), "beyond": (V, beyond), "negative": (V, negative),
            "complex": (V + 0j, F), "bool": (V, F > 3), "ragged": (V, [[0, 1, 2], [0, 1]]), "none": (None, F),
            "objects": (V.astype(object), F), "duplicate": (V, repeated), "masks": (V > 0, F),
            "masked": (numpy.ma.masked_greater(V, 0.9), F),
        }
        for name, (vertices, faces) in wrong.items():
            with self.subTest(name), warnings.catch_warnings():
                warnings.simplefilter("ignore")  # NumPy's, for ragged lists
                with self.assertRaises(gvd.Error) as caught:
                    gvd.Mesh(vertices, faces)
                message = str(caught.exception)
                self.assertNotIn("\n", message)
                self.assertGreater(len(message), 8)
                self.assertIn(caught.exception.code, ("invalid_option", "precondition"))
        with self.assertRaisesRegex(gvd.Error, f"face 3 has the vertex {len(V)}"):
            gvd.Mesh(V, beyond)
        with self.assertRaisesRegex(gvd.Error, "vertex 5 has a coordinate that is not finite"):
            gvd.Mesh(nan, F)

    def test_defects_are_refused_or_repaired_with_a_warning(self):
        repeated = numpy.concatenate([F, F[:1]])
        with self.assertWarnsRegex(UserWarning, "corners of another one"):
            mesh = gvd.Mesh(V, repeated, on_defect="repair")
        self.assertEqual(len(mesh.faces), len(F))
        numpy.testing.assert_array_equal(mesh.input_face, numpy.arange(len(F)))
        with self.assertRaisesRegex(gvd.Error, r"on_defect: 'none' is not one of error\|repair\|largest"):
            gvd.Mesh(V, F, on_defect="none")

    def test_views_are_read_only_and_keep_their_owner(self):
        diagram = gvd.Mesh(V, F).voronoi([0, 20, 48])
        arrays = [diagram.labels, diagram.distances, diagram.face_labels, diagram.generators.bary,
                  diagram.branch_points.positions, diagram.bisectors[0].points.bary, diagram.mesh.vertices]
        copies = [array.copy() for array in arrays]
        for array in arrays:
            self.assertFalse(array.flags.owndata)
            with self.assertRaises(ValueError):
                array[0] = 1
        del diagram
        gc.collect()
        blocks = [numpy.ones(1000) for _ in range(1000)]  # would overwrite memory that was freed
        for array, copy in zip(arrays, copies):
            numpy.testing.assert_array_equal(array, copy)
        del blocks

    def test_a_mesh_survives_pickling_with_the_places_of_its_elements(self):
        unused = numpy.concatenate([V[:1] + 5, V])
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            mesh = gvd.Mesh(unused, numpy.concatenate([F + 1, F[:1] + 1]), on_defect="repair")
        again = pickle.loads(pickle.dumps(mesh))
        for name in ("vertices", "faces", "input_vertex", "input_face"):
            numpy.testing.assert_array_equal(getattr(again, name), getattr(mesh, name))
        numpy.testing.assert_array_equal(again.input_vertex, numpy.arange(1, len(V) + 1))
        self.assertEqual(again.summary, mesh.summary)
        numpy.testing.assert_array_equal(again.distances([0, 7]), mesh.distances([0, 7]))
        named = NamedMesh(V, F)
        named.name = "grid"
        again = pickle.loads(pickle.dumps(named))
        self.assertEqual((type(again), again.name, again.summary), (NamedMesh, "grid", named.summary))
        with multiprocessing.get_context("spawn").Pool(1) as pool:
            numpy.testing.assert_array_equal(pool.apply(gvd.Mesh.distances, (mesh, 3)), mesh.distances(3))

    def test_the_meshes_of_results_are_their_own_input(self):
        mesh = gvd.read(meshes.TORUS)
        for made in (mesh.voronoi([0, 100, 200]).cut().mesh, mesh.remesh(100).mesh):
            numpy.testing.assert_array_equal(made.input_vertex, numpy.arange(len(made.vertices)))
            numpy.testing.assert_array_equal(made.input_face, numpy.arange(len(made.faces)))

    def test_an_error_survives_pickling(self):
        error = pickle.loads(pickle.dumps(gvd.Error("no", "precondition", 7)))
        self.assertEqual((str(error), error.code, error.element), ("no", "precondition", 7))


class PointsOfAMesh(unittest.TestCase):
    def setUp(self):
        self.mesh = gvd.Mesh(V, F)

    def test_every_way_to_give_points(self):
        at = self.mesh.positions
        for one in (8, numpy.int32(8), [8], numpy.array([8], numpy.uint8), numpy.array(8)):
            numpy.testing.assert_array_equal(at(one), V[[8]])
        numpy.testing.assert_array_equal(at([1, 2, 3]), V[[1, 2, 3]])
        weights = (0.2, 0.3, 0.5)
        inside = weights @ V[F[4]]
        mixed = [(4, weights), 7, (0.0, 0.0, 0.0)]
        for given in ((4, weights), [(4, weights)], ([4], [weights]), gvd.Points(numpy.array([4]), numpy.array([weights]))):
            numpy.testing.assert_allclose(at(given), [inside], atol=1e-15)
        numpy.testing.assert_allclose(at([7, (0.0, 0.0, 0.0)]), [V[7], (0.0, 0.0, 0.0)], atol=1e-15)
        numpy.testing.assert_allclose(at(mixed), [inside, V[7], V[0]], atol=1e-15)
        numpy.testing.assert_allclose(at((0.25, 0.25, 9.0)), [(0.25, 0.25, 0)], atol=1e-15)
        numpy.testing.assert_allclose(at(V[[3, 4]].astype(numpy.float64) + (0, 0, 1)), V[[3, 4]], atol=1e-15)

    def test_points_come_back_bit_by_bit(self):
        first = self.mesh.sample(20, sampling="random", seed=3)
        second = self.mesh.points(first)
        numpy.testing.assert_array_equal(first.face, second.face)
        numpy.testing.assert_array_equal(first.bary, second.bary)

    def test_wrong_points_are_refused_in_one_line(self):
        wrong = {"text": "7", "vertex": len(V), "negative": -1, "negative in a list": [3, -2], "empty": [], "none": None,
                 "face": (len(F), (1, 0, 0)), "weights": (0, (0.5, 0.5, 0.5)), "two weights": (0, (0.5, 0.5)),
                 "pair": ([1, 2], [(1, 0, 0)]), "nan": (numpy.nan, 0.0, 0.0), "two floats": (0.5, 0.5), "bool": True,
                 "mask": [True, False], "integer positions": numpy.zeros((2, 3), int), "huge": (1e200, 0.0, 0.0),
                 "float face": (0.5, (1, 0, 0)), "deep": numpy.zeros((2, 2, 3)), "beyond": 2**40, "far beyond": 2**70,
                 "wraps to 5": numpy.uint64(2**63 + 5), "face wraps to 0": (numpy.uint64(2**63), (1, 0, 0)),
                 "masked": numpy.ma.masked_equal([1, 2], 2)}
        for name, points in wrong.items():
            with self.subTest(name), self.assertRaises(gvd.Error) as caught:
                self.mesh.distances(points)
            self.assertNotIn("\n", str(caught.exception))
            self.assertRegex(str(caught.exception), "points")
        with self.assertRaisesRegex(gvd.Error, "vertex 3 is listed twice"):
            self.mesh.voronoi([3, 4, 3])
        self.assertEqual(len(self.mesh.voronoi([3, 4, 3], merge_coincident=True).cells), 2)
        with self.assertRaisesRegex(gvd.Error, "max_snap"):
            self.mesh.voronoi((0.5, 0.5, 1.0), max_snap=0.5)

    def test_points_in_the_same_place_are_told_as_points(self):
        for call in (self.mesh.distances, self.mesh.nearest, self.mesh.log_map, lambda p: self.mesh.isolines(p, 0.5), lambda p: self.mesh.path(0, p)):
            with self.assertRaises(gvd.Error) as caught:
                call([3, 3])
            self.assertRegex(str(caught.exception), "^(points|end): vertex 3 is listed twice; remove one$|^point: one point is needed, not 2$")
        numpy.testing.assert_array_equal(*self.mesh.distances([3, 3], each=True))
        with self.assertRaisesRegex(gvd.Error, "^generators 0 and 1 coincide; remove one$"):
            gvd.DiagramEditor(self.mesh, [0, 9]).move(0, 9)
        with self.assertRaisesRegex(gvd.Error, "vertex 3 is listed twice; remove one, or add merge_coincident$"):
            self.mesh.voronoi([3, 3])

    def test_messages_name_the_parameters(self):
        editor = gvd.DiagramEditor(self.mesh, [0, 9])
        for name, call in (("start", lambda: self.mesh.path(99, 0)), ("end", lambda: self.mesh.path(0, 99)), ("point", lambda: editor.move(0, 99)),
                           ("point", lambda: editor.add(99)), ("point", lambda: self.mesh.log_map(99)), ("points", lambda: self.mesh.distances(99)),
                           ("to", lambda: self.mesh.distances(0, to=[1, 99]))):
            with self.assertRaisesRegex(gvd.Error, f"^{name}: there is no vertex 99; the mesh has {len(V)}, numbered from 0$") as caught:
                call()
            self.assertEqual((caught.exception.code, caught.exception.element), ("precondition", 1 if name == "to" else 0))

    def test_codes_tell_arguments_from_files(self):
        for code, call in (("unreadable_input", lambda: self.mesh.curves("/no/such")), ("invalid_option", lambda: self.mesh.voronoi([0, 9], weights=[1])),
                           ("invalid_option", lambda: self.mesh.balance([0, 9], shares=[1])), ("invalid_option", lambda: self.mesh.segment(2, within=[1]))):
            with self.assertRaises(gvd.Error) as caught:
                call()
            self.assertEqual(caught.exception.code, code, caught.exception)

    def test_points_are_no_array_and_have_one_dimension(self):
        points = self.mesh.points([0, 1, 2])
        self.assertRaisesRegex(gvd.Error, "^points are no array; they have three: .face, .bary and .position$", numpy.asarray, points)
        for index in (None, Ellipsis, True, [[0]]):
            with self.assertRaisesRegex(IndexError, "^an index of points is a number, a slice, a mask or an array of numbers"):
                points[index]

    def test_vertices_of_repaired_meshes_are_their_own(self):
        # Two triangles that meet in one vertex, which becomes two; the second has no number of the input's.
        at = numpy.array([(0, 0, 0), (1, 0, 0), (0, 1, 0), (-1, 0, 0), (0, -1, 0), (9, 9, 9)], float)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            mesh = gvd.Mesh(at, [(0, 1, 2), (0, 3, 4)], on_defect="repair")
        self.assertEqual(len(mesh.vertices), 6)
        for v in range(6):
            for given in (v, [v], [v, (0.25, 0.25, 0.0)]):
                numpy.testing.assert_array_equal(mesh.positions(given)[0], mesh.vertices[v])
                self.assertEqual(mesh.distances(given)[v], 0)
            numpy.testing.assert_array_equal(mesh.segment(vertices=[v]).generators.position[0], mesh.vertices[v])
        with self.assertRaisesRegex(gvd.Error, "there is no vertex 6; the mesh has 6"):
            mesh.distances(6)

    def test_wrong_options_are_refused(self):
        for call in (lambda: self.mesh.voronoi([0, 1], method="best"), lambda: self.mesh.sample(0),
                     lambda: self.mesh.sample(3, sampling="even"), lambda: self.mesh.sample(3, sampling="radius"), lambda: self.mesh.segment(),
                     lambda: self.mesh.segment(3, radius=0.5), lambda: self.mesh.segment(3, labels="rough"),
                     lambda: self.mesh.voronoi([0, 1], threads=-1), lambda: self.mesh.voronoi([0, 1], chord_tolerance=0),
                     lambda: self.mesh.distances([0, 1], each=True, threads=-1), lambda: self.mesh.log_map([0, 1]), lambda: self.mesh.distances([0], progress=7),
                     lambda: self.mesh.distances([0], out=numpy.zeros(3)), lambda: gvd.read(7),
                     lambda: self.mesh.distances([0], each=True, out=numpy.zeros((2, 3))),
                     lambda: self.mesh.distances([0], each=True, out=numpy.zeros((1, len(V)), int)),
                     lambda: self.mesh.remesh(9, place=3), lambda: self.mesh.remesh(9, relax=-1),
                     lambda: self.mesh.lloyd(5, coarse=-1)):
            with self.assertRaises(gvd.Error) as caught:
                call()
            self.assertEqual(caught.exception.code, "invalid_option")

    def test_options_of_a_wrong_kind_are_refused_in_one_line(self):
        for call, words in ((lambda: self.mesh.voronoi([0, 1], threads=1.5), "threads: a whole number"),
                            (lambda: self.mesh.voronoi([0, 1], threads=True), "threads: a whole number"),
                            (lambda: self.mesh.voronoi([0, 1], threads=2**40), "threads: .* is too large"),
                            (lambda: self.mesh.voronoi([0, 1], method=3), "method: a text"),
                            (lambda: self.mesh.segment(radius="x"), "radius: a number"),
                            (lambda: self.mesh.points(V[3] * 1.0, max_snap=numpy.nan), "max_snap: a number"),
                            (lambda: self.mesh.voronoi([0, 1], chord_tolerance=numpy.nan), "chord_tolerance: a number"),
                            (lambda: self.mesh.segment(radius=numpy.nan), "radius: a number"),
                            (lambda: self.mesh.lloyd(5, gradation=numpy.float32("nan")), "gradation: a number"),
                            (lambda: self.mesh.lloyd(5, features=numpy.nan), "features: a number"),
                            (lambda: self.mesh.remesh(error="x"), "error: 'x' is neither a finite number above 0 nor one with a %"),
                            (lambda: self.mesh.lloyd(5, tolerance=[1]), "tolerance: a number"),
                            (lambda: self.mesh.lloyd("5"), "count: a whole number"),
                            (lambda: self.mesh.segment(3).to_html(title=3), "title: a text"),
                            (lambda: gvd.read("a.obj", on_defect=2), "on_defect: a text")):
            with self.subTest(words), self.assertRaisesRegex(gvd.Error, words) as caught:
                call()
            self.assertNotIn("\n", str(caught.exception))
            self.assertEqual(caught.exception.code, "invalid_option")
        self.assertEqual(len(self.mesh.voronoi([0, 1], threads=numpy.int8(1), chord_tolerance=numpy.float32(1e-3)).cells), 2)

    def test_an_array_without_dimensions_is_a_number(self):
        four, half, yes = numpy.array(4), numpy.array(0.5), numpy.array(True)
        self.assertEqual(len(self.mesh.sample(four)), 4)
        self.assertEqual(len(self.mesh.lloyd(four, keep_boundary=yes, features=half, iterations=four).generators), 4)
        self.assertEqual({line.level for line in self.mesh.isolines(0, half)}, {0.5, 1.0})
        with self.assertRaisesRegex(gvd.Error, "count: a whole number is needed, not array"):
            self.mesh.sample(numpy.array([4]))


class WhateverIsGiven(unittest.TestCase):
    def test_a_call_works_or_tells_in_one_line_what_is_needed(self):
        mesh = gvd.Mesh(V, F)
        diagram, path, samples = mesh.voronoi([0, 20, 48]), mesh.path(0, 9), mesh.lloyd(2)
        editor = gvd.DiagramEditor(mesh, [0, 20])
        calls = {
            "Mesh": gvd.Mesh, "vertices": lambda x: gvd.Mesh(x, F), "faces": lambda x: gvd.Mesh(V, x), "weld": lambda x: gvd.Mesh(V, F, weld=x),
            "points=, faces=": lambda x: gvd.Mesh(types.SimpleNamespace(points=V, faces=x)),
            "points=, cells=": lambda x: gvd.Mesh(types.SimpleNamespace(points=V, cells=x)),
            "read": gvd.read, "read_values": gvd.read_values, "read_properties": gvd.read_properties, "points": mesh.points,
            "curves": mesh.curves, "curve": lambda x: mesh.curves([x]), "closed": lambda x: mesh.curves([[0, 1]], closed=x),
            "angle": lambda x: mesh.curves("creases", angle=x), "max_snap": lambda x: mesh.points([0], max_snap=x), "farthest": mesh.farthest,
            "out": lambda x: mesh.distances([0], each=True, out=x), "each": lambda x: mesh.distances([0], each=x),
            "rows": mesh.distance_rows, "start": lambda x: mesh.path(x, 0), "end": lambda x: mesh.path(0, x), "log_map": mesh.log_map,
            "isolines of": lambda x: mesh.isolines(x, 0.5), "isolines": lambda x: mesh.isolines(0, x), "balance": mesh.balance,
            "density": lambda x: mesh.balance([0, 20], density=x), "DiagramEditor": lambda x: gvd.DiagramEditor(x, [0]),
            "generators": lambda x: gvd.DiagramEditor(mesh, x), "move": lambda x: editor.move(x, 1), "to": lambda x: editor.move(0, x),
            "add": editor.add, "remove": editor.remove, "to_file": mesh.to_file, "path.to_file": path.to_file,
            "points_to_file": samples.points_to_file, "title": lambda x: diagram.to_html(title=x), "Points": lambda x: gvd.Points(x, x)}
        for call, first in ((mesh.sample, {}), (mesh.distances, {"points": 0}), (mesh.nearest, {"points": 0}), (mesh.voronoi, {"points": [0, 20]}),
                            (mesh.segment, {"count": 2}), (mesh.lloyd, {"count": 2}), (mesh.remesh, {"count": 2}), (diagram.cut, {}), (diagram.segment, {})):
            for name in inspect.signature(call).parameters:
                calls[f"{call.__name__}: {name}"] = lambda x, call=call, first=first, name=name: call(**{**first, name: x})
        given = (None, numpy.bool_(True), b"/no/such", 1j, -1, 1.5, numpy.nan, 2**70, object(), [], {}, [None], (1, None), (1, "x"), [1, "a"], [[0, [1]]], {1},
                 range(3), numpy.array(None), numpy.array(["a"]), numpy.zeros((2, 2, 2)), [(1, 2, 3), (1, 2)], gvd.Mesh, mesh,
                 [-1, 0, 0], [("triangle", [[0, 1]])], gvd.Points([0], [(1.0, 0.0, 0.0)]), mesh.curves([[0, 1]]))
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            for name, call in calls.items():
                for one in given:
                    with self.subTest(name, given=one):
                        try:
                            call(one)
                        except gvd.Error as error:
                            self.assertRegex(str(error), r"^[^\n]{8,400}$")


class Welding(unittest.TestCase):
    def read_parts(self, gap, weld):
        """The Euler characteristic of two triangles that lie `gap` apart: 2 while they are separate, 1 as one square."""
        with tempfile.TemporaryDirectory() as folder, warnings.catch_warnings():
            warnings.simplefilter("ignore", UserWarning)  # what is welded, or could be, is told
            path = os.path.join(folder, "soup.off")
            with open(path, "w", encoding="ascii") as soup:
                soup.write(f"OFF\n6 2 0\n0 0 0\n1 0 0\n0 1 0\n1 {gap} 0\n1 1 0\n{gap} 1 0\n3 0 1 2\n3 3 4 5\n")
            return gvd.read(path, weld=weld).summary["euler_characteristic"]

    def test_read_joins_copies_of_vertices_as_asked(self):
        for gap, weld, parts in ((0, None, 2), (0, False, 2), (0, True, 1), (0.001, True, 2), (0.001, 0.01, 1)):
            with self.subTest(gap=gap, weld=weld):
                self.assertEqual(self.read_parts(gap, weld), parts)


if __name__ == "__main__":
    unittest.main()
