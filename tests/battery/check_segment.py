"""Checks what gvd-segment writes: labels, areas, distances, bisectors."""
import math

from bounds import POINTS_ON_AN_EDGE, EdgePaths, Unfolding
from surface import Surface, require

# Largest relative difference of sums of areas: rounding of some thousand terms.
AREA_ERROR = 1e-9
# Errors of distances, as fractions of the surface's size. Distances unfolded through many faces differ in the last digits; needles
# cost some more.
DISTANCE_ERROR = 1e-8
# How much a path along the subdivided edges of even faces is longer than the shortest one, beside a tenth of an edge: on a short path
# the angles between the points matter.
DETOUR, DETOUR_IN_EDGES = 0.05, 0.1
# The commands' default, in mean edge lengths. A point that far from the curve has distances that differ by up to twice as much.
CHORD_TOLERANCE = 1e-4
# Bounds along edges are computed for small surfaces and few generators only: each takes a search in the whole graph.
MOST_FACES_WITH_PATHS, MOST_GENERATORS_WITH_PATHS = 700, 12
# Points of bisectors that are compared with the bounds, spread over all of them.
MOST_POINTS = 400


def mean_edge(surface):
    return sum(math.dist(surface.points[a], surface.points[b]) for a, b in surface.edge_faces) / len(surface.edge_faces)


def check_regions(surface, labels, diagram, report):
    """Each label's faces are connected, and every generator has one or is listed as having none."""
    count = len(diagram["generators"])
    require(len(labels) == len(surface.faces), f"{len(labels)} labels for {len(surface.faces)} faces")
    require(all(-1 <= label < count for label in labels), "a label is out of range")
    part = surface.components(lambda f, g: labels[f] == labels[g])
    of_label = {}
    for f, label in enumerate(labels):
        of_label.setdefault(label, set()).add(part[f])
    for label, parts in of_label.items():
        require(label < 0 or len(parts) == 1, f"the faces of label {label} form {len(parts)} components")
    without = report["results"].get("generators_without_face", [])
    missing = [g for g in range(count) if g not in of_label]
    require(missing == without, f"generators {missing[:5]} have no face, and the report lists {without[:5]}")
    whole = surface.components()
    reached = {whole[f] for f, label in enumerate(labels) if label >= 0}
    for f, label in enumerate(labels):
        require((label >= 0) == (whole[f] in reached), f"face {f} of a component with generators has the label {label}")


def check_areas(surface, labels, diagram):
    areas = [surface.area(f) for f in range(len(surface.faces))]
    reached = math.fsum(a for a, label in zip(areas, labels) if label >= 0)
    cells = math.fsum(cell["area"] / surface.size / surface.size for cell in diagram["cells"])
    allowed = AREA_ERROR * reached + 1e2 * surface.rounding / surface.size
    require(abs(cells - reached) <= allowed, f"the cells have the area {cells}, the surface {reached}")


def check_cut(surface, diagram):
    """Pieces fill their parents, and together the cells."""
    cut = diagram["cut_mesh"]
    pieces = Surface([tuple(p) for p in cut["vertices"]], [tuple(f) for f in cut["faces"]])
    pieces.require_manifold("the cut mesh")
    require(pieces.topology() == surface.topology(), "the cut mesh has another topology")
    of_parent, of_label = [0.0] * len(surface.faces), {}
    scale = (pieces.size / surface.size) ** 2
    for f, (label, parent) in enumerate(zip(cut["labels"], cut["parents"])):
        of_parent[parent] += scale * pieces.area(f)
        of_label[label] = of_label.get(label, 0.0) + scale * pieces.area(f)
    total = math.fsum(of_parent)
    allowed = AREA_ERROR * total + 1e2 * surface.rounding / surface.size
    for f, area in enumerate(of_parent):
        require(abs(area - surface.area(f)) <= allowed, f"the pieces of face {f} have the area {area}, the face {surface.area(f)}")
    for cell in diagram["cells"]:
        area = cell["area"] / surface.size / surface.size
        cut_area = of_label.get(cell["generator"], 0.0)
        require(abs(area - cut_area) <= allowed, f"cell {cell['generator']} has the area {area}, its pieces {cut_area}")


