#!/usr/bin/env python3
"""Draws the energies of relaxations over their iterations, as an SVG: one curve for each report of gvd-lloyd.

    scripts/plot_energies.py OUTPUT.svg REPORT.json...

gvd-lloyd writes the reports with --report. Each curve is named after its option --accelerate. The energies are those of the report,
divided by the lowest one, minus 1, in percent, on a logarithmic scale.
"""
import json
import math
import sys

WIDTH, HEIGHT, LEFT, RIGHT, TOP, BOTTOM = 760, 360, 70, 20, 20, 50
COLOURS = ["#0072b2", "#d55e00", "#555555", "#009e73"]  # told apart by the colour-blind too
DASHES = ["", "8 4", "2 4", "10 3 2 3"]
LEAST, MOST = 0.1, 100.0  # percent
LONGEST = 100  # iterations


def read_curve(path):
    """How a run found its steps, and its energies."""
    with open(path) as file:
        report = json.load(file)
    return report["options"]["accelerate"], report["results"]["energies"][: LONGEST + 1]


def excesses(curves):
    """Percent above the lowest energy of all."""
    lowest = min(min(energies) for _, energies in curves)
    return [(name, [100 * (e / lowest - 1) for e in energies]) for name, energies in curves]


def place(iteration, percent, length):
    share = math.log(max(percent, LEAST) / LEAST) / math.log(MOST / LEAST)
    x = LEFT + (WIDTH - LEFT - RIGHT) * iteration / length
    return x, HEIGHT - BOTTOM - (HEIGHT - TOP - BOTTOM) * min(share, 1)


def axes(length):
    parts = []
    for percent in (0.1, 1, 10, 100):
        x, y = place(0, percent, length)
        parts.append(f'<line x1="{x}" y1="{y:.1f}" x2="{WIDTH - RIGHT}" y2="{y:.1f}" stroke="#cccccc"/>')
        parts.append(f'<text x="{x - 8}" y="{y + 5:.1f}" text-anchor="end">{percent:g} %</text>')
    for iteration in range(0, length + 1, 10):
        x, y = place(iteration, LEAST, length)
        parts.append(f'<text x="{x:.1f}" y="{y + 20:.1f}" text-anchor="middle">{iteration}</text>')
    parts.append(f'<text x="{(LEFT + WIDTH - RIGHT) / 2}" y="{HEIGHT - 8}" text-anchor="middle">iterations</text>')
    return parts


def curve(index, energies, length):
    shown = next((i + 1 for i, e in enumerate(energies) if e < LEAST), len(energies))
    points = " ".join("{:.1f},{:.1f}".format(*place(i, e, length)) for i, e in enumerate(energies[:shown]))
    style = f'stroke="{COLOURS[index % 4]}" stroke-dasharray="{DASHES[index % 4]}"'
    return f'<polyline points="{points}" fill="none" stroke-width="2.5" {style}/>'


def legend(index, name):
    y = TOP + 16 + 20 * index
    style = f'stroke="{COLOURS[index % 4]}" stroke-dasharray="{DASHES[index % 4]}"'
    return [f'<line x1="{WIDTH - 170}" y1="{y}" x2="{WIDTH - 120}" y2="{y}" stroke-width="2.5" {style}/>',
            f'<text x="{WIDTH - 110}" y="{y + 5}">{name}</text>']


def draw(curves):
    length = max(len(energies) for _, energies in curves) - 1
    length = max(10, -(-length // 10) * 10)
    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{HEIGHT}" viewBox="0 0 {WIDTH} {HEIGHT}" '
             'font-family="sans-serif" font-size="14">', f'<rect width="{WIDTH}" height="{HEIGHT}" fill="#ffffff"/>']
    parts += axes(length)
    for index, (name, energies) in enumerate(curves):
        parts.append(curve(index, energies, length))
        parts += legend(index, name)
    return "\n".join([*parts, "</svg>", ""])


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    curves = excesses([read_curve(path) for path in sys.argv[2:]])
    with open(sys.argv[1], "w") as file:
        file.write(draw(curves))


main()
