"""What the battery runs on each mesh: commands with options, and the check of what they write."""
import json
import math
import random

from check_lloyd import check_lloyd
from check_remesh import check_map, check_remesh
from check_segment import check_segment
from run_command import DONE, NO_VALID_RESULT, run
from surface import Finding, Surface, read_off, read_ply, require


class Case:
    """A command with options. `also` lists exit codes that are right beside 0; `few` runs it in the part for CI as well."""

    def __init__(self, command, options, few=False, also=(), method="exact"):
        self.command, self.options, self.few, self.also, self.method = command, options, few, also, method

    def __str__(self):
        return f"gvd-{self.command} {' '.join(self.options)}"


def cases(mesh, seed):
    """The cases of one mesh. Options with a seed are repeated for each seed."""
    scattered = ["--sampling", "random", "--seed", str(seed)]
    faces = len(mesh.faces)
    few, many = ["-n", str(min(7, faces))], ["-n", str(min(60, faces))]
    yield Case("segment", few + scattered, few=True)
    yield Case("segment", few + scattered + ["--cut"], few=True)
    yield Case("segment", many + scattered + ["--labels", "nearest"])
    yield Case("segment", many + scattered + ["--cut", "--threads", "2"])
    yield Case("segment", few + scattered + ["--method", "gbgvd"], method="gbgvd")
    yield Case("lloyd", few + scattered + ["--iterations", "4"], few=True)
    yield Case("lloyd", many + scattered + ["--iterations", "10", "--accelerate", "none"])
    # The dual of a diagram may need more generators than are allowed: exit 5 is right then, broken meshes are not.
    yield Case("remesh", few + scattered + ["--max-added", "40"], few=True, also=(NO_VALID_RESULT,))
    yield Case("remesh", many + scattered + ["--max-added", "200"], also=(NO_VALID_RESULT,))


# Fraction of the size: generators that are nearer, and not in one place, are at the limit that docs/guide/generators.md states.
LEAST_DISTANCE = 1e-4
# Vertices as generators: as many as let a mesh of some hundred faces have several in most faces.
MOST_VERTICES = 150


def scattered_vertices(mesh):
    """Vertices as generators: neighbours, some in one place where the mesh is torn or folded. Their order decides ties: it is random."""
    if not isinstance(mesh.points, list):
        return []
    least = LEAST_DISTANCE * math.dist(*([side(p[k] for p in mesh.points) for k in range(3)] for side in (min, max)))
    order = random.Random(len(mesh.points)).sample(range(len(mesh.points)), len(mesh.points))
    chosen = []
    for v in order:
        gaps = [math.dist(mesh.points[v], mesh.points[w]) for w in chosen]
        if len(chosen) < MOST_VERTICES and all(gap == 0 or gap > least for gap in gaps):
            chosen.append(v)
    return chosen


def fixed_cases(mesh):
    """Those that do not depend on a seed."""
    points = len(mesh.points)
    yield Case("segment", ["-n", "1"], few=True)
    yield Case("segment", ["-n", str(min(12, len(mesh.faces)))])
    chosen = scattered_vertices(mesh)
    if chosen:
        # A vertex may be in no face of a broken mesh.
        yield Case("segment", ["--vertices", ",".join(map(str, chosen)), "--merge-coincident"], few=True, also=mesh.refused)
    yield Case("remesh", ["-n", str(min(30, points))], also=(NO_VALID_RESULT,))


def outputs(case):
    return ["-o", "out.off", "--map", "map.json"] if case.command == "remesh" else ["-o", "out.json"]


def check_outputs(mesh, surface, case, folder):
    """Reads what a command has written, and checks it."""
    report = json.loads((folder / "report.json").read_text())
    require(report["input"]["faces"] == len(surface.faces), "the report counts other faces")
    if case.command == "remesh":
        coarse = read_off(folder / "out.off")
        check_remesh(surface, coarse, report)
        return check_map(mesh, coarse, json.loads((folder / "map.json").read_text()))
    written = json.loads((folder / "out.json").read_text())
    if case.command == "lloyd":
        return check_lloyd(surface, written["generators"], report, len(report["generators"]))
    check_segment(mesh, surface, written, report, case.method)


def run_case(mesh, surface, case, bin_folder, folder):
    """Runs and checks one case. Returns the Ending. Raises a Finding."""
    arguments = [str(bin_folder / f"gvd-{case.command}"), "in.off", "-q", *case.options, *outputs(case), "--report", "report.json"]
    if "--threads" not in case.options:
        arguments += ["--threads", "1"]
    ending = run(arguments, folder, len(surface.faces))
    if ending.code == DONE:
        check_outputs(mesh, surface, case, folder)
    elif ending.code not in (*case.also, *mesh.refused):
        raise Finding(f"refused: {ending.message.strip()}")
    return ending


def repaired_surface(mesh, bin_folder, folder):
    """The surface as the commands repair it, checked, or None where they refuse it."""
    arguments = [str(bin_folder / "gvd-segment"), "in.off", "-q", "-n", "1", "--ascii-ply", "-o", "whole.ply"]
    ending = run(arguments, folder, len(mesh.faces))
    if ending.code != DONE:
        require(ending.code in mesh.refused, f"refused: {ending.message.strip()}")
        return None
    surface, _ = read_ply(folder / "whole.ply")
    surface.require_manifold("the repaired mesh")
    return surface
