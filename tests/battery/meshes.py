"""Hostile meshes, made here: families() lists them. Nothing is read, nothing depends on chance but random.Random(seed)."""
import math
import random


class HostileMesh:
    """Points, faces and what is known about them.

    refused   exit codes that are right as well: the mesh breaks a precondition, or is at its limit
    uv        per face three points of the plane, where the surface is a convex piece of the plane or a tube rolled out of a strip
    period    length of that strip round the tube; 0 for a piece of the plane
    even      whether all faces are of one size and well shaped: paths along subdivided edges are then nearly shortest
    """

    def __init__(self, name, points, faces, refused=(), uv=None, period=0.0, even=False):
        self.name, self.points, self.faces = name, points, faces
        self.refused, self.uv, self.period, self.even = tuple(refused), uv, period, even

    def write(self, path):
        lines = ["OFF", f"{len(self.points)} {len(self.faces)} 0"]
        lines += [" ".join(map(repr, p)) for p in self.points]
        lines += [" ".join(map(str, (len(f), *f))) for f in self.faces]
        path.write_text("\n".join(lines) + "\n")


def grid_faces(columns, rows, around=False):
    """Two triangles for each quadrilateral of a grid of columns x rows vertices; around: the last column meets the first."""
    faces = []
    for y in range(rows - 1):
        for x in range(columns if around else columns - 1):
            a, b = y * columns + x, y * columns + (x + 1) % columns
            faces += [(a, b, a + columns), (b, b + columns, a + columns)]
    return faces


def flat(name, points, faces, **known):
    """A convex piece of the plane z = 0: its own unfolding."""
    return HostileMesh(name, points, faces, uv=[[points[v][:2] for v in f] for f in faces], **known)


def sheet(name, xs, ys, **known):
    return flat(name, [(x, y, 0.0) for y in ys for x in xs], grid_faces(len(xs), len(ys)), **known)


def steps(count, size=1.0):
    return [size * i / count for i in range(count + 1)]


def graded(count, ratio):
    """0, then count points from tiny to 1, each farther than the last one by the ratio."""
    return [0.0] + [ratio ** (i + 1 - count) for i in range(count)]


def fan(name, count):
    """A disc of needles: count triangles round one vertex."""
    rim = [(math.cos(2 * math.pi * i / count), math.sin(2 * math.pi * i / count), 0.0) for i in range(count)]
    return flat(name, [(0.0, 0.0, 0.0)] + rim, [(0, 1 + i, 1 + (i + 1) % count) for i in range(count)])


def tube(name, sides, rings, radius, length):
    """An open prism."""
    points = [(radius * math.cos(2 * math.pi * s / sides), radius * math.sin(2 * math.pi * s / sides), length * r / (rings - 1))
              for r in range(rings) for s in range(sides)]
    side = 2 * radius * math.sin(math.pi / sides)
    at = lambda s, r: (s * side, length * r / (rings - 1))
    uv = []
    for r in range(rings - 1):
        for s in range(sides):
            uv += [[at(s, r), at(s + 1, r), at(s, r + 1)], [at(s + 1, r), at(s + 1, r + 1), at(s, r + 1)]]
    return HostileMesh(name, points, grid_faces(sides, rings, around=True), uv=uv, period=sides * side)


