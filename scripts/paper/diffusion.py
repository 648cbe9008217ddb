"""Figure 10 and section 5.4: the diffusion diagram."""
import paper.numbers_of_paper as printed
from paper.error_tables import low_over_high
from paper.section import DIFFUSION, PLANAR, SPOKEN, STEPS, Section, join, mesh_name, methods_of, number, span, spread


def figure_10(rows):
    section = Section("Figure 10: zig-zag of bisectors")
    head = ["model", "mesh", "method", "turning angle / length", "E"]
    lines = []
    for row in rows:
        for method in row["methods"]:
            lines.append([row["model"], mesh_name(row), method["method"], number(method["turn_per_length"]), spread(method["e"])])
    section.tabulate(head, lines)
    section.say("The turning angle is the sum of the angles by which the bisectors turn, in radians per unit of length. The paper"
                " only shows a picture.")
    return section


def compare_sizes(rows):
    """The claim that more than 10K vertices are hard to factorise, beside the meshes of table 1."""
    large = [row for row in rows if row["vertices"] > printed.FACTORISABLE_VERTICES]
    if not large:
        return ""
    first, last = large[0], large[-1]
    gdf = [number(methods_of(row)[DIFFUSION]["gdf_ms"]) for row in (first, last)]
    memory = [number(methods_of(row)[DIFFUSION]["memory_kb"] / 1024) for row in (first, last)]
    slower = [methods_of(row)[DIFFUSION]["gdf_ms"] / methods_of(row)[STEPS]["gdf_ms"] for row in large]
    return (f"The paper says that with more than {printed.FACTORISABLE_VERTICES} vertices the factorisation is hard, of a large dense"
            " matrix. The matrix is sparse: a row has an entry for each neighbour. On the meshes of table 1 with"
            f" {first['vertices']} to {last['vertices']} vertices, factorisation and {last['m']} solutions take {gdf[0]} to {gdf[1]} ms,"
            f" {span(slower)} times the GDF of the paper's steps. The heap's peak is {memory[0]} to {memory[1]} MB.")


def compare_triangles(rows):
    """The claim that diffusion is weak on poor triangles, beside table 3."""
    found = [f"{span(low_over_high(rows, name))} with {SPOKEN[name]}" for name in (DIFFUSION, STEPS, PLANAR)]
    return ("The paper calls diffusion weak on poor triangles. In our table 3, E on low quality, divided by E on high quality, is"
            f" {join(found)}.")


def compare_crowds(rows):
    """The claim that diffusion may fail with many generators in one triangle."""
    def worst(name, figure):
        return number(max(methods_of(row)[name][figure] for row in rows), 2)

    return ("The paper says that diffusion may fail if many generators lie in one triangle. Here they become vertices first, which splits"
            f" the triangle, and each run ends with a diagram. But diffusion leaves up to {worst(DIFFUSION, 'islands')} islands, and"
            f" {worst(DIFFUSION, 'wrong_percent')} % of the vertices with a wrong label. With the paper's steps, whose cells are connected,"
            f" {worst(STEPS, 'wrong_percent')} % have a wrong label. A third claim, that dominated parts are hard to control, is not measured.")


DIFFERENCES = (
    "Our diffusion differs from what the paper says of [8]. The paper takes the heat for a distance that is linear along each edge. By"
    " its abstract, [8] compares heat and no derived distance; ours does so, with heat linear in each face. By the paper, [8] splits"
    " triangles until the change of distance is linear. Ours has no such test: it splits until corners and midpoints have two labels,"
    " and no more than five times."
)


def section_5_4(tables):
    section = Section("Section 5.4: diffusion on large meshes, poor triangles and crowded generators")
    lines = [[row["model"], mesh_name(row), method["method"], f"{method['wrong_percent']:.1f} %", number(method["islands"]),
              spread(method["e"])] for row in tables["crowd"] for method in row["methods"]]
    section.tabulate(["model", "mesh, m in one triangle", "method", "wrong labels", "islands", "E"], lines)
    for text in (compare_crowds(tables["crowd"]), compare_sizes(tables["1"]), compare_triangles(tables["3"]), DIFFERENCES):
        if text:
            section.say(text)
    return section
