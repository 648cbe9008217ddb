#!/usr/bin/env python3
"""The battery's checks find what is wrong: test_checks.py BIN_FOLDER. Right outputs of the commands are spoilt one by one."""
import copy
import json
import pathlib
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True

import cases
import run_command
from check_lloyd import check_lloyd
from check_remesh import check_map, check_remesh
from check_segment import check_segment
from meshes import families
from run_command import run
from surface import Finding, Surface

BIN = pathlib.Path(sys.argv[1]).resolve()
MESHES = {mesh.name: mesh for mesh in families([1])}


class Outputs:
    """What a command writes for one mesh."""

    def __init__(self, name, command, *options):
        self.mesh = MESHES[name]
        with tempfile.TemporaryDirectory() as folder_name:
            folder = pathlib.Path(folder_name)
            self.mesh.write(folder / "in.off")
            self.surface = cases.repaired_surface(self.mesh, BIN, folder)
            case = cases.Case(command, options)
            cases.run_case(self.mesh, self.surface, case, BIN, folder)
            self.report = json.loads((folder / "report.json").read_text())
            self.written = json.loads((folder / "out.json").read_text()) if command != "remesh" else None
            self.coarse = cases.read_off(folder / "out.off") if command == "remesh" else None
            self.map = json.loads((folder / "map.json").read_text()) if command == "remesh" else None


class SegmentCase(unittest.TestCase):
    def spoilt(self, outputs, change):
        """Whether check_segment finds a change of the diagram."""
        diagram, report = copy.deepcopy(outputs.written), copy.deepcopy(outputs.report)
        change(diagram)
        with self.assertRaises(Finding) as found:
            check_segment(outputs.mesh, outputs.surface, diagram, report)
        return str(found.exception)

    @classmethod
    def setUpClass(cls):
        cls.ball = Outputs("ball", "segment", "-n", "7", "--sampling", "random")
        cls.sheet = Outputs("sheet", "segment", "-n", "7", "--sampling", "random")
        cls.cut = Outputs("torus", "segment", "-n", "7", "--cut")

    def test_label_of_another_region(self):
        def change(diagram):
            labels = diagram["face_labels"]
            inner = next(f for f in range(len(labels)) if labels.count(labels[f]) > 20 and labels[f] != labels[0])
            labels[0] = labels[inner]
        self.assertIn("components", self.spoilt(self.ball, change))

    def test_region_without_faces(self):
        def change(diagram):
            diagram["face_labels"] = [0 if label == 1 else label for label in diagram["face_labels"]]
        self.spoilt(self.ball, change)

    def test_area(self):
        def change(diagram):
            diagram["cells"][2]["area"] *= 1 + 1e-7
        self.assertIn("area", self.spoilt(self.ball, change))

    def test_distance_of_a_vertex(self):
        for factor in (0.9, 1.1):
            def change(diagram):
                diagram["vertex_distances"][50] *= factor
            self.spoilt(self.ball, change)

    def test_exact_distance_on_a_flat_sheet(self):
        def change(diagram):
            diagram["vertex_distances"][50] *= 1 + 1e-3
        self.assertIn("instead of", self.spoilt(self.sheet, change))

    def test_unreached_vertex(self):
        def change(diagram):
            diagram["vertex_distances"][50], diagram["vertex_labels"][50] = None, -1
        self.spoilt(self.ball, change)

    def test_bisector_of_another_generator(self):
        def change(diagram):
            bisector = diagram["bisectors"][0]
            bisector["left"] = next(g for g in range(7) if g not in (bisector["left"], bisector["right"]))
        self.spoilt(self.ball, change)
        self.spoilt(self.sheet, change)

    def test_point_off_the_surface(self):
        def change(diagram):
            diagram["bisectors"][0]["points"][1]["position"][2] += 1e-4
        self.assertIn("not where", self.spoilt(self.ball, change))

    def test_branch_point_off_the_surface(self):
        def change(diagram):
            diagram["branch_points"][1]["position"][2] += 1e-4
        self.assertIn("not where", self.spoilt(self.ball, change))

    def test_piece_of_another_cell(self):
        def change(diagram):
            labels = diagram["cut_mesh"]["labels"]
            labels[5] = (labels[5] + 1) % 7
        self.assertIn("area", self.spoilt(self.cut, change))

    def test_lost_piece(self):
        def change(diagram):
            for name in ("faces", "labels", "parents"):
                diagram["cut_mesh"][name].pop()
        self.spoilt(self.cut, change)


