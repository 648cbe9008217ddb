"""What a person guesses works: points as a sequence, meshes of other packages, colours, files."""
import os
import pathlib
import tempfile
import types
import unittest
import warnings

import numpy

import gvd
import meshes


class PointsAsASequence(unittest.TestCase):
    def test_their_length_items_and_parts(self):
        mesh = gvd.read(meshes.FIGURE)
        points = mesh.farthest(500)
        self.assertEqual(len(points), 500)
        self.assertEqual(points[3], (int(points.face[3]), tuple(points.bary[3])))
        self.assertEqual((points[-1], list(points)[-1], len(points[10:20])), (points[499], points[499], 10))
        self.assertRaises(IndexError, lambda: points[500])
        mask = numpy.arange(500) % 7 == 0
        numpy.testing.assert_array_equal(points[mask].face, points.face[mask])
        numpy.testing.assert_array_equal(points[[4, 2]].position, mesh.positions(points)[[4, 2]])
        numpy.testing.assert_array_equal(points.position, mesh.positions(points))
        self.assertEqual(repr(points), "gvd.Points(500)")

    def test_one_of_them_is_a_point_everywhere(self):
        mesh = gvd.read(meshes.TORUS)
        points = mesh.sample(5, sampling="random")
        for again in (mesh.points(points[2]), mesh.points([points[2]])):
            numpy.testing.assert_array_equal(again.bary, points.bary[[2]])
            self.assertEqual(again.face[0], points.face[2])
        numpy.testing.assert_array_equal(mesh.distances(points[1]), mesh.distances(points[1:2]))

    def test_points_of_no_mesh_name_who_knows(self):
        with self.assertRaisesRegex(gvd.Error, r"mesh.positions\(points\)"):
            gvd.Points([0], [(1.0, 0.0, 0.0)]).position

    def test_a_far_position_warns_in_the_line_that_gave_it(self):
        mesh = gvd.read(meshes.TORUS)
        far = (9.0, 9.0, 9.0)
        for name, call in (("points", lambda: mesh.distances([3., 17., 99.])), ("points", lambda: mesh.voronoi([far])), ("points", lambda: mesh.positions(far)),
                           ("generators", lambda: mesh.segment(generators=far)), ("start", lambda: mesh.path(far, 0)), ("end", lambda: mesh.path(0, far)),
                           ("to", lambda: mesh.distances(0, to=far)), ("to", lambda: mesh.distances(0, to=far, each=True)), ("fixed", lambda: mesh.lloyd(3, fixed=far)),
                           ("point", lambda: mesh.log_map(far)), ("point", lambda: gvd.DiagramEditor(mesh, [0]).add(far)), ("points", lambda: mesh.balance([far, (0.0, 0.0, 0.0)]))):
            with self.assertWarnsRegex(UserWarning, f"^{name}: point 0 is .* from the surface, and the model's diagonal is") as caught:
                call()
            self.assertEqual(pathlib.Path(caught.filename).name, "test_guesses.py")
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            mesh.distances(mesh.vertices[:2] + 1e-4)


class MeshesOfOthers(unittest.TestCase):
    def test_what_has_vertices_and_faces_or_points_and_cells(self):
        at, faces = meshes.make_grid(3)
        padded = numpy.column_stack([numpy.full(len(faces), 3), faces]).ravel()  # as PyVista has them
        block = types.SimpleNamespace(type="triangle", data=faces)
        line = types.SimpleNamespace(type="line", data=faces[:, :2])
        for thing in (types.SimpleNamespace(vertices=at, faces=faces), types.SimpleNamespace(points=at, faces=padded),
                      types.SimpleNamespace(points=at, cells=[line, block]), types.SimpleNamespace(points=at, cells=[("triangle", faces)]),
                      gvd.Mesh(at, faces)):
            numpy.testing.assert_array_equal(gvd.Mesh(thing).faces, faces)
        quads = meshes.make_box(1, 1, 1)
        self.assertEqual(len(gvd.Mesh(types.SimpleNamespace(vertices=quads[0], faces=quads[1])).faces), 12)
        with self.assertRaisesRegex(gvd.Error, "or a mesh with `vertices` and `faces`.*not int"):
            gvd.Mesh(7)
        for padded in ([3, 0, 1, 2, 4, 0, 1, 2, 3], [-1, 0, 0]):
            with self.assertRaisesRegex(gvd.Error, "faces: polygons of equally many corners are needed"):
                gvd.Mesh(types.SimpleNamespace(points=at, faces=padded))

    def test_area_and_bounds(self):
        mesh = gvd.Mesh(*meshes.make_box(1, 2, 3))
        self.assertEqual(mesh.area, 22)
        numpy.testing.assert_array_equal(mesh.bounds, [(0, 0, 0), (1, 2, 3)])


