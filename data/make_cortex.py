#!/usr/bin/env python3
"""Makes a folded surface like a hemisphere of a brain, and an atlas of 12 regions on it: make_cortex.py FOLDER.

FOLDER/cortex.surf.gii is closed, has 10,242 vertices and 20,480 faces, and folds of some 8 mm. FOLDER/atlas.label.gii has
a key for each vertex: 1 to 12 for a region, and 0, named ???, for the flat inner side. Both are GIFTI in text.
FOLDER/wall.txt has a line for each vertex: 1 on the inner side, 0 elsewhere.

A subdivided icosahedron is stretched and moved along its rays by waves, so that no two triangles intersect.
"""
import math
import pathlib
import sys

DIVISIONS = 5
REGIONS = 12
WALL = 0.8  # x of the inner side on the unit sphere
RADII = (34, 80, 58)  # mm


def make_sphere():
    golden = (1 + math.sqrt(5)) / 2
    points = [(s, t * golden, 0) for s in (-1, 1) for t in (-1, 1)]
    points += [p[k:] + p[:k] for k in (2, 1) for p in points]
    near = lambda a, b: abs(sum((p - q) ** 2 for p, q in zip(points[a], points[b])) - 4) < 1e-9
    faces = [(a, b, c) for a in range(12) for b in range(a) for c in range(b) if near(a, b) and near(b, c) and near(a, c)]
    points = [normalize(p) for p in points]
    faces = [f if determinant(*(points[v] for v in f)) > 0 else (f[0], f[2], f[1]) for f in faces]
    for _ in range(DIVISIONS):
        faces = divide(points, faces)
    return points, faces


def normalize(p):
    length = math.hypot(*p)
    return tuple(x / length for x in p)


def determinant(a, b, c):
    return (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]))


def divide(points, faces):
    """Four faces for each one; appends the midpoints of the edges."""
    middles = {}

    def middle(a, b):
        key = (min(a, b), max(a, b))
        if key not in middles:
            middles[key] = len(points)
            points.append(normalize([p + q for p, q in zip(points[a], points[b])]))
        return middles[key]

    parts = []
    for a, b, c in faces:
        ab, bc, ca = middle(a, b), middle(b, c), middle(c, a)
        parts += [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
    return parts


def fold(p):
    """A point of the sphere as one of the cortex: the inner side is flat."""
    x, y, z = p
    waves = math.sin(11 * y + 3 * math.sin(5 * z)) + math.cos(12 * z + 3 * math.sin(4 * y + 2 * x))
    depth = 1 + 0.035 * waves * min(1, max(0, (WALL - x) / 0.4))
    return (depth * RADII[0] * min(x, 0.3 + x / 8), depth * RADII[1] * y, depth * RADII[2] * z)


def region(p):
    """0 for the inner side; otherwise the nearest of points on a spiral, counted from 1."""
    if p[0] > WALL:
        return 0

    def closeness(k):
        x, angle = WALL - (WALL + 1) * (k - 0.5) / REGIONS, 2.4 * k
        radius = math.sqrt(1 - x * x)
        return p[0] * x + radius * (p[1] * math.cos(angle) + p[2] * math.sin(angle))

    return max(range(1, REGIONS + 1), key=closeness)


def array(intent, kind, rows):
    columns = f'Dimensionality="2" Dim0="{len(rows)}" Dim1="3"' if isinstance(rows[0], tuple) else \
        f'Dimensionality="1" Dim0="{len(rows)}"'
    text = "\n".join(" ".join(f"{x:.6g}" for x in row) if isinstance(row, tuple) else str(row) for row in rows)
    return (f'<DataArray Intent="NIFTI_INTENT_{intent}" DataType="NIFTI_TYPE_{kind}" ArrayIndexingOrder="RowMajorOrder" '
            f'{columns} Encoding="ASCII" Endian="LittleEndian" ExternalFileName="" ExternalFileOffset="">\n'
            f"<Data>{text}</Data>\n</DataArray>\n")


def write_gifti(path, table, *arrays):
    path.write_text(f'<?xml version="1.0" encoding="UTF-8"?>\n<GIFTI Version="1.0" NumberOfDataArrays="{len(arrays)}">\n'
                    + table + "".join(arrays) + "</GIFTI>\n")


def main():
    folder = pathlib.Path(sys.argv[1])
    points, faces = make_sphere()
    write_gifti(folder / "cortex.surf.gii", "", array("POINTSET", "FLOAT32", [fold(p) for p in points]),
                array("TRIANGLE", "INT32", faces))
    shade = lambda k: f'Red="{0.2 + 0.05 * k:.2f}" Green="{0.9 - 0.06 * k:.2f}" Blue="{0.3 + k % 3 * 0.3:.2f}"'
    labels = [f'<Label Key="{k}" {shade(k)} Alpha="1">lobe_{k}</Label>\n' for k in range(1, REGIONS + 1)]
    table = '<LabelTable>\n<Label Key="0" Red="0" Green="0" Blue="0" Alpha="0">???</Label>\n' + "".join(labels)
    regions = [region(p) for p in points]
    write_gifti(folder / "atlas.label.gii", table + "</LabelTable>\n", array("LABEL", "INT32", regions))
    (folder / "wall.txt").write_text("".join(f"{int(k == 0)}\n" for k in regions))


if __name__ == "__main__":
    main()