class OtherCase(unittest.TestCase):
    def test_energy_that_rises(self):
        outputs = Outputs("ball", "lloyd", "-n", "7", "--iterations", "3")
        points = outputs.written["generators"]
        for change in (lambda e: e.__setitem__(-1, e[0] * 2), lambda e: e.pop()):
            report = copy.deepcopy(outputs.report)
            change(report["results"]["energies"])
            self.assertRaises(Finding, check_lloyd, outputs.surface, points, report, 7)
        self.assertRaises(Finding, check_lloyd, outputs.surface, points[1:], outputs.report, 7)
        self.assertRaises(Finding, check_lloyd, outputs.surface, points[1:] + points[1:2], outputs.report, 7)

    def test_coarse_mesh_with_another_topology(self):
        outputs = Outputs("torus", "remesh", "-n", "40")
        coarse = outputs.coarse
        with_hole = Surface(coarse.points, coarse.faces[1:])
        turned = Surface(coarse.points, [coarse.faces[0][::-1]] + coarse.faces[1:])
        ball = Outputs("ball", "remesh", "-n", "40").coarse
        for wrong in (with_hole, turned, ball):
            self.assertRaises(Finding, check_remesh, outputs.surface, wrong, outputs.report)

    def test_map_with_a_wrong_point(self):
        outputs = Outputs("torus", "remesh", "-n", "40")
        for change in (lambda m: m["input_vertices"].pop(), lambda m: m["input_vertices"][3].update(face=10000),
                       lambda m: m["output_vertices"][0].update(bary=[1, 1, -1]), lambda m: m.update(one_to_one=False)):
            wrong = copy.deepcopy(outputs.map)
            change(wrong)
            self.assertRaises(Finding, check_map, outputs.mesh, outputs.coarse, wrong)

    def test_topology_of_known_surfaces(self):
        known = {"triangle": [(1, 1)], "tetrahedron": [(2, 0)], "torus": [(0, 0)], "wire": [(0, 2)], "slit": [(1, 1)],
                 "holes": [(-16, 0)], "folded": [(2, 0)], "seam": [(1, 1)], "crowd": [(2, 0)] * 11}
        for name, expected in known.items():
            surface = Surface(MESHES[name].points, MESHES[name].faces)
            surface.require_manifold(name)
            self.assertEqual(surface.topology(), expected, name)

    def test_meshes_that_are_no_manifold(self):
        for name in ("book", "bow_tie", "doubled", "moebius"):
            surface = Surface(MESHES[name].points, MESHES[name].faces)
            self.assertRaises(Finding, surface.require_manifold, name)


class RunCase(unittest.TestCase):
    def run_shell(self, script, faces=10):
        with tempfile.TemporaryDirectory() as folder:
            return run(["sh", "-c", script], folder, faces)

    def test_endings(self):
        self.assertEqual(self.run_shell("true").code, 0)
        self.assertEqual(self.run_shell("echo a message that is long enough >&2; exit 4").code, 4)
        for wrong in ("exit 1", "exit 3", "kill -SEGV $$", "echo x; exit 0", "exit 4", "printf 'a message of\\ntwo lines\\n' >&2; exit 4",
                      "echo a message that is long enough >&2; echo > half; exit 5"):
            with self.subTest(wrong):
                self.assertRaises(Finding, self.run_shell, wrong)

    def test_time(self):
        usual, run_command.FIXED_SECONDS = run_command.FIXED_SECONDS, 1.0
        self.assertRaises(Finding, self.run_shell, "while :; do :; done")
        run_command.FIXED_SECONDS = usual


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