class Results(unittest.TestCase):
    def test_regions_and_areas_are_always_there(self):
        mesh = gvd.read(meshes.TORUS)
        regions = mesh.segment(6)
        numpy.testing.assert_array_equal(regions.regions, numpy.zeros(len(mesh.faces)))
        self.assertAlmostEqual(regions.areas.sum() / mesh.area, 1)
        self.assertAlmostEqual(regions.diagram.areas.sum() / mesh.area, 1)
        self.assertAlmostEqual(mesh.lloyd(6).areas.sum() / mesh.area, 1)

    def test_branch_points_and_cells_are_arrays(self):
        diagram = gvd.read(meshes.FIGURE).voronoi(gvd.read(meshes.FIGURE).farthest(20))
        branch, cells = diagram.branch_points, diagram.cells
        self.assertEqual(len(branch.offsets), len(branch.distances) + 1)
        self.assertEqual(branch.generators[3], tuple(branch.generator_array[branch.offsets[3]:branch.offsets[4]]))
        self.assertEqual([cell.area for cell in cells], cells.area.tolist())
        self.assertEqual(cells[5].neighbours, tuple(cells.neighbour_array[cells.offsets[5]:cells.offsets[6]]))
        self.assertEqual((cells[-1].generator, len(cells[2:4])), (19, 2))

    def test_reprs_are_short(self):
        mesh = gvd.read(meshes.TORUS)
        regions, path = mesh.segment(9), mesh.path(0, 300)
        made = [mesh, regions, regions.diagram, regions.diagram.cells, regions.diagram.branch_points, regions.diagram.bisectors[0],
                regions.diagram.cut(), path, mesh.balance(mesh.farthest(9)), mesh.lloyd(9), mesh.remesh(90), mesh.remesh(90).map(),
                mesh.isolines(0, 0.5)[0], mesh.curves([[0, 9]]), regions.generators, gvd.DiagramEditor(mesh, [0, 9])]
        for one in made:
            self.assertRegex(repr(one), r"^gvd\.[^\n]{1,90}$")

    def test_colours_are_those_of_the_files(self):
        regions = gvd.read(meshes.TORUS).segment(12)
        with tempfile.TemporaryDirectory() as folder:
            regions.to_file(f"{folder}/a.ply")
            face = gvd.read_properties(f"{folder}/a.ply")["face"]
        self.assertEqual(regions.colors.shape, (len(regions.labels), 4))
        numpy.testing.assert_array_equal(numpy.round(regions.colors[:, :3] * 255), numpy.column_stack([face[c] for c in ("red", "green", "blue")]))
        self.assertEqual(regions.diagram.cut().colors[:, 3].min(), 1)

    def test_show_opens_the_page(self):
        with tempfile.TemporaryDirectory() as folder:
            browser = pathlib.Path(folder, "browser")
            browser.write_text(f"#!/bin/sh\necho \"$1\" > {folder}/shown\n")
            browser.chmod(0o755)
            before = os.environ.get("BROWSER")
            os.environ["BROWSER"] = str(browser)
            try:
                import webbrowser
                webbrowser._tryorder = None  # it looks for browsers once
                gvd.read(meshes.TORUS).segment(3).show()
            finally:
                os.environ.pop("BROWSER") if before is None else os.environ.__setitem__("BROWSER", before)
            shown = pathlib.Path(folder, "shown").read_text().strip()
            self.assertTrue(shown.startswith("file:///") and shown.endswith(".html"), shown)
            page = pathlib.Path(shown[len("file://"):])
            self.assertIn("<html", page.read_text()[:300])
            page.unlink()


class Files(unittest.TestCase):
    def test_what_a_format_does_not_hold_is_refused_as_the_command_refuses_it(self):
        mesh = gvd.read(meshes.TORUS)
        regions = mesh.segment(3)
        with tempfile.TemporaryDirectory() as folder:
            for made, name, options, words in (
                    (regions, "a.off", {"no_curves": True}, "no_curves: only .obj, .vtp, .vtu and .glb hold curves; write one or leave no_curves out"),
                    (regions, "a.ply", {"region_materials": True}, "region_materials: only .obj holds materials; write one or leave region_materials out"),
                    (regions, "a.json", {"ascii_ply": True}, "ascii_ply: no .ply is written; write one or leave ascii_ply out"),
                    (regions.diagram.cut(uv="logmap"), "a.off", {}, "uv: only .ply, .obj and .glb hold texture coordinates; write one or leave uv out"),
                    (mesh.remesh(90, carry=True), "a.off", {}, "carry: only .ply, .obj and .glb hold what is carried over; write one or leave carry out")):
                with self.assertRaises(gvd.Error) as caught:
                    made.to_file(pathlib.Path(folder, name), **options)
                self.assertEqual((str(caught.exception), caught.exception.code), (words, "invalid_option"))
            regions.to_file(pathlib.Path(folder, "a.off"), no_curves=False, ascii_ply=False)
            self.assertEqual(os.listdir(folder), ["a.off"])

    def test_an_empty_name_is_told(self):
        for call in (gvd.read, gvd.read_values, gvd.Mesh(*meshes.make_grid(2)).to_file):
            with self.assertRaisesRegex(gvd.Error, "^the path is empty; name a file$"):
                call("")


