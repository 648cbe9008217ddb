"""A triangle mesh as the checks see it: files, areas, topology. It shares no code with the library."""
import math


class Finding(Exception):
    """What is wrong, in one line."""


def require(holds, message):
    if not holds:
        raise Finding(message)


class Surface:
    def __init__(self, points, faces):
        self.points, self.faces = points, faces
        self.edge_faces = {}
        for f, face in enumerate(faces):
            for i in range(3):
                a, b = face[i], face[(i + 1) % 3]
                self.edge_faces.setdefault((min(a, b), max(a, b)), []).append((f, a < b))
        low = [min(p[k] for p in points) for k in range(3)]
        high = [max(p[k] for p in points) for k in range(3)]
        self.size = math.dist(low, high)
        # The rounding error of a coordinate is proportional to the largest of them.
        self.rounding = 2.0 ** -52 * max(max(map(abs, low)), max(map(abs, high)))

    def area(self, f):
        """In units of the squared size, so that nothing underflows."""
        a, b, c = (self.points[v] for v in self.faces[f])
        u = [(x - y) / self.size for x, y in zip(b, a)]
        v = [(x - y) / self.size for x, y in zip(c, a)]
        return 0.5 * math.hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])

    def components(self, same=lambda f, g: True):
        """The component of each face, connected through edges between faces for which same(f, g) holds."""
        root = list(range(len(self.faces)))

        def find(f):
            while root[f] != f:
                root[f] = root[root[f]]
                f = root[f]
            return f

        for sides in self.edge_faces.values():
            for (f, _), (g, _) in zip(sides, sides[1:]):
                if same(f, g):
                    root[find(f)] = find(g)
        return [find(f) for f in range(len(self.faces))]

    def require_manifold(self, name):
        """Edges have one face or two with opposite directions, vertices have one fan of faces, and none is unused."""
        for edge, sides in self.edge_faces.items():
            require(len(sides) <= 2, f"{name}: edge {edge} has {len(sides)} faces")
            require(len(sides) == 1 or sides[0][1] != sides[1][1], f"{name}: the faces at edge {edge} are turned against each other")
        around = {}
        for f, face in enumerate(self.faces):
            require(len(set(face)) == 3, f"{name}: face {f} repeats a corner")
            for v in face:
                around.setdefault(v, set()).add(f)
        require(len(around) == len(self.points), f"{name}: {len(self.points) - len(around)} vertices are in no face")
        for v, fan in around.items():
            require(len(self.fan_of(v, fan)) == len(fan), f"{name}: the faces round vertex {v} form more than one fan")

    def fan_of(self, v, around):
        """The faces that can be reached from one of `around` through edges at v."""
        waiting, reached = [next(iter(around))], set()
        while waiting:
            f = waiting.pop()
            if f in reached:
                continue
            reached.add(f)
            for w in self.faces[f]:
                if w != v:
                    waiting += [g for g, _ in self.edge_faces[min(v, w), max(v, w)] if g not in reached]
        return reached

    def topology(self):
        """(components, boundary loops, Euler characteristic) of a manifold, component by component, sorted."""
        component = self.components()
        euler, loops, next_rim = {}, {}, {}
        for edge, sides in self.edge_faces.items():
            c = component[sides[0][0]]
            euler[c] = euler.get(c, 0) - 1
            if len(sides) == 1:
                a, b = edge if sides[0][1] else edge[::-1]
                next_rim[a] = (b, c)
        of_vertex = {v: component[f] for f, face in enumerate(self.faces) for v in face}
        for c in list(component) + list(of_vertex.values()):
            euler[c] = euler.get(c, 0) + 1
        while next_rim:
            v, (w, c) = next_rim.popitem()
            loops[c] = loops.get(c, 0) + 1
            while w in next_rim:
                w = next_rim.pop(w)[0]
        return sorted((euler[c], loops.get(c, 0)) for c in euler)


def read_ply(path):
    """A text PLY: the surface, and the labels of its faces where it has some."""
    lines = path.read_text().splitlines()
    counts, properties, element = {}, {}, None
    for number, line in enumerate(lines):
        words = line.split()
        if words[0] == "element":
            element = words[1]
            counts[element], properties[element] = int(words[2]), []
        elif words[0] == "property":
            properties[element].append(words[-1])
        elif words[0] == "end_header":
            break
    body = lines[number + 1:]
    require(len(body) == counts["vertex"] + counts["face"], f"{path.name}: {len(body)} lines after the header")
    points = [tuple(map(float, line.split()[:3])) for line in body[:counts["vertex"]]]
    rows = [line.split() for line in body[counts["vertex"]:]]
    require(all(row[0] == "3" for row in rows), f"{path.name}: a face is no triangle")
    faces = [tuple(map(int, row[1:4])) for row in rows]
    names = properties["face"][1:]
    labels = [int(row[4 + names.index("label")]) for row in rows] if "label" in names else None
    return Surface(points, faces), labels


def read_off(path):
    words = [line.split("#")[0].split() for line in path.read_text().splitlines()]
    words = [line for line in words if line]
    vertices, faces = int(words[1][0]), int(words[1][1])
    require(len(words) == 2 + vertices + faces, f"{path.name}: {len(words)} lines for {vertices} vertices and {faces} faces")
    points = [tuple(map(float, row[:3])) for row in words[2:2 + vertices]]
    return Surface(points, [tuple(map(int, row[1:4])) for row in words[2 + vertices:]])
