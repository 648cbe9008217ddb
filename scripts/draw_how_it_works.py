#!/usr/bin/env python3
"""Draws the diagrams of docs/developer/how-it-works.md from their geometry: draw_how_it_works.py FOLDER

Each picture is computed: the light of a source through an edge, the lower envelope of distances, points of equal distance in a
triangle, and the Voronoi cells of a few points with their dual. Only Python's own library is used.
"""
import math
import pathlib
import sys

INK, GREY, PALE = "#1f2933", "#8795a1", "#dde3e8"
BLUE, ORANGE, GREEN = "#2f6fb7", "#d9822b", "#3d9a6a"
TINT = {BLUE: "#c9dcf1", ORANGE: "#f8dfc2", GREEN: "#cdeadb"}


class Picture:
    """An SVG picture. Coordinates have y upwards; `scale` is in pixels."""

    def __init__(self, width, height, scale):
        self.size, self.scale, self.parts = (width, height), scale, []

    def at(self, p):
        return f"{p[0] * self.scale:.1f},{self.size[1] - p[1] * self.scale:.1f}"

    def path(self, points, colour=INK, width=1.5, fill="none", close=False, dash=""):
        steps = "M" + " L".join(self.at(p) for p in points) + ("Z" if close else "")
        dashed = f' stroke-dasharray="{dash}"' if dash else ""
        self.parts.append(f'<path d="{steps}" fill="{fill}" stroke="{colour}" stroke-width="{width}"{dashed} stroke-linejoin="round"/>')

    def dot(self, p, colour=INK, radius=4.5):
        x, y = self.at(p).split(",")
        self.parts.append(f'<circle cx="{x}" cy="{y}" r="{radius}" fill="{colour}" stroke="#fff" stroke-width="1.2"/>')

    def text(self, p, words, colour=INK, anchor="middle"):
        x, y = self.at(p).split(",")
        self.parts.append(f'<text x="{x}" y="{y}" fill="{colour}" text-anchor="{anchor}" font-size="14" '
                          f'font-family="DejaVu Sans, Helvetica, Arial, sans-serif">{words}</text>')

    def write(self, file):
        width, height = self.size
        file.write_text(f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" height="{height}">\n'
                        f'<rect width="{width}" height="{height}" fill="#fff"/>\n' + "\n".join(self.parts) + "\n</svg>\n")


def between(a, b, t):
    return (a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]))


def distance(a, b):
    return math.dist(a, b)


def meet(a, b, c, d):
    """Where the line through a and b meets the line through c and d."""
    u, v, w = (b[0] - a[0], b[1] - a[1]), (d[0] - c[0], d[1] - c[1]), (c[0] - a[0], c[1] - a[1])
    t = (w[0] * v[1] - w[1] * v[0]) / (u[0] * v[1] - u[1] * v[0])
    return between(a, b, t)


def clip(polygon, inside):
    """The part of a polygon where the signed function `inside`, linear on segments, is at least 0."""
    result = []
    for a, b in zip(polygon, polygon[1:] + polygon[:1]):
        u, v = inside(a), inside(b)
        if u >= 0:
            result.append(a)
        if (u < 0) != (v < 0):
            result.append(between(a, b, u / (u - v)))
    return result


def draw_unfolding(file):
    """A strip of triangles, unfolded: the shortest path through it is straight."""
    picture = Picture(560, 230, 100)
    low = [(0.3, 0.5), (1.5, 0.3), (2.7, 0.55), (3.9, 0.4), (5.2, 0.6)]
    high = [(0.9, 1.6), (2.1, 1.75), (3.3, 1.6), (4.6, 1.8)]
    for i, top in enumerate(high):
        picture.path([low[i], low[i + 1], top], GREY, 1.2, PALE, close=True)
        if i + 1 < len(high):
            picture.path([top, low[i + 1], high[i + 1]], GREY, 1.2, "#eef2f5", close=True)
    source, target = (0.75, 0.85), (4.75, 1.15)
    picture.path([source, target], BLUE, 2.5)
    inner = [(low[i + 1], top) for i in range(len(high)) for top in high[i:i + 2]]
    for bottom, top in inner[:-1]:  # the last one is the border of the strip
        picture.dot(meet(source, target, bottom, top), GREY, 3)
    picture.dot(source, BLUE)
    picture.dot(target, INK)
    picture.text((0.84, 0.6), "generator", BLUE)
    picture.text((4.75, 0.85), "point")
    picture.write(file)


