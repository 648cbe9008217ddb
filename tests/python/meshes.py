"""Meshes and independent distances for the tests of the Python package."""
import heapq
import pathlib

import numpy

ROOT = pathlib.Path(__file__).resolve().parents[2]
FIGURE = ROOT / "data" / "figure.obj"
TORUS = ROOT / "data" / "torus.ply"
HALF_SPHERE = ROOT / "data" / "half_sphere.off"
PLATE = ROOT / "data" / "plate.stl"


def make_grid(n, seed=0):
    """A unit square of 2 n^2 triangles, whose inner vertices are moved at random within the plane."""
    at = numpy.array([(i / n, j / n, 0.0) for i in range(n + 1) for j in range(n + 1)])
    inner = (at[:, :2] > 0).all(axis=1) & (at[:, :2] < 1).all(axis=1)
    at[inner, :2] += numpy.random.default_rng(seed).uniform(-0.2 / n, 0.2 / n, (int(inner.sum()), 2))
    faces = []
    for i in range(n):
        for j in range(n):
            a, b, c, d = (v[0] * (n + 1) + v[1] for v in ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)))
            faces += [(a, b, c), (a, c, d)]
    return at, numpy.array(faces)


def make_box(a, b, c):
    """A box of quadrilaterals; vertex 0 is at the origin and vertex 6 opposite."""
    at = numpy.array([(0, 0, 0), (a, 0, 0), (a, b, 0), (0, b, 0), (0, 0, c), (a, 0, c), (a, b, c), (0, b, c)], float)
    return at, numpy.array([(0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)])


def edge_distances(vertices, faces, start):
    """Dijkstra's algorithm along the edges: never below the geodesic distance."""
    near = [{} for _ in vertices]
    for face in faces:
        for a, b in zip(face, numpy.roll(face, 1)):
            near[a][b] = near[b][a] = float(numpy.linalg.norm(vertices[a] - vertices[b]))
    found, queue = numpy.full(len(vertices), numpy.inf), [(0.0, int(start))]
    found[start] = 0
    while queue:
        d, v = heapq.heappop(queue)
        if d > found[v]:
            continue
        for w, length in near[v].items():
            if d + length < found[w]:
                found[w] = d + length
                heapq.heappush(queue, (d + length, int(w)))
    return found
