"""Possible reasons for numbers of the paper that are not met."""
import paper.numbers_of_paper as printed
from paper.section import STEPS, WINDOWS, Section, number

NOT_MET = (
    "Each column is an integral along the same bisectors. E: as in section 5.2, by exact distances. Marched: both"
    " distances are those of planar marching from one generator, linear in each face. Whole face: S(p) contains each"
    " generator with a part of the face of p. Distance: the integral of the exact distance to one generator. This is the value of E"
    " if the other distance is missing.",
    "E of [27], .168 on Spot and .151 on Bunny, is close to that of an exact diagram by marched distances (.16 and .12 here). It is"
    " also close to E of a diagram traced from marched distances (.15 to .17, and .12 to .15). So the paper's .168 looks like the"
    " error of planar marching distances, not like that of straight segments between exact crossings, which is .003. On Bear"
    " neither fits. With all generators of a face, E of [27] is .07, because a third generator competes around each branch point; this is"
    " too small. Linear crossings from exact distances of the vertices give .02 on Spot (ten sets, not in the table).",
    "E of LRVD, 7.458 on Spot and 11.310 on Bunny, is the integral of the distance itself, within about 8 %. Here that is 6.9"
    " and 11.2 for these sets of generators. It would result if the second distance were missing, or 0. This is an observation, not a"
    " proof. On Bear, 13.001 is more than twice the integral, and on the sphere .024 is far below it.",
    "The generators do not explain it: for 60 random sets on Spot, E of LRVD is .37 to .61, of RVD .38 to .74, of [27] .0022 to .0040."
    " With all 30 generators within 2, 10 or 30 % of the vertices around a random one (15 sets each), E of LRVD is .04 to .74. The rule for"
    " orphans does not explain it: RVD, without any sweep, has an E of .58 for ten sets. Nor does the unit of length: one that makes LRVD"
    " fit on Spot would make E of growth eleven times the paper's.",
    "With the generators of another test of this mesh, E on Spot is .216 by --method paper and .173 by planar growth; the paper has .205.",
)


def numbers_not_met(rows):
    """Possible reasons for the paper's E of [27] and of LRVD. Each row has other quantities that could be taken for E."""
    section = Section("Numbers that are not met, and possible reasons")
    head = ["model", "mesh", "method", "E", "marched", "whole face", "distance", "paper's E"]
    lines = []
    for row in rows:
        mesh = f"{row['mesh']}, {row['faces']} faces, m = {row['m']}"
        theirs, ours = (figures[3] for figures in printed.WINDOWS[row["model"]][2:])
        quoted = {STEPS: ours, WINDOWS: theirs, "LRVD [28]": printed.STRAIGHT_DISTANCES[row["model"].lower()][0]}
        for one in row["methods"]:
            figures = [one[name] for name in ("e", "by_marching", "of_face", "distance")]
            lines.append([row["model"], mesh, one["method"]] + [number(x) for x in figures] + [number(quoted.get(one["method"]))])
            mesh = ""
    section.tabulate(head, lines)
    for text in NOT_MET:
        section.say(text)
    return section