def draw_windows(file):
    """Light of a source through an interval of an edge falls on the two other edges of the next triangle."""
    picture = Picture(560, 300, 100)
    source, a, b, c = (0.5, 1.5), (2.2, 0.4), (2.4, 2.6), (4.9, 1.7)
    first, last = between(a, b, 0.25), between(a, b, 0.85)
    ends = [meet(source, first, a, c), meet(source, last, b, c)]
    picture.path([a, b, c], GREY, 1.2, PALE, close=True)
    picture.path([source, a, b], GREY, 1.2, "#eef2f5", close=True)
    picture.path([source, first, ends[0], c, ends[1], last], "none", 0, TINT[BLUE], close=True)
    for p, q in ((a, b), (b, c), (a, c), (source, a), (source, b)):
        picture.path([p, q], GREY, 1.2)
    for end in ends:
        picture.path([source, end], BLUE, 1, dash="5 4")
    picture.path([first, last], BLUE, 5)
    picture.path([ends[0], c], ORANGE, 5)
    picture.path([ends[1], c], ORANGE, 5)
    picture.dot(source, BLUE)
    picture.text((0.12, 2.1), "source, unfolded", BLUE, "start")
    picture.text((2.12, 1.15), "window", BLUE, "end")
    picture.text((4.45, 2.3), "the windows", ORANGE, "start")
    picture.text((4.45, 2.12), "behind it", ORANGE, "start")
    picture.write(file)


def draw_envelope(file):
    """Distances along an edge from three windows; the least of them counts."""
    picture = Picture(560, 300, 100)
    curves = [(BLUE, 1.0, 0.6, 0.0), (ORANGE, 2.8, 0.5, 0.35), (GREEN, 4.4, 0.8, 0.0)]
    value = lambda curve, x: 0.55 * (curve[3] + math.hypot(x - curve[1], curve[2])) + 0.35
    xs = [0.4 + 0.02 * i for i in range(236)]
    for curve in curves:
        picture.path([(x, value(curve, x)) for x in xs if value(curve, x) < 2.7], curve[0], 1, dash="4 4")
    least = [min(curves, key=lambda curve: value(curve, x)) for x in xs]
    begin = 0
    for i in range(1, len(xs) + 1):
        if i < len(xs) and least[i] is least[begin]:
            continue
        picture.path([(x, value(least[begin], x)) for x in xs[begin:i]], least[begin][0], 3.5)
        if i < len(xs):
            picture.dot((xs[i], value(least[i], xs[i])), INK)
            picture.path([(xs[i], 0.3), (xs[i], value(least[i], xs[i]))], GREY, 1, dash="2 3")
            picture.dot((xs[i], 0.3), INK, 3.5)
        begin = i
    picture.path([(0.4, 0.3), (5.1, 0.3)], INK, 1.5)
    picture.text((2.75, 0.08), "along the edge")
    picture.text((0.42, 2.75), "distance", anchor="start")
    picture.write(file)


def owner(sources, p):
    return min(range(len(sources)), key=lambda i: sources[i][1] + distance(sources[i][0], p))


def arc(sources, i, k, triangle):
    """The points of the triangle at equal distance from two sources and no nearer to another one, in order."""
    apex, base = triangle[0], triangle[1:]
    points = []
    for step in range(401):
        foot = between(base[0], base[1], step / 400)
        gap = lambda t: (sources[i][1] + distance(sources[i][0], between(apex, foot, t))
                         - sources[k][1] - distance(sources[k][0], between(apex, foot, t)))
        for n in range(200):
            low, high = n / 200, (n + 1) / 200
            if (gap(low) < 0) == (gap(high) < 0):
                continue
            for _ in range(40):
                middle = (low + high) / 2
                if (gap(low) < 0) == (gap(middle) < 0):
                    low = middle
                else:
                    high = middle
            p = between(apex, foot, low)
            if owner(sources, p) in (i, k):
                points.append(p)
    return points


