"""What a step costs on a mesh, by the size of its file: measured by measure.py, told in docs/guide/many-meshes.md."""
import math
import os
import re
import struct

# Megabytes, and seconds of processor time: of any mesh, of a million faces, and of a thousand generators.
MEGABYTES = {"segment": (58.0, 244, 0.3), "relax": (59.7, 473, 24.5), "remesh": (53.1, 326, 1.8)}
SECONDS = {"segment": (0.35, 3.6, 0.1), "relax": (0.6, 10.0, 1.5), "remesh": (0.4, 4.6, 0.1)}

# What a job gets, as multiples of the formula. On 17 meshes no step took more than 1.7 times the memory and 3.1 times the time;
# the rest is for slower machines, and for rough surfaces.
MEMORY_MARGIN = 2
TIME_MARGIN = 8
JOB_MEGABYTES = 150  # of Snakemake and step.py in a job of a cluster: they hold 90
LEAST_MINUTES = 5  # a job's start, and Python's, on a busy file system

# Fewest bytes of a face, with its share of half a vertex, in files whose faces are not counted by their start. Packed files hold
# more than their bytes tell: they are no default.
BYTES_OF_A_FACE = {".obj": 28, ".stl": 120, ".vtk": 22, ".glb": 12}
LEAST_BYTES_OF_A_FACE = 8  # "3 0 1 2\n"; a binary face has 13


def estimate_faces(path):
    """Faces of a mesh by the start of its file, or the most that its bytes can hold. Polygons count once.

    A file that can't be read has none: its steps say why. A damaged one may tell of more faces than it can hold.
    """
    try:
        size = os.path.getsize(path)
        with open(path, "rb") as file:
            start = file.read(65536)
    except OSError:
        return 0
    most = size // LEAST_BYTES_OF_A_FACE
    if start.startswith(b"ply") and (found := re.search(rb"\nelement face (\d+)", start)):
        return min(int(found[1]), most)
    words = re.sub(rb"#[^\n]*", b"", start).split()
    if len(words) > 2 and words[0].endswith(b"OFF") and words[2].isdigit():
        return min(int(words[2]), most)
    if len(start) >= 84 and size == 84 + 50 * struct.unpack_from("<I", start, 80)[0]:
        return struct.unpack_from("<I", start, 80)[0]
    return size // BYTES_OF_A_FACE.get(os.path.splitext(path)[1].lower(), 19)  # binary .ply: 13 and half of 12 bytes


def formula(constants, faces, n):
    fixed, of_faces, of_generators = constants
    return fixed + of_faces * faces / 1e6 + of_generators * n / 1e3


def megabytes(step, path, n, attempt=1):
    """Memory for a job; a further attempt gets more."""
    return JOB_MEGABYTES + math.ceil(attempt * MEMORY_MARGIN * formula(MEGABYTES[step], estimate_faces(path), n))


def minutes(step, path, n, attempt=1):
    """Time for a job with one thread; a further attempt gets more."""
    return math.ceil(attempt * (LEAST_MINUTES + TIME_MARGIN * formula(SECONDS[step], estimate_faces(path), n) / 60))