def check_lengths(surface, diagram, error):
    """Distances change along an edge by at most its length, and are no shorter than a straight line to the generator."""
    distance, label = diagram["vertex_distances"], diagram["vertex_labels"]
    for v, (d, g) in enumerate(zip(distance, label)):
        require((d is None) == (g < 0), f"vertex {v} has the distance {d} and the label {g}")
        if d is None:
            continue
        line = math.dist(diagram["generators"][g]["position"], surface.points[v])
        require(d >= line - error, f"vertex {v}: the distance {d} is shorter than the straight line {line}")
    for a, b in surface.edge_faces:
        require((distance[a] is None) == (distance[b] is None), f"edge {a}, {b} is reached at one end only")
        if distance[a] is not None:
            length = math.dist(surface.points[a], surface.points[b])
            require(abs(distance[a] - distance[b]) <= length + error, f"the distances at edge {a}, {b} differ by more than its length")


def check_on_surface(surface, point, error):
    require(all(-1e-12 <= b <= 1 + 1e-12 for b in point["bary"]), f"barycentric coordinates {point['bary']}")
    corners = [surface.points[v] for v in surface.faces[point["face"]]]
    place = [sum(b * c[k] for b, c in zip(point["bary"], corners)) for k in range(3)]
    require(math.dist(place, point["position"]) <= error, f"a point in face {point['face']} is not where its coordinates say")


def sample(diagram):
    """Points of bisectors with their two generators, and branch points with all of theirs, at most MOST_POINTS."""
    pairs = [(point, (b["left"], b["right"])) for b in diagram["bisectors"] for point in b["points"]]
    pairs = pairs[::max(1, len(pairs) // MOST_POINTS)]
    return pairs + [(point, tuple(point["generators"])) for point in diagram["branch_points"][:MOST_POINTS]]


def check_flat(mesh, diagram, error):
    """Where the surface unfolds: nearest generators and equal distances, exactly."""
    plane = Unfolding(mesh)
    places = [plane.place(g) for g in diagram["generators"]]
    for point, generators in sample(diagram):
        here = plane.place(point)
        own = [plane.distance(places[g], here) for g in generators]
        least = min(plane.distance(place, here) for place in places)
        require(max(own) - least <= error, f"in face {point['face']}: {generators} have the distances {own}, the least is {least}")
    for f, face in enumerate(mesh.faces):
        for corner, v in enumerate(face):
            least = min(plane.distance(place, mesh.uv[f][corner]) for place in places)
            given = diagram["vertex_distances"][v]
            require(abs(given - least) <= error, f"vertex {v}: the distance is {given} instead of {least}")


def check_bounds(surface, diagram, error, even):
    """The two generators of a bisector can't be told apart by bounds, and none is certainly nearer."""
    paths = EdgePaths(surface, POINTS_ON_AN_EDGE if even else 2)
    detour = DETOUR_IN_EDGES * mean_edge(surface) + error
    generators = diagram["generators"]
    upper = [paths.distances_from(g["face"], g["position"]) for g in generators]
    for v, given in enumerate(diagram["vertex_distances"]):
        best = min(up[v] for up in upper)
        require(math.isinf(best) == (given is None), f"vertex {v}: the distance is {given}, a path has {best}")
        if given is not None:
            require(given <= best + error, f"vertex {v}: the distance is {given}, and a path has {best}")
            if even:
                require(best <= (1 + DETOUR) * given + detour, f"vertex {v}: the distance is {given}, the shortest path found {best}")
    for point, own in sample(diagram):
        high = [paths.distance(up, g, point) for up, g in zip(upper, generators)]
        low = [math.dist(g["position"], point["position"]) for g in generators]
        nearest = min(high)
        for g in own:
            require(low[g] <= nearest + error, f"in face {point['face']}: generator {g} is at least at {low[g]}, another at {nearest}")
            if even:
                require(high[g] <= (1 + DETOUR) * nearest + detour,
                        f"in face {point['face']}: generator {g} is at {high[g]}, another at {nearest}")


def check_segment(mesh, surface, diagram, report, method="exact"):
    labels = diagram["cut_mesh"]["labels"] if "cut_mesh" in diagram else diagram["face_labels"]
    if "cut_mesh" in diagram:
        check_cut(surface, diagram)
    else:
        check_regions(surface, labels, diagram, report)
        check_areas(surface, labels, diagram)
    error = DISTANCE_ERROR * surface.size + 1e3 * surface.rounding
    points = [point for bisector in diagram["bisectors"] for point in bisector["points"]] + diagram["branch_points"]
    for point in points:
        check_on_surface(surface, point, error)
    if method != "exact":
        return
    check_lengths(surface, diagram, error)
    chord = CHORD_TOLERANCE * mean_edge(surface)
    if mesh.uv is not None:
        check_flat(mesh, diagram, 2 * chord + error)
    if len(surface.faces) <= MOST_FACES_WITH_PATHS and len(diagram["generators"]) <= MOST_GENERATORS_WITH_PATHS:
        check_bounds(surface, diagram, 2 * chord + error, mesh.even)
