"""Possible reasons for numbers of the paper that are not met."""
import math

import paper.numbers_of_paper as printed
from paper.section import (CIRCLE, EXACT, LRVD, PLANAR, RVD, STEPS, WINDOWS, Section, error_of, join, mesh_name, methods_of, number,
                           ratios)

COLUMNS = {"E": error_of, "marched": lambda one: one["by_marching"], "whole face": lambda one: one["of_face"],
           "distance": lambda one: one["distance"]}

COLUMNS_NOTE = (
    "Each column is an integral along the same bisectors. E: as in section 5.2, by exact distances. Marched: both"
    " distances are those of planar marching from one generator, linear in each face. Whole face: S(p) contains each"
    " generator with a part of the face of p. Distance: the integral of the exact distance to one generator. This is the value of E"
    " if the other distance is missing."
)

READING = (
    "Where \"marched\" is the nearest to [27], the paper's number looks like an error of marched distances. The only error of [27] here are"
    " its straight segments between exact crossings. Where \"distance\" is the nearest to LRVD, the second distance may have been missing"
    " in the paper, or 0. These are observations, not proofs."
)


def printed_errors(model):
    """The paper's E of its method, of [27] and of LRVD."""
    theirs, ours = (figures[3] for figures in printed.WINDOWS[model][2:])
    return {STEPS: ours, WINDOWS: theirs, LRVD: printed.STRAIGHT_DISTANCES[model.lower()][0]}


def nearest(row, name, methods):
    """A line with that of our figures of some methods which is nearest to the paper's E of a method."""
    quoted = printed_errors(row["model"])[name]
    _, value, method, column = min((abs(math.log(value / quoted)), value, method, column) for method in methods
                                   for column, take in COLUMNS.items() if (value := take(methods_of(row)[method])) > 0)
    own = error_of(methods_of(row)[name])
    return [row["model"], name, number(quoted), number(own), number(quoted / own), number(value), f"{column}, {method}"]


def tell_units(rows):
    """What the unknown unit of length can't explain."""
    steps = [printed_errors(row["model"])[STEPS] / error_of(methods_of(row)[STEPS]) for row in rows]
    found = [printed_errors(row["model"])[LRVD] / error_of(methods_of(row)[LRVD]) / ours for row, ours in zip(rows, steps)]
    return ("This holds if the paper's meshes have the size of ours. The paper's E of its own method is"
            f" {join(number(x) for x in steps)} times that of the paper's steps here, on {join(row['model'] for row in rows)}. In units"
            f" in which E of LRVD is met, E of the paper's steps would be {join(number(x) for x in found)} times the paper's.")


def tell_sweeps(rows):
    found = join(number(x) for x in ratios(rows, RVD, LRVD, error_of))
    return f"The sweep of LRVD explains none of it: RVD has no sweep, and its E is {found} times that of LRVD."


def numbers_not_met(rows_of_table_5):
    """Possible reasons for the paper's E of [27] and of LRVD. Each row has other quantities that could be taken for E."""
    rows = [row for row in rows_of_table_5 if row["model"] in printed.WINDOWS]
    section = Section("Numbers that are not met, and possible reasons")
    lines = []
    for row in rows:
        mesh, quoted = mesh_name(row), printed_errors(row["model"])
        for name in (STEPS, PLANAR, CIRCLE, EXACT, WINDOWS, RVD, LRVD):
            one = methods_of(row)[name]
            lines.append([row["model"], mesh, name] + [number(take(one)) for take in COLUMNS.values()] + [number(quoted.get(name))])
            mesh = ""
    section.tabulate(["model", "mesh", "method", *COLUMNS, "paper's E"], lines)
    section.say(COLUMNS_NOTE)
    near = [nearest(row, WINDOWS, (WINDOWS, EXACT, PLANAR, STEPS)) for row in rows] + [nearest(row, LRVD, (RVD, LRVD)) for row in rows]
    section.say("The next table has, for each E that is not met, the nearest one of these figures. The last column names it. For [27] it"
                " is one of the methods with exact or marched distances, for LRVD one of those with straight distances.")
    section.tabulate(["model", "method", "paper's E", "E", "paper's / ours", "nearest", "which"], near)
    section.say(READING)
    section.say(f"{tell_units(rows)} {tell_sweeps(rows)}")
    return section