def draw_sources(file, sources, triangle, names):
    picture = Picture(560, 320, 100)
    colours = [BLUE, ORANGE, GREEN]
    low, high = min(p[1] for p in triangle), max(p[1] for p in triangle)
    strips, across = 220, 400
    cells = {colour: [] for colour in colours}
    for n in range(strips):
        y0, y1 = low + (high - low) * n / strips, low + (high - low) * (n + 1) / strips
        row = clip(clip(triangle, lambda p: p[1] - y0), lambda p: y1 - p[1])
        left, right = min(p[0] for p in row), max(p[0] for p in row)
        at = lambda k: (left + (right - left) * k / across, (y0 + y1) / 2)
        begin = 0
        for k in range(1, across + 1):
            if k < across and owner(sources, at(k)) == owner(sources, at(begin)):
                continue
            x0, x1 = at(begin)[0], at(k)[0]
            part = clip(clip(row, lambda p: p[0] - x0), lambda p: x1 - p[0])
            if len(part) > 2:
                cells[colours[owner(sources, at(begin))]].append("M" + " L".join(picture.at(p) for p in part) + "Z")
            begin = k
    for colour, parts in cells.items():
        if parts:
            tint = TINT[colour]
            picture.parts.append(f'<path d="{"".join(parts)}" fill="{tint}" stroke="{tint}" stroke-width=".8"/>')
    for i in range(len(sources)):
        for k in range(i):
            points = arc(sources, i, k, triangle)
            if len(points) > 1:
                ordered = [points.pop(min(range(len(points)), key=lambda n: points[n][1]))]
                while points:
                    ordered.append(points.pop(min(range(len(points)), key=lambda n: distance(points[n], ordered[-1]))))
                picture.path(ordered, INK, 2.5)
    picture.path(triangle, GREY, 1.5, close=True)
    for (place, _), colour, (words, at, anchor) in zip(sources, colours, names):
        picture.dot(place, colour)
        picture.text(at, words, colour, anchor)
    return picture


TRIANGLE = [(1.2, 0.35), (4.6, 0.6), (2.6, 2.9)]


def draw_arc(file):
    sources = [((0.45, 1.7), 0.0), ((4.75, 2.1), 0.55)]
    picture = draw_sources(file, sources, TRIANGLE, [("source", (0.3, 1.95), "start"), ("farther source", (4.3, 2.35), "start")])
    picture.write(file)


def draw_branch(file):
    sources = [((0.45, 1.7), 0.0), ((4.75, 2.1), 0.25), ((2.9, 0.15), 0.75)]
    picture = draw_sources(file, sources, TRIANGLE, [("a", (0.3, 1.85), "middle"), ("b", (4.95, 2.2), "middle"), ("c", (3.1, 0.12), "middle")])
    picture.write(file)


def draw_dual(file):
    """Cells of points in the plane, and the triangles that join the points of cells with a common corner."""
    picture = Picture(560, 320, 100)
    points = [(0.8, 0.7), (2.0, 0.45), (3.2, 0.75), (4.5, 0.5), (1.25, 1.65), (2.5, 1.55), (3.75, 1.7), (4.95, 1.55), (0.7, 2.65), (1.95, 2.6),
              (3.1, 2.65), (4.4, 2.7)]
    box = [(0.15, 0.1), (5.45, 0.1), (5.45, 3.1), (0.15, 3.1)]
    cells = []
    for p in points:
        cell = box
        for q in points:
            if q != p:
                cell = clip(cell, lambda x, p=p, q=q: distance(x, q) ** 2 - distance(x, p) ** 2)
        cells.append(cell)
    shared = lambda a, b: [u for u in cells[a] if any(distance(u, v) < 1e-6 for v in cells[b])]
    tints, chosen = [*TINT.values(), PALE], []
    for n, cell in enumerate(cells):
        used = {chosen[k] for k in range(n) if len(shared(n, k)) == 2}
        chosen.append(next(tint for tint in tints if tint not in used))
        picture.path(cell, GREY, 1.2, chosen[-1], close=True)
    for a in range(len(points)):
        for b in range(a):
            if len(shared(a, b)) == 2:
                picture.path([points[a], points[b]], INK, 2)
    for a in range(len(points)):
        for b in range(a):
            for c in range(b):
                for corner in shared(a, b):
                    if any(distance(corner, v) < 1e-6 for v in cells[c]):
                        picture.dot(corner, ORANGE, 4)
    for p in points:
        picture.dot(p, INK)
    picture.write(file)


def main():
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    for name, draw in (("unfolding", draw_unfolding), ("windows", draw_windows), ("envelope", draw_envelope), ("arc", draw_arc),
                       ("branch", draw_branch), ("dual", draw_dual)):
        draw(folder / f"how_{name}.svg")


if __name__ == "__main__":
    main()
