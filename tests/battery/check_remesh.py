"""Checks what gvd-remesh writes: a manifold with the topology of the input, whose vertices stand for the generators."""
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
