"""Edited diagrams beside new ones: the same bits after each change, and what can't be done changes nothing."""
import gc
import random
import unittest

import numpy

import gvd
import meshes


def arrays(diagram):
    """All numbers of a diagram."""
    return [diagram.labels, diagram.distances, diagram.face_labels, diagram.generators.face, diagram.generators.bary, diagram.branch_points.positions,
            diagram.branch_points.distances, *(b.positions for b in diagram.bisectors),
            numpy.array([(b.left, b.right, b.closed, *b.ends) for b in diagram.bisectors]),
            numpy.array([cell.area for cell in diagram.cells])]


class Editor(unittest.TestCase):
    def assert_same(self, diagram, expected):
        found, wanted = arrays(diagram), arrays(expected)
        self.assertEqual(len(found), len(wanted))
        for a, b in zip(found, wanted):
            numpy.testing.assert_array_equal(a, b)

    def test_changes_give_the_bits_of_new_diagrams(self):
        numbers = random.Random(1)
        for file in (meshes.FIGURE, meshes.TORUS, meshes.HALF_SPHERE):
            mesh = gvd.read(file)
            editor = gvd.DiagramEditor(mesh, mesh.farthest(12), chord_tolerance=0.1, threads=2)
            for _ in range(8):
                count, face = len(editor.generators.face), numbers.randrange(len(mesh.faces))
                point, g = (face, (0.25, 0.25, 0.5)), numbers.randrange(count)
                made = numbers.choice([lambda: editor.move(g, point), lambda: editor.add(point), lambda: editor.remove(g)])()
                self.assertIs(made, editor.diagram)
                self.assert_same(made, mesh.voronoi(editor.generators, chord_tolerance=0.1))

    def test_numbers_follow_the_changes(self):
        editor = gvd.DiagramEditor(gvd.read(meshes.TORUS), [0, 100, 200])
        added = editor.add((5, (0.5, 0.25, 0.25)))
        self.assertEqual((len(added.cells), added.generators.face[3]), (4, 5))
        last = editor.generators.bary[3].copy()
        numpy.testing.assert_array_equal(editor.remove(1).generators.bary[1], last)
        self.assertEqual(len(editor.generators.face), 3)

    def test_earlier_diagrams_stay_as_they_are(self):
        mesh = gvd.read(meshes.TORUS)
        editor = gvd.DiagramEditor(mesh, mesh.farthest(9))
        first, labels = editor.diagram, editor.diagram.labels
        moved = editor.move(4, 77)
        self.assert_same(first, mesh.voronoi(mesh.farthest(9)))
        expected = moved.labels.copy()
        del editor, first
        gc.collect()
        numpy.testing.assert_array_equal(labels, mesh.voronoi(mesh.farthest(9)).labels)
        numpy.testing.assert_array_equal(moved.labels, expected)
        self.assertEqual(moved.check(), [])

    def test_what_cannot_be_done_changes_nothing(self):
        mesh = gvd.read(meshes.TORUS)
        editor = gvd.DiagramEditor(mesh, [0, 100])
        for code, call in (("precondition", lambda: editor.move(2, 5)),
                           ("precondition", lambda: editor.remove(-1)),
                           ("precondition", lambda: editor.move(0, 100)),
                           ("precondition", lambda: editor.add(0)),
                           ("precondition", lambda: editor.add(1 << 40)),
                           ("invalid_option", lambda: editor.add([1, 2])),
                           ("invalid_option", lambda: editor.move("0", 5)),
                           ("invalid_option", lambda: editor.remove(1 << 70)),
                           ("invalid_option", lambda: gvd.DiagramEditor(mesh, [0], chord_tolerance=-1.0)),
                           ("precondition", lambda: gvd.DiagramEditor(mesh, [3, 3]))):
            with self.assertRaises(gvd.Error) as caught:
                call()
            self.assertEqual(caught.exception.code, code)
        self.assert_same(editor.diagram, mesh.voronoi([0, 100]))
        editor.remove(1)
        self.assertRaises(gvd.Error, editor.remove, 0)
        self.assertEqual(editor.diagram.labels.max(), 0)

    def test_progress_cancels_and_there_is_one_change_at_a_time(self):
        mesh = gvd.read(meshes.FIGURE)
        editor = gvd.DiagramEditor(mesh, mesh.farthest(30))
        before, codes = editor.diagram, []

        def interfere(step, fraction):
            try:
                editor.remove(0)
            except gvd.Error as error:
                codes.append(error.code)
            return False

        with self.assertRaises(gvd.Error) as caught:
            editor.move(3, 77, progress=interfere)
        self.assertEqual([*codes, caught.exception.code], ["precondition", "interrupted"])
        self.assertIs(editor.diagram, before)
        self.assert_same(editor.move(3, 77), mesh.voronoi(editor.generators))


if __name__ == "__main__":
    unittest.main()
