"""Tables 1 and 2 and figure 1: times and memory."""
import paper.numbers_of_paper as printed
from paper.section import PLANAR, SPOKEN, STEPS, WINDOWS, Section, join, methods_of, number, ratios, span, time_of

HEAD = ["faces, m", "mesh", "method", "GDF ms", "VD ms", "total ms", "memory KB"]


def time_rows(rows, numbers, size_format):
    """Lines of GDF, bisector, total and memory. The rows are in the order of the paper's, of other sizes where meshes are."""
    for row, (size, figures) in zip(rows, numbers.items()):
        yield [size_format.format(size), "", "paper"] + [number(value) for value in figures]
        name = f"{row['faces']} faces, m = {row['m']}"
        mesh = row["mesh"]
        for method in row["methods"]:
            figures = [method[figure] for figure in ("gdf_ms", "vd_ms", "total_ms", "memory_kb")]
            yield [name, mesh, method["method"]] + [number(value) for value in figures]
            name = mesh = ""


def time_series(rows, numbers, key):
    series = {"paper": [(x, values[2]) for x, values in numbers.items()]}
    for row in rows:
        for method in row["methods"]:
            series.setdefault(method["method"], []).append((row[key], method["total_ms"]))
    return series


TIMES_NOTE = (
    "Times are processor times of one thread, on a different machine than the paper's: compare their growth, not their size. VD of our"
    " methods includes the cells with their areas, that of [27] does not. Memory is the peak of the heap without the input mesh."
)

# A closed mesh has half as many vertices as faces: three doubles for each, and three 32-bit indices for each face.
MESH_BYTES_PER_FACE = 24


def compare_memory(numbers, faces_of):
    """What the paper's memory can't contain. `faces_of` gives the paper's number of faces for a row."""
    below = [memory for size, (*_, memory) in numbers.items() if memory * 1024 < MESH_BYTES_PER_FACE * faces_of(size)]
    return (f"The paper does not say what it counts. A closed mesh takes {MESH_BYTES_PER_FACE} bytes a face, with coordinates as doubles"
            f" and 32-bit indices. Of the paper's {len(numbers)} numbers here, {len(below)} are below that of their mesh.")


def say_growth(rows):
    """How many times as long the last row's distances take as the first row's."""
    first, *_, last = printed.RESOLUTIONS.values()
    growth = [f"that of {SPOKEN[name]} {number(methods_of(rows[-1])[name]['gdf_ms'] / methods_of(rows[0])[name]['gdf_ms'])} times"
              for name in (STEPS, PLANAR, WINDOWS)]
    return (f"From the first row to the last, the paper's GDF becomes {number(last[0] / first[0])} times as long; here"
            f" {join(growth)}.")


def compare_speeds(rows, label):
    """How many times as long as the paper's steps and planar growth [27] takes, and the rows in which it is faster."""
    found = {name: ratios(rows, WINDOWS, name, time_of) for name in (STEPS, PLANAR)}
    text = f"Here, [27] takes in total {join(f'{span(values)} times as long as {SPOKEN[name]}' for name, values in found.items())}."
    for name, values in found.items():
        slower = [label.format(**row) for row, factor in zip(rows, values) if factor < 1]
        text += f" It is faster than {SPOKEN[name]} at {join(slower)}." if slower else ""
    return text


def table_1(rows):
    section = Section(f"Table 1: Kitten, {printed.GENERATORS_OF_TABLE_1} generators, increasing number of faces")
    section.tabulate(HEAD, list(time_rows(rows, printed.RESOLUTIONS, f"{{}} faces, m = {printed.GENERATORS_OF_TABLE_1}")))
    areas = [row["area"] for row in rows]
    off = [abs(row["faces"] / faces - 1) for row, faces in zip(rows, printed.RESOLUTIONS)]
    section.say(f"The meshes are resampled by the isotropic remeshing of this repository, to within {100 * max(off):.1f} % of the"
                " paper's sizes. Vertices lie on the model's surface, and the areas differ by at most"
                f" {100 * (max(areas) / min(areas) - 1):.1f} %.")
    section.plot("Total milliseconds by number of faces", "faces", time_series(rows, printed.RESOLUTIONS, "faces"))
    section.say(f"{say_growth(rows)} {compare_speeds(rows, '{faces} faces')}")
    section.say(f"{TIMES_NOTE} {compare_memory(printed.RESOLUTIONS, lambda size: size)}")
    return section


def table_2(rows):
    section = Section("Table 2: Spot, increasing number of generators")
    section.tabulate(HEAD, list(time_rows(rows, printed.GENERATOR_COUNTS, f"{printed.FACES_OF_TABLE_2} faces, m = {{}}")))
    series = time_series(rows, printed.GENERATOR_COUNTS, "m")
    section.plot("Total milliseconds by number of generators", "m", series)
    section.say(compare_speeds(rows, "m = {m}"))
    section.say(f"{TIMES_NOTE} {compare_memory(printed.GENERATOR_COUNTS, lambda _: printed.FACES_OF_TABLE_2)}")
    return section


def figure_1(rows_of_table_4):
    """Lucy is a model of table 4, with more generators than figure 1 names."""
    row, = (row for row in rows_of_table_4 if row["model"] == "Lucy")
    seconds, percent = printed.LUCY
    faces, m, _, (*_, total, _) = printed.WINDOWS["Lucy"]
    times = [f"{number(methods_of(row)[name]['total_ms'])} ms with {SPOKEN[name]}" for name in (STEPS, PLANAR, WINDOWS)]
    section = Section("Figure 1: Lucy")
    section.say(f"Figure 1 gives {seconds} seconds for its diagram, and {percent} % of triangles with an angle below 30 degrees."
                f" Table 4 gives {number(total)} ms, with {m} generators on {faces} faces. Here, {row['percent_below_30']:.1f} % of"
                f" the {row['faces']} triangles of {row['mesh']} have such an angle. The diagram of {row['m']}"
                f" generators takes {join(times)}, on another machine than the paper's.")
    return section