class Help(unittest.TestCase):
    def test_options_are_told_as_arrays(self):
        for function in (gvd.Mesh.segment, gvd.Mesh.lloyd, gvd.Mesh.remesh, gvd.Mesh.distances, gvd.Mesh.voronoi):
            self.assertNotRegex(function.__doc__.split("Options:")[1], r" file\b|File |FILE|standard input|as in|VTP or VTU")
        self.assertIn("generators: The generators, as points", gvd.Mesh.segment.__doc__)

    def test_former_names_have_a_hint(self):
        mesh = gvd.Mesh(*meshes.make_grid(3))
        for call, hint in ((lambda: mesh.segment(n=3), "Mesh.segment has no option 'n'; did you mean 'count'?"),
                           (lambda: mesh.distances(0, at=3), "Mesh.distances has no option 'at'; did you mean 'to'?"),
                           (lambda: mesh.segment(3, cut=True), "Mesh.segment has no option 'cut'; call diagram.cut() of the result"),
                           (lambda: mesh.segment(3, uv="flat"), "Mesh.segment has no option 'uv'; call diagram.cut(uv=...) of the result"),
                           (lambda: mesh.remesh(3, map=True), "Mesh.remesh has no option 'map'; call map() of the result"),
                           (lambda: mesh.remesh(3, no_refine=True), "Mesh.remesh has no option 'no_refine'; did you mean 'refine'?")):
            with self.assertRaises(TypeError) as caught:
                call()
            self.assertEqual(str(caught.exception), hint)


class Words(unittest.TestCase):
    def test_errors_use_the_words_of_the_call(self):
        mesh = gvd.Mesh(*meshes.make_grid(3))
        editor = gvd.DiagramEditor(mesh, [5])
        for call, words in ((lambda: mesh.sample(), "^sample: how many points\\? Give a count or a radius$"),
                            (lambda: mesh.voronoi([99]), "^points: there is no vertex 99"),
                            (lambda: mesh.path(0, []), "^end: empty$"),
                            (lambda: mesh.lloyd(3, gradation=0.2), "^gradation needs density='curvature': add it, or leave gradation out$"),
                            (lambda: mesh.curves("creases", angle=0), "^angle: a number above 0 and below 180, in degrees, is needed, not 0$"),
                            (lambda: mesh.curves("creases"), "no two faces meet at more than 40 degrees; ask for a smaller angle, or use the boundary or points$"),
                            (lambda: mesh.curves("creases:30", angle=30), '^angle: it is for "creases"$'),
                            (lambda: editor.remove(0), "^generator 0 is the only one, and a diagram needs one; move it, or add another first$"),
                            (lambda: gvd.Mesh(mesh.vertices, numpy.zeros((0, 3), int)), "^faces: empty$")):
            with self.assertRaisesRegex(gvd.Error, words):
                call()

    def test_creases_with_an_angle_are_curves_everywhere(self):
        mesh = gvd.Mesh(*meshes.make_box(1, 2, 3))
        self.assertEqual(len(mesh.curves("creases:30")), len(mesh.curves("creases", angle=30)))
        numpy.testing.assert_array_equal(mesh.distances(mesh.curves("creases:30")), numpy.zeros(8))

    def test_numbers_of_a_tetrahedron_are_those_of_faces_for_regions_and_of_vertices_for_a_density(self):
        at = numpy.array([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], float)
        mesh = gvd.Mesh(at, [(0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2)])
        numpy.testing.assert_array_equal(mesh.segment(2, within=[0, 0, 1, 1]).regions, [0, 0, 1, 1])
        numpy.testing.assert_array_equal(mesh.segment(1, mask=[1, 1, 0, 1]).labels, [-1, -1, 0, -1])
        total = mesh.balance([0, 3], density=[1, 1, 1, 2]).masses.sum()
        areas = [0.5, 0.5, numpy.sqrt(0.75), 0.5]
        means = [1, 4 / 3, 4 / 3, 4 / 3]  # of the vertices of each face
        self.assertAlmostEqual(total, numpy.dot(areas, means))


