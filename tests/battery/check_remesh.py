"""Checks what gvd-remesh writes: a manifold with the topology of the input, whose vertices stand for the generators; its map."""
import math

from surface import require


def check_remesh(surface, coarse, report):
    coarse.require_manifold("the coarse mesh")
    require(coarse.topology() == surface.topology(), f"topology {coarse.topology()} instead of {surface.topology()}")
    for f in range(len(coarse.faces)):
        require(coarse.area(f) > 0, f"face {f} of the coarse mesh has no area")
    generators = report["generators"]
    require(len(generators) == len(coarse.points), f"{len(coarse.points)} vertices for {len(generators)} generators")
    if report["options"]["place"] == "generator":
        places = {tuple(g["position"]) for g in generators}
        require(all(p in places for p in coarse.points), "a vertex is no generator")
    require(all(math.isfinite(x) for p in coarse.points for x in p), "a coordinate is not finite")


def check_map(mesh, coarse, written):
    """Every vertex has a point of the other mesh. Copies of a vertex that the repair cut have none of their own."""
    require(written["one_to_one"] == (written["obstacle"] is None), "a one-to-one map with an obstacle, or another one without")
    require(len(written["output_vertices"]) == len(coarse.points), "a vertex of the output has no point")
    require(len(written["input_vertices"]) == len(mesh.points), "a vertex of the input has no entry")
    points = written["input_vertices"]
    for point in written["output_vertices"] + [p for p in points if p is not None]:
        bary = point["bary"]
        require(min(bary) >= 0 and abs(sum(bary) - 1) < 1e-12, f"{bary} are no barycentric coordinates")
    faces = len(coarse.faces)
    require(all(p is None or 0 <= p["face"] < faces for p in points), "a point is in no face")
