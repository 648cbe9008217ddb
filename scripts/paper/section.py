"""What the pages consist of, and how they write numbers."""
import math

STEPS, PLANAR, CIRCLE, EXACT = "paper's steps", "gbgvd planar", "gbgvd circle", "exact"
WINDOWS, UNPRUNED = "windows [27]", "unpruned [27]"
DIFFUSION, RVD, LRVD = "diffusion [8]", "RVD [29]", "LRVD [28]"
SPOKEN = {STEPS: "the paper's steps", PLANAR: "planar growth", CIRCLE: "circle fronts", EXACT: "exact bisectors", WINDOWS: "[27]",
          UNPRUNED: "[27] without pruning", DIFFUSION: "diffusion", RVD: "RVD", LRVD: "LRVD"}


def number(value, digits=3):
    """A number with `digits` significant digits; a dash where the paper has none."""
    if value is None:
        return "–"
    if not math.isfinite(value):
        return "infinite"
    if value == 0:
        return "0"
    if abs(value) < 1e-3:
        return f"{value:.{digits - 1}e}"
    return f"{value:.{max(0, digits - 1 - math.floor(math.log10(abs(value))))}f}"


def spread(e):
    if e["mean"] is None:
        return number(math.inf)
    return f"{number(e['mean'])} ± {number(e['sd'], 2)}" if e["sd"] else number(e["mean"])


def methods_of(row):
    return {one["method"]: one for one in row["methods"]}


def span(values, digits=2):
    """The smallest to the largest value; one number where they round to the same."""
    least, most = number(min(values), digits), number(max(values), digits)
    return least if least == most else f"{least} to {most}"


def ratios(rows, over, under, figure):
    """A figure of one method over that of another in each row: E or a time. Rows without the second have none."""
    pairs = [(figure(methods_of(row)[over]), figure(methods_of(row)[under])) for row in rows]
    return [a / b for a, b in pairs if b]


def error_of(method):
    """The mean of E. JSON has no infinity: it writes null, where a cell lies on a component that its generator can't reach."""
    return math.inf if method["e"]["mean"] is None else method["e"]["mean"]


def time_of(method):
    return method["total_ms"]


def join(names):
    """Words with commas and an "and"."""
    names = list(names)
    return names[0] if len(names) == 1 else ", ".join(names[:-1]) + " and " + names[-1]


def mesh_name(row):
    return f"{row['mesh']}, {row['faces']} faces, m = {row['m']}"


class Section:
    """A heading, sentences, tables and plots, in order."""

    def __init__(self, title):
        self.title = title
        self.blocks = []

    def say(self, text):
        self.blocks.append(("text", text))

    def tabulate(self, head, rows):
        self.blocks.append(("table", (head, rows)))

    def show(self, names):
        self.blocks.append(("pictures", names))

    def compare(self, captioned):
        """Pictures in a row: pairs of a caption and a name."""
        self.blocks.append(("row", captioned))

    def plot(self, caption, x_label, series):
        self.blocks.append(("plot", (caption, x_label, series)))