class OtherDoors(unittest.TestCase):
    """What commands and C have, Python has, too."""

    def test_segments_of_equal_areas_inside_curves_and_on_discs(self):
        mesh = gvd.read(meshes.FIGURE)
        equal = mesh.segment(12, balance="area")
        self.assertTrue(equal.figures["balance"]["converged"])
        numpy.testing.assert_allclose(equal.diagram.areas, mesh.area / 12, rtol=1e-6)
        shared = mesh.segment(generators=mesh.farthest(3), balance=numpy.ones(len(mesh.vertices)), shares=[1, 2, 3])
        self.assertAlmostEqual(shared.diagram.areas[2] / shared.diagram.areas[0], 3, places=4)
        numpy.testing.assert_array_equal(
            mesh.segment(generators=mesh.farthest(12), weights=equal.figures["weights"]).labels, equal.labels)
        self.assertEqual(mesh.segment(curves=mesh.curves([[0, 50], [2000, 2100]])).labels.max(), 1)
        halves = (mesh.vertices[:, 2] > 0).astype(int)
        kept = mesh.voronoi(mesh.farthest(6), within=halves)
        self.assertEqual((kept.check(), kept.figures["within"]["regions"]), ([], 2))
        labels = kept.segment().labels
        self.assertEqual(mesh.lloyd(6, within=halves).diagram.check(), [])
        numpy.testing.assert_array_equal(labels, mesh.segment(generators=mesh.farthest(6), within=halves).labels)
        relaxed = mesh.lloyd(12, balance="area")
        numpy.testing.assert_allclose(relaxed.areas, mesh.area / 12, rtol=1e-6)

    def test_isolines_are_as_far_as_they_say(self):
        at, faces = meshes.make_grid(8)
        rings = gvd.Mesh(at, faces).isolines([(0.5, 0.5, 0.0)], 0.2)
        self.assertEqual({ring.level for ring in rings}, {0.2, 0.4, 0.6000000000000001})
        for ring in rings:
            numpy.testing.assert_allclose(numpy.hypot(*(ring.positions[:, :2] - 0.5).T), ring.level, rtol=2e-3)
        self.assertTrue(rings[0].closed)

    def test_paths_lead_to_curves(self):
        mesh = gvd.Mesh(*meshes.make_grid(6))
        line = mesh.curves([[(0.0, 0.2, 0.0), (1.0, 0.2, 0.0)]])
        path = mesh.path((0.4, 0.7, 0.0), line)
        self.assertAlmostEqual(path.length, 0.5)
        numpy.testing.assert_allclose(path.positions[-1], (0.4, 0.2, 0), atol=1e-12)

    def test_an_error_in_percent(self):
        mesh = gvd.read(meshes.TORUS)
        diagonal = mesh.summary["bbox_diagonal"]
        percent, length = mesh.remesh(error="2%"), mesh.remesh(error=0.02 * diagonal)
        self.assertEqual(len(percent.mesh.vertices), len(length.mesh.vertices))
        self.assertLessEqual(percent.figures["distance"]["input_to_output"]["hausdorff"], 0.02 * diagonal)

    def test_blue_noise_by_radius(self):
        mesh = gvd.Mesh(*meshes.make_grid(12))
        points = mesh.sample(radius=0.1, sampling="poisson", seed=3)
        between = numpy.linalg.norm(points.position[:, None] - points.position[None], axis=2) + numpy.eye(len(points))
        self.assertGreater(between.min(), 0.08)
        self.assertLessEqual(mesh.distances(points).max(), 0.1)
        self.assertFalse(numpy.array_equal(points.face[:5], mesh.sample(radius=0.1, seed=3).face[:5]))
        with self.assertRaisesRegex(gvd.Error, "sampling: a radius gives farthest or poisson points; give count, or leave sampling out"):
            mesh.sample(radius=0.1, sampling="random")

    def test_distances_inside_a_mask(self):
        at, faces = meshes.make_grid(6)
        mask = at[faces].mean(axis=1)[:, 0] > 0.5
        found = gvd.Mesh(at, faces).distances(0, mask=mask)
        self.assertTrue(numpy.isinf(found[at[:, 0] > 0.7]).all() and numpy.isfinite(found[at[:, 0] < 0.3]).all())


if __name__ == "__main__":
    os.chdir(meshes.ROOT)
    unittest.main()
