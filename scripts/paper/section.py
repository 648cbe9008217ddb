"""What the pages consist of, and how they write numbers."""
import math

STEPS, PLANAR, CIRCLE, EXACT = "paper's steps", "gbgvd planar", "gbgvd circle", "exact"
WINDOWS, UNPRUNED = "windows [27]", "unpruned [27]"


def number(value, digits=3):
    """A number with `digits` significant digits; a dash where the paper has none."""
    if value is None:
        return "–"
    if value == 0:
        return "0"
    if abs(value) < 1e-3:
        return f"{value:.{digits - 1}e}"
    return f"{value:.{max(0, digits - 1 - math.floor(math.log10(abs(value))))}f}"


def spread(e):
    if e["mean"] is None:
        return "infinite"
    return f"{number(e['mean'])} ± {number(e['sd'], 2)}" if e["sd"] else number(e["mean"])


def methods_of(row):
    return {one["method"]: one for one in row["methods"]}


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
