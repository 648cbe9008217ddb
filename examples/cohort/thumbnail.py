"""A small picture of a mesh in the colours of its faces: what the commands write as .ply, drawn as .png.

Faces are sampled densely enough for the pixels; of all samples in a pixel, the nearest one to the viewer is seen. Needs the
Python package gvd, and numpy.
"""
import struct
import warnings
import zlib

import gvd
import numpy as np

SIDE = 200  # pixels of the picture
FINE = 2  # each way, samples of a pixel: their mean smooths edges
PLAIN = (205, 208, 214)  # colour of a mesh without colours
SHADES = 12  # values of red, green and blue are multiples of this, which halves the file
# Directions in a picture whose top is y: to the right, up, and towards the viewer; turned a little, as the pages open.
VIEW = np.array([[0.82, 0.0, -0.57], [-0.2, 0.94, -0.28], [0.54, 0.34, 0.77]])
LIGHT = np.array([0.25, 0.45, 0.86])
# For each axis that points up, the axes of the mesh that become x, y and z of the picture, with their signs.
AXES = {"x": (2, 0, 1), "y": (0, 1, 2), "z": (1, 2, 0)}


def read_ply(path):
    """Positions, faces, and colours of the corners of faces.

    A face that has no region, as the bisectors cross it, has the colours of its vertices.
    """
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # what is repaired looks the same
        mesh = gvd.read(path)
    points, corners, rows = mesh.vertices.copy(), mesh.faces.copy(), {"face": mesh.input_face.copy(), "vertex": mesh.input_vertex.copy()}
    del mesh  # it holds more than its arrays
    properties = gvd.read_properties(path)
    if "red" not in properties["face"] or "label" not in properties["face"]:
        return points, corners, np.broadcast_to(np.array(PLAIN, "u1"), (*corners.shape, 3))

    def colours_of(element):
        return np.stack([properties[element][name][rows[element]].astype("u1") for name in ("red", "green", "blue")], 1)
    unlabelled = properties["face"]["label"][rows["face"]] < 0
    return points, corners, np.where(unlabelled[:, None, None], colours_of("vertex")[corners], colours_of("face")[:, None, :])


def project(points, up):
    """Positions in a picture of FINE * SIDE pixels, and their distances towards the viewer in the third column."""
    turned = points[:, AXES[up[-1]]] * (1, -1 if up[0] == "-" else 1, 1 if up[0] != "-" else -1)
    seen = turned @ VIEW.T
    low, high = seen.min(0), seen.max(0)
    scale = (FINE * SIDE - 3) / max((high - low)[:2].max(), 1e-300)
    return (seen - (low + high) / 2) * scale * (1, -1, 1) + (FINE * SIDE / 2, FINE * SIDE / 2, 0)


def sample_faces(corners):
    """Pixels, depths and corners of samples; the samples of a face are less than a pixel apart, and have its nearest corner."""
    longest = np.linalg.norm(np.roll(corners, 1, 1) - corners, axis=2).max(1)
    level = np.ceil(np.log2(np.maximum(longest, 1))).astype(int)
    for parts in np.unique(level):
        chosen = np.flatnonzero(level == parts)
        steps = 2 ** int(parts)
        weights = np.array([(i, j, steps - i - j) for i in range(steps + 1) for j in range(steps + 1 - i)]) / steps
        for block in np.array_split(chosen, 1 + len(chosen) * len(weights) // 300000):
            samples = np.einsum("sk,fkd->fsd", weights, corners[block]).reshape(-1, 3)
            pixels = samples[:, 1].astype(int) * FINE * SIDE + samples[:, 0].astype(int)
            yield pixels, samples[:, 2], (3 * block[:, None] + weights.argmax(1)).ravel()


def draw(path, up="y"):
    """The picture of a mesh, SIDE x SIDE x 4 bytes: red, green, blue and opacity."""
    points, faces, colours = read_ply(path)
    corners = project(points, up)[faces]
    nearest = np.full((FINE * SIDE) ** 2, -np.inf)
    seen = np.full((FINE * SIDE) ** 2, -1)
    for pixel, depth, corner in sample_faces(corners):
        order = np.argsort(depth, kind="stable")
        order = order[depth[order] > nearest[pixel[order]]]
        nearest[pixel[order]] = depth[order]  # of equal pixels, the last one stays
        seen[pixel[order]] = corner[order]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    lengths = np.maximum(np.linalg.norm(normals, axis=1), 1e-300)
    bright = 0.35 + 0.65 * np.abs(normals / lengths[:, None] @ (LIGHT * (1, -1, 1)))
    image = np.zeros(((FINE * SIDE) ** 2, 4))
    hit = seen >= 0
    image[hit, :3] = colours.reshape(-1, 3)[seen[hit]] * bright[seen[hit] // 3, None]
    image[hit, 3] = 255
    image = image.reshape(SIDE, FINE, SIDE, FINE, 4).sum((1, 3))
    opaque = np.maximum(image[..., 3:] / 255, 1)
    shades = (image[..., :3] / opaque / SHADES).round() * SHADES
    return np.concatenate([shades, image[..., 3:] / FINE**2], 2).round().astype(np.uint8)


def encode_png(image):
    """A picture of 8-bit red, green, blue and opacity as PNG."""
    height, width = image.shape[:2]
    rows = b"".join(b"\0" + row.tobytes() for row in image)
    chunks = ((b"IHDR", struct.pack(">2I5B", width, height, 8, 6, 0, 0, 0)), (b"IDAT", zlib.compress(rows, 9)), (b"IEND", b""))
    return b"\x89PNG\r\n\x1a\n" + b"".join(
        struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data)) for name, data in chunks)
