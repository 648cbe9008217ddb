"""Checks what gvd-lloyd writes: energies that never rise, and as many generators as before, on the surface."""
import math

from check_segment import DISTANCE_ERROR, check_on_surface
from surface import require


def check_lloyd(surface, generators, report, count):
    energies = report["results"]["energies"]
    require(len(energies) == report["results"]["iterations"] + 1, f"{len(energies)} energies")
    for i, (before, after) in enumerate(zip(energies, energies[1:])):
        require(after <= before, f"the energy rises from {before} to {after} in iteration {i + 1}")
    require(all(math.isfinite(e) and e >= 0 for e in energies), f"energies {energies}")
    require(len(generators) == count, f"{len(generators)} generators instead of {count}")
    error = DISTANCE_ERROR * surface.size + 1e3 * surface.rounding
    for point in generators:
        check_on_surface(surface, point, error)
    places = {(g["face"], *g["bary"]) for g in generators}
    require(len(places) == count, "two generators are in one place")