def collinear(name):
    """A square whose faces without area connect a side with its points."""
    points = [(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (1.0, 1.0, 0.0), (0.0, 1.0, 0.0), (0.25, 0.0, 0.0), (0.5, 0.0, 0.0), (0.75, 0.0, 0.0)]
    return flat(name, points, [(0, 1, 2), (0, 2, 3), (0, 4, 5), (0, 5, 1), (5, 6, 1)])


def ball(rings=9, sectors=14, radius=lambda t, u: 1.0):
    at = lambda i, k: 2 + (i - 1) * sectors + k % sectors
    points = [(0.0, 0.0, radius(0.0, 0.0)), (0.0, 0.0, -radius(math.pi, 0.0))]
    for i in range(1, rings):
        for k in range(sectors):
            t, u = math.pi * i / rings, 2 * math.pi * k / sectors
            r = radius(t, u)
            points.append((r * math.sin(t) * math.cos(u), r * math.sin(t) * math.sin(u), r * math.cos(t)))
    faces = [(0, at(1, k), at(1, k + 1)) for k in range(sectors)] + [(1, at(rings - 1, k + 1), at(rings - 1, k)) for k in range(sectors)]
    for i in range(1, rings - 1):
        for k in range(sectors):
            faces += [(at(i, k), at(i + 1, k), at(i + 1, k + 1)), (at(i, k), at(i + 1, k + 1), at(i, k + 1))]
    return points, faces


def spikes(name, seed, height):
    points, faces = ball(12, 20)
    chance = random.Random(seed)
    moved = set(chance.sample(range(len(points)), 25))
    return HostileMesh(name, [tuple(height * x for x in p) if v in moved else p for v, p in enumerate(points)], faces)


def torus(name, scale=1.0, shift=0.0, around=24, across=12, **known):
    points = []
    for a in range(across):
        for c in range(around):
            t, u = 2 * math.pi * c / around, 2 * math.pi * a / across
            r = 1 + 0.35 * math.cos(u)
            points.append((shift + scale * r * math.cos(t), scale * r * math.sin(t), scale * 0.35 * math.sin(u)))
    faces = []
    for a in range(across):
        for c in range(around):
            p = lambda i, k: (a + k) % across * around + (c + i) % around
            faces += [(p(0, 0), p(1, 0), p(0, 1)), (p(1, 0), p(1, 1), p(0, 1))]
    return HostileMesh(name, points, faces, **known)


def stretched(name, factors):
    points, faces = ball()
    return HostileMesh(name, [tuple(f * x for f, x in zip(factors, p)) for p in points], faces)


def slit(name, n=12):
    """A square sheet cut open along half of its middle row: the banks lie in the same places."""
    line = steps(n)
    points = [(x, y, 0.0) for y in line for x in line]
    faces = grid_faces(n + 1, n + 1)
    middle = n // 2
    copy = {}
    for x in range(n // 2):
        copy[middle * (n + 1) + x] = len(points)
        points.append(points[middle * (n + 1) + x])
    above = [f for f in faces if min(f) >= middle * (n + 1)]
    below = [f for f in faces if min(f) < middle * (n + 1)]
    return HostileMesh(name, points, below + [tuple(copy.get(v, v) for v in f) for f in above])


def seam(name, sides=16, rings=10):
    """A cone frustum cut open from end to end: the first and the last column lie in the same places."""
    points = []
    for r in range(rings):
        for s in range(sides + 1):
            u = 2 * math.pi * (s % sides) / sides
            radius = 1 + 0.1 * r
            points.append((radius * math.cos(u), radius * math.sin(u), 0.3 * r))
    return HostileMesh(name, points, grid_faces(sides + 1, rings))


def book(name, pages):
    """Sheets that all share one edge line."""
    rows, columns = 6, 5
    points = [(0.0, 0.0, y / 4) for y in range(rows)]
    faces = []
    for page in range(pages):
        angle, first = 2 * math.pi * page / pages, len(points)
        points += [(x / 4 * math.cos(angle), x / 4 * math.sin(angle), y / 4) for y in range(rows) for x in range(1, columns)]
        vertex = lambda x, y: y if x == 0 else first + y * (columns - 1) + x - 1
        for y in range(rows - 1):
            for x in range(columns - 1):
                faces += [(vertex(x, y), vertex(x + 1, y), vertex(x, y + 1)),
                          (vertex(x + 1, y), vertex(x + 1, y + 1), vertex(x, y + 1))]
    return HostileMesh(name, points, faces)


def bow_tie(name):
    """Two square sheets that touch in one vertex."""
    line = steps(6)
    points = [(x, y, 0.0) for y in line for x in line]
    faces = grid_faces(7, 7)
    last = len(points) - 1
    other = [last if i == 0 else last + i for i in range(len(points))]
    points += [(1 + x, 1 + y, 0.0) for x, y, _ in points[1:]]
    return HostileMesh(name, points, faces + [tuple(other[v] for v in f) for f in faces])


def doubled(name):
    points, faces = ball()
    return HostileMesh(name, points, faces + [(b, a, c) for a, b, c in faces])


def folded(name, n=8):
    """A square sheet and its lower side, sewn along the rim: flat, closed, everything in two layers."""
    line = steps(n)
    points = [(x, y, 0.0) for y in line for x in line]
    faces = grid_faces(n + 1, n + 1)
    lower = {}
    for v, (x, y, _) in enumerate(list(points)):
        inner = 0 < x < 1 and 0 < y < 1
        lower[v] = len(points) if inner else v
        if inner:
            points.append((x, y, 0.0))
    # Corner faces would repeat all three corners of the upper side where the diagonal cuts off the corner: flip the layer.
    mirror = {v: lower[(v // (n + 1)) * (n + 1) + n - v % (n + 1)] for v in range((n + 1) ** 2)}
    return HostileMesh(name, points, faces + [tuple(mirror[v] for v in f) for f in faces])


def accordion(name, folds=20):
    """A strip folded flat again and again."""
    points = [(float(x % 2), y / 4, 0.0) for y in range(9) for x in range(folds + 1)]
    return HostileMesh(name, points, grid_faces(folds + 1, 9))


def holes(name, n):
    """A slab of unit cubes with n x n holes: closed, genus n^2."""
    size = 2 * n + 1
    solid = lambda x, y: 0 <= x < size and 0 <= y < size and not (x % 2 == 1 and y % 2 == 1)
    index, points, faces = {}, [], []

    def vertex(*p):
        if p not in index:
            index[p] = len(points)
            points.append(tuple(map(float, p)))
        return index[p]

    def quad(a, b, c, d):
        corners = [vertex(*p) for p in (a, b, c, d)]
        faces.extend([tuple(corners[:3]), (corners[0], corners[2], corners[3])])

    for x in range(size):
        for y in range(size):
            if not solid(x, y):
                continue
            quad((x, y, 1), (x + 1, y, 1), (x + 1, y + 1, 1), (x, y + 1, 1))
            quad((x, y, 0), (x, y + 1, 0), (x + 1, y + 1, 0), (x + 1, y, 0))
            sides = [((x, y - 1), (x, y), (x + 1, y)), ((x, y + 1), (x + 1, y + 1), (x, y + 1)),
                     ((x - 1, y), (x, y + 1), (x, y)), ((x + 1, y), (x + 1, y), (x + 1, y + 1))]
            for beside, a, b in sides:
                if not solid(*beside):
                    quad((*a, 0), (*b, 0), (*b, 1), (*a, 1))
    return HostileMesh(name, points, faces)


def crowd(name, count):
    """Tetrahedra and a ball side by side: generators reach few of them."""
    points, faces = ball(6, 8)
    for i in range(count):
        first = len(points)
        points += [(3.0 + i, 0.0, 0.0), (3.9 + i, 0.0, 0.0), (3.0 + i, 0.9, 0.0), (3.0 + i, 0.0, 0.9)]
        faces += [(first, first + 2, first + 1), (first, first + 1, first + 3), (first + 1, first + 2, first + 3), (first, first + 3, first + 2)]
    return HostileMesh(name, points, faces)


def terrain(name, seed, roughness, n=14):
    chance = random.Random(seed)
    points = [(x, y, roughness * chance.uniform(-1, 1)) for y in steps(n) for x in steps(n)]
    return HostileMesh(name, points, grid_faces(n + 1, n + 1))


def soup(name, seed):
    """Random triangles on few vertices: every defect at once."""
    chance = random.Random(seed)
    points = [tuple(chance.choice([0.0, 0.5, 1.0, chance.random()]) for _ in range(3)) for _ in range(30)]
    return HostileMesh(name, points, [tuple(chance.sample(range(30), 3)) for _ in range(60)], refused=(4,))


def moebius(name, count=9):
    points = []
    for i in range(count):
        t = math.pi * i / count
        for side in (-0.3, 0.3):
            r = 1 + side * math.cos(t)
            points.append((r * math.cos(2 * t), r * math.sin(2 * t), side * math.sin(t)))
    at = lambda i, k: 2 * i + k if i < count else 1 - k  # sewn with a half turn
    faces = [f for i in range(count) for f in [(at(i, 0), at(i + 1, 0), at(i, 1)), (at(i + 1, 0), at(i + 1, 1), at(i, 1))]]
    return HostileMesh(name, points, faces, refused=(4,))


def simple_ones():
    yield flat("triangle", [(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.3, 0.8, 0.0)], [(0, 1, 2)])
    yield flat("needle", [(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.5, 1e-7, 0.0)], [(0, 1, 2)])
    yield HostileMesh("tetrahedron", [(0.0, 0.0, 0.0), (1.0, 1.0, 0.0), (1.0, 0.0, 1.0), (0.0, 1.0, 1.0)],
                      [(0, 1, 2), (0, 3, 1), (0, 2, 3), (1, 3, 2)])
    points, faces = ball()
    yield HostileMesh("ball", points, faces, even=True)
    yield sheet("sheet", steps(14), steps(11, 0.8), even=True)


def thin_ones():
    yield sheet("flat_needles", steps(60, 1e-4), steps(3))
    yield sheet("strip", [0.0, 0.25, 0.5, 1.0], [0.0, 0.001])
    yield sheet("thin_sheet", steps(8), steps(5, 0.005))
    yield sheet("graded", graded(20, 2.0), graded(20, 2.0))
    yield sheet("steep", graded(16, 10.0), steps(8))
    yield collinear("collinear")
    yield fan("fan", 300)
    yield tube("wire", 5, 40, 1e-4, 1.0)
    yield tube("needle_tube", 90, 4, 0.05, 1.0)
    yield spikes("spikes", 3, 20.0)
    yield stretched("stretched", (1.0, 1e-3, 1e3))
    yield stretched("disc_like", (1.0, 1.0, 1e-6))


def torn_ones():
    yield slit("slit")
    yield seam("seam")
    yield book("book", 5)
    yield bow_tie("bow_tie")
    yield doubled("doubled")
    yield folded("folded")
    yield accordion("accordion")
    yield holes("holes", 3)
    yield crowd("crowd", 10)
    yield moebius("moebius")


def scaled_ones():
    yield torus("torus", even=True)
    yield torus("huge", scale=1e70)
    yield torus("tiny", scale=1e-70)
    yield torus("too_huge", scale=1e150, refused=(4,))
    yield torus("too_tiny", scale=1e-150, refused=(4,))
    yield torus("far_away", shift=1e6)


def random_ones(seed):
    yield terrain(f"hills_{seed}", seed, 0.1)
    yield terrain(f"peaks_{seed}", seed, 2.0)
    yield soup(f"soup_{seed}", seed)


def families(seeds):
    """All hostile meshes, the random ones once for each seed."""
    yield from simple_ones()
    yield from thin_ones()
    yield from torn_ones()
    yield from scaled_ones()
    for seed in seeds:
        yield from random_ones(seed)
