"""Distances, paths and logarithms beside brute force and closed forms."""
import math
import unittest

import numpy

import gvd
import meshes


class Distances(unittest.TestCase):
    def test_isolines_at_listed_distances(self):
        mesh = gvd.read(meshes.ROOT / "data/figure.obj")
        steps = mesh.isolines(0, 0.5)
        listed = mesh.isolines(0, sorted({line.level for line in steps}))
        self.assertEqual([(line.level, len(line.points)) for line in listed], [(line.level, len(line.points)) for line in steps])
        with self.assertRaises(gvd.Error) as refused:
            mesh.isolines(0, [0.5, 0.25])
        with self.assertRaisesRegex(gvd.Error, "^isolines: a distance, or a list of ascending ones, is needed, not None$"):
            mesh.isolines(0, None)
        self.assertEqual(refused.exception.code, "invalid_option")

    def test_in_the_plane_they_are_euclidean(self):
        at, faces = meshes.make_grid(12)
        mesh = gvd.Mesh(at, faces)
        points = mesh.sample(7, sampling="random", seed=1)
        expected = numpy.linalg.norm(mesh.positions(points)[:, None] - at[None], axis=2)
        rows = mesh.distances(points, each=True)
        numpy.testing.assert_allclose(rows, expected, rtol=1e-12, atol=1e-14)
        distance, label = mesh.nearest(points)
        numpy.testing.assert_allclose(distance, expected.min(axis=0), rtol=1e-12, atol=1e-14)
        numpy.testing.assert_array_equal(label, expected.argmin(axis=0))
        targets = mesh.sample(50, sampling="random", seed=2)
        at_targets = numpy.linalg.norm(mesh.positions(points)[:, None] - mesh.positions(targets)[None], axis=2)
        numpy.testing.assert_allclose(mesh.distances(points, each=True, to=targets), at_targets, rtol=1e-11)

    def test_on_a_box_they_are_those_of_its_unfoldings(self):
        for a, b, c in ((1, 1, 1), (1, 2, 3), (2, 1, 5)):
            mesh = gvd.Mesh(*meshes.make_box(a, b, c))
            shortest = min(math.hypot(a + b, c), math.hypot(a + c, b), math.hypot(b + c, a))
            self.assertAlmostEqual(mesh.distances(0)[6], shortest, delta=1e-13 * shortest)
            path = mesh.path(0, 6)
            self.assertAlmostEqual(path.length, shortest, delta=1e-13 * shortest)
            pieces = numpy.linalg.norm(numpy.diff(path.positions, axis=0), axis=1)
            self.assertAlmostEqual(pieces.sum(), shortest, delta=1e-12 * shortest)

    def test_they_lie_between_straight_lines_and_ways_along_edges(self):
        for path in (meshes.FIGURE, meshes.TORUS, meshes.HALF_SPHERE):
            mesh = gvd.read(path)
            for start in (0, len(mesh.vertices) // 2):
                exact = mesh.distances(start)
                along_edges = meshes.edge_distances(mesh.vertices, mesh.faces, start)
                straight = numpy.linalg.norm(mesh.vertices - mesh.vertices[start], axis=1)
                self.assertTrue((exact <= along_edges * (1 + 1e-12)).all())
                self.assertTrue((exact >= straight * (1 - 1e-12)).all())
                self.assertLess(exact.sum(), 0.99 * along_edges.sum())  # along edges is no exact distance

    def test_on_a_sphere_they_are_great_circles_nearly(self):
        mesh = gvd.read(meshes.HALF_SPHERE)
        at = mesh.vertices / numpy.linalg.norm(mesh.vertices, axis=1)[:, None]
        radius = numpy.linalg.norm(mesh.vertices, axis=1).mean()
        pole = int(mesh.vertices[:, 2].argmax()) if numpy.ptp(mesh.vertices[:, 2]) < 1.5 * radius else 0
        arcs = radius * numpy.arccos(numpy.clip(at @ at[pole], -1, 1))
        far = arcs > 0.3 * radius
        numpy.testing.assert_allclose(mesh.distances(pole)[far], arcs[far], rtol=0.03)

    def test_rows_columns_and_paths_agree(self):
        mesh = gvd.read(meshes.FIGURE)
        points = [0, 900, (12, (0.2, 0.3, 0.5)), 900]
        rows = mesh.distances(points, each=True, to=points)
        numpy.testing.assert_allclose(rows, rows.T, rtol=1e-12, atol=1e-15)
        numpy.testing.assert_allclose(numpy.diag(rows), 0, atol=1e-15)
        paths = mesh.path(points, 0)
        self.assertEqual([p.complete for p in paths], [True] * 4)
        numpy.testing.assert_allclose([p.length for p in paths], rows[0], rtol=1e-12, atol=1e-15)
        both = mesh.path(5, [0, 900])
        self.assertEqual(both.end, int(mesh.nearest([0, 900])[1][5]))

    def test_logarithms_have_the_distances_as_lengths(self):
        mesh = gvd.read(meshes.TORUS)
        logs, exact = mesh.log_map(40), mesh.distances(40)
        known = numpy.isfinite(logs).all(axis=1)
        self.assertGreater(known.mean(), 0.99)
        numpy.testing.assert_allclose(numpy.linalg.norm(logs[known], axis=1), exact[known], rtol=1e-11, atol=1e-15)
        at, faces = meshes.make_grid(8)
        flat = gvd.Mesh(at, faces)
        centre = len(at) // 2
        logs, ways = flat.log_map(centre), at[:, :2] - at[centre, :2]
        angles = numpy.angle((logs @ (1, 1j))[numpy.arange(len(at)) != centre])
        turns = angles - numpy.angle((ways @ (1, 1j))[numpy.arange(len(at)) != centre])
        numpy.testing.assert_allclose(numpy.exp(1j * turns), numpy.exp(1j * turns[0]), atol=1e-10)

    def test_what_nothing_reaches_is_infinitely_far(self):
        at, faces = meshes.make_grid(2)
        two = gvd.Mesh(numpy.concatenate([at, at + (0, 0, 1)]), numpy.concatenate([faces, faces + len(at)]))
        distance, label = two.nearest(0)
        self.assertTrue(numpy.isinf(distance[len(at):]).all() and (label[len(at):] == -1).all())
        self.assertTrue(numpy.isnan(two.log_map(0)[len(at):]).all())
        path = two.path(0, len(at))
        self.assertEqual((path.length, path.end, len(path.positions)), (math.inf, -1, 0))

    def test_rows_are_the_same_for_any_way_to_get_them(self):
        mesh = gvd.read(meshes.FIGURE)
        points = mesh.farthest(40)
        rows = mesh.distances(points, each=True, threads=1)
        numpy.testing.assert_array_equal(rows, mesh.distances(points, each=True, threads=3))
        numpy.testing.assert_array_equal(rows, list(mesh.distance_rows(points)))
        numpy.testing.assert_array_equal(rows.min(axis=0).argsort()[:5], mesh.distances(points).argsort()[:5])
        for i in (0, 17):
            one = gvd.Points(points.face[[i]], points.bary[[i]])
            numpy.testing.assert_array_equal(rows[i], mesh.distances(one))
            numpy.testing.assert_array_equal(rows[i], mesh.distances(one, to=list(range(len(mesh.vertices)))))
        single = numpy.zeros(rows.shape, numpy.float32, order="F")
        self.assertIs(mesh.distances(points, each=True, out=single), single)
        numpy.testing.assert_array_equal(single, rows.astype(numpy.float32))


class Diagrams(unittest.TestCase):
    def test_labels_are_those_of_the_least_row(self):
        mesh = gvd.read(meshes.FIGURE)
        points = mesh.sample(25, sampling="random", seed=4)
        diagram, rows = mesh.voronoi(points), mesh.distances(points, each=True)
        numpy.testing.assert_allclose(diagram.distances, rows.min(axis=0), rtol=1e-12)
        nearest = rows[diagram.labels, numpy.arange(rows.shape[1])]
        numpy.testing.assert_allclose(nearest, rows.min(axis=0), rtol=1e-12)
        self.assertEqual(diagram.check(), [])

    def test_bisectors_and_branch_points_are_equally_far(self):
        mesh = gvd.read(meshes.TORUS)
        points = mesh.farthest(12)
        diagram = mesh.voronoi(points)
        edge = mesh.summary["bbox_diagonal"] / 100
        for bisector in diagram.bisectors:
            sides = mesh.distances(gvd.Points(points.face[[bisector.left, bisector.right]],
                                              points.bary[[bisector.left, bisector.right]]), each=True, to=bisector.points)
            self.assertLess(abs(sides[0] - sides[1]).max(), 1e-3 * edge)
        branch = diagram.branch_points
        rows = mesh.distances(points, each=True, to=branch.points)
        for i, generators in enumerate(branch.generators):
            self.assertLess(numpy.ptp(rows[list(generators), i]), 1e-3 * edge)
            self.assertAlmostEqual(rows[list(generators), i].mean(), branch.distances[i], delta=1e-3 * edge)
        numpy.testing.assert_allclose(mesh.positions(branch.points), branch.positions, atol=1e-12)

    def test_cells_and_their_cut_have_the_area_of_the_mesh(self):
        mesh = gvd.read(meshes.FIGURE)
        diagram = mesh.voronoi(mesh.farthest(10))
        area = mesh.summary["area"]
        self.assertAlmostEqual(sum(cell.area for cell in diagram.cells) / area, 1, delta=1e-12)
        cut = diagram.cut()
        a, b, c = (cut.mesh.vertices[cut.mesh.faces[:, k]] for k in range(3))
        areas = numpy.linalg.norm(numpy.cross(b - a, c - a), axis=1) / 2
        measured = numpy.bincount(cut.labels, areas)
        numpy.testing.assert_allclose(measured, [cell.area for cell in diagram.cells], rtol=1e-9)
        self.assertTrue((numpy.diff(cut.parents) >= 0).all())
        neighbours = {(b.left, b.right) for b in diagram.bisectors}
        for cell in diagram.cells:
            for other in cell.neighbours:
                self.assertTrue({(cell.generator, other), (other, cell.generator)} & neighbours)


if __name__ == "__main__":
    unittest.main()
