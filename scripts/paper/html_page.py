"""The sections as HTML, with plots."""
import html
import math

from paper.gallery import page_of, picture
from paper.section import CIRCLE, DIFFUSION, EXACT, PLANAR, STEPS, WINDOWS

COLOURS = {"paper": "#777777", STEPS: "#8e44ad", PLANAR: "#c0392b", CIRCLE: "#e08e0b", EXACT: "#1f6fb2", WINDOWS: "#2e8b57",
           DIFFUSION: "#8b5a2b"}


def scale_of(values):
    """A function from values to 0..1, logarithmic, with the powers of ten as ticks."""
    low, high = math.floor(math.log10(min(values))), math.ceil(math.log10(max(values)))
    high = max(high, low + 1)
    return lambda value: (math.log10(value) - low) / (high - low), [10.0 ** i for i in range(low, high + 1)]


def to_svg(caption, x_label, series):
    width, height, left, bottom = 640, 360, 60, 40
    points = [point for line in series.values() for point in line]
    x_of, x_ticks = scale_of([x for x, _ in points])
    y_of, y_ticks = scale_of([y for _, y in points])

    def place(x, y):
        return left + x_of(x) * (width - left - 150), (1 - y_of(y)) * (height - bottom - 20) + 20

    parts = [f'<svg viewBox="0 0 {width} {height}" role="img" aria-label="{html.escape(caption)}">']
    for tick in x_ticks:
        x, y = place(tick, y_ticks[0])
        parts.append(f'<text x="{x:.0f}" y="{y + 16:.0f}" text-anchor="middle">{tick:g}</text>')
    for tick in y_ticks:
        x, y = place(x_ticks[0], tick)
        parts.append(f'<path d="M{x:.0f} {y:.0f}H{width - 150}" stroke="#dddddd"/>')
        parts.append(f'<text x="{x - 6:.0f}" y="{y + 4:.0f}" text-anchor="end">{tick:g}</text>')
    parts.append(f'<text x="{(left + width - 150) / 2}" y="{height - 4}" text-anchor="middle">{html.escape(x_label)}</text>')
    for i, (name, line) in enumerate(series.items()):
        colour = COLOURS.get(name, "#000000")
        path = "L".join("{:.1f} {:.1f}".format(*place(x, y)) for x, y in sorted(line))
        parts.append(f'<path d="M{path}" fill="none" stroke="{colour}" stroke-width="2"/>')
        parts.append(f'<text x="{width - 140}" y="{30 + 18 * i}" fill="{colour}">{html.escape(name)}</text>')
    return "".join(parts) + "</svg>"


STYLE = """body{font:15px/1.45 sans-serif;max-width:80rem;margin:2rem auto;padding:0 1rem}
table{border-collapse:collapse;margin:1rem 0;display:block;overflow-x:auto}
td,th{padding:.2rem .6rem;border-bottom:1px solid #ddd;text-align:right;white-space:nowrap}
td:nth-child(-n+3),th:nth-child(-n+3){text-align:left}
td:nth-child(2),th{white-space:normal}td:nth-child(2){max-width:13rem}
.row{display:flex;flex-wrap:wrap;gap:1rem}.row figure{margin:0}figcaption{color:#555}
figure{margin:1rem 0}svg{max-width:44rem;font-size:12px}"""


def to_html(sections, introduction):
    parts = ["<!doctype html><html lang='en'><meta charset='utf-8'><title>Section 5 of the paper, measured</title>",
             f"<style>{STYLE}</style><h1>Section 5 of the paper, measured</h1><p>{html.escape(introduction)}</p>"]
    for section in sections:
        parts.append(f"<h2>{html.escape(section.title)}</h2>")
        for kind, content in section.blocks:
            if kind == "text":
                parts.append(f"<p>{html.escape(content)}</p>")
            elif kind == "plot":
                parts.append(f"<figure>{to_svg(*content)}<figcaption>{html.escape(content[0])}</figcaption></figure>")
            elif kind == "row":
                parts.append("<div class='row'>")
                parts += [f"<figure><a href='pages/{page_of(name)}.html'>{picture(name)}</a>"
                          f"<figcaption>{html.escape(caption)}</figcaption></figure>" for caption, name in content]
                parts.append("</div>")
            elif kind == "pictures":
                parts += [f"<a href='pages/{name}.html'>{picture(name)}</a>" for name in content]
            else:
                head, rows = content
                cells = ["".join(f"<th>{html.escape(cell)}</th>" for cell in head)]
                cells += ["".join(f"<td>{html.escape(cell)}</td>" for cell in row) for row in rows]
                parts.append("<table>" + "".join(f"<tr>{row}</tr>" for row in cells) + "</table>")
    return "\n".join(parts) + "\n</html>\n"
