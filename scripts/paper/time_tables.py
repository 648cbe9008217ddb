"""Tables 1 and 2: times and memory."""
import paper.numbers_of_paper as printed
from paper.section import Section, number


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
    " methods includes the cells with their areas, that of [27] does not. Memory is the peak of the heap without the input mesh. The paper"
    " does not say what it counts; its numbers are smaller than its meshes."
)


def table_1(rows):
    section = Section("Table 1: Kitten, 50 generators, increasing number of faces")
    head = ["faces, m", "mesh", "method", "GDF ms", "VD ms", "total ms", "memory KB"]
    section.tabulate(head, list(time_rows(rows, printed.RESOLUTIONS, "{} faces, m = 50")))
    areas = [row["area"] for row in rows]
    section.say("The meshes are resampled by the isotropic remeshing of this repository, to within 3 % of the paper's sizes. Vertices lie"
                f" on the model's surface, and the areas differ by at most {100 * (max(areas) / min(areas) - 1):.1f} %.")
    section.plot("Total milliseconds by number of faces", "faces", time_series(rows, printed.RESOLUTIONS, "faces"))
    section.say(TIMES_NOTE)
    return section


def table_2(rows):
    section = Section("Table 2: Spot, increasing number of generators")
    head = ["faces, m", "mesh", "method", "GDF ms", "VD ms", "total ms", "memory KB"]
    section.tabulate(head, list(time_rows(rows, printed.GENERATOR_COUNTS, "20000 faces, m = {}")))
    series = time_series(rows, printed.GENERATOR_COUNTS, "m")
    section.plot("Total milliseconds by number of generators", "m", series)
    section.say(TIMES_NOTE)
    return section
