"""Bounds of geodesic distances: straight lines from below, paths along subdivided edges from above, and the plane where the surface
is flat. They share no code with the library."""
import heapq
import math

# On well shaped faces, a path along edges with this many points on each is at most a few percent longer than the shortest path, or
# by a tenth of an edge. With 4, a torus of 576 faces has 0.15 edges.
POINTS_ON_AN_EDGE = 8


class EdgePaths:
    """Lengths of paths through the points on the edges of each face: upper bounds of distances."""

    def __init__(self, surface, cuts):
        self.surface = surface
        self.nodes = list(surface.points)
        on_edge = {}
        for a, b in surface.edge_faces:
            on_edge[a, b] = range(len(self.nodes), len(self.nodes) + cuts)
            p, q = surface.points[a], surface.points[b]
            for i in range(1, cuts + 1):
                self.nodes.append(tuple(x + (y - x) * i / (cuts + 1) for x, y in zip(p, q)))
        self.on_face = []
        for face in surface.faces:
            nodes = list(face)
            for i in range(3):
                a, b = sorted((face[i], face[(i + 1) % 3]))
                nodes += on_edge[a, b]
            self.on_face.append(nodes)
        self.faces_at = [[] for _ in self.nodes]
        for f, nodes in enumerate(self.on_face):
            for n in nodes:
                self.faces_at[n].append(f)

    def distances_from(self, face, position):
        """Upper bounds at all nodes."""
        best = [math.inf] * len(self.nodes)
        queue = []
        for n in self.on_face[face]:
            best[n] = math.dist(position, self.nodes[n])
            queue.append((best[n], n))
        heapq.heapify(queue)
        while queue:
            d, n = heapq.heappop(queue)
            if d > best[n]:
                continue
            for f in self.faces_at[n]:
                for m in self.on_face[f]:
                    length = d + math.dist(self.nodes[n], self.nodes[m])
                    if length < best[m]:
                        best[m] = length
                        heapq.heappush(queue, (length, m))
        return best

    def distance(self, best, source, point):
        """Upper bound at a point {face, position}; `source` is that of the distances."""
        if source["face"] == point["face"]:
            return math.dist(source["position"], point["position"])
        return min(best[n] + math.dist(self.nodes[n], point["position"]) for n in self.on_face[point["face"]])


class Unfolding:
    """Exact distances on a convex piece of the plane, or on a tube that is rolled out of a strip."""

    def __init__(self, mesh):
        self.uv, self.period = mesh.uv, mesh.period

    def place(self, point):
        corners = self.uv[point["face"]]
        return tuple(sum(b * c[k] for b, c in zip(point["bary"], corners)) for k in range(2))

    def distance(self, p, q):
        across = abs(p[0] - q[0])
        if self.period:
            across %= self.period
            across = min(across, self.period - across)
        return math.hypot(across, p[1] - q[1])
