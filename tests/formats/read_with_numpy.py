"""NumPy reads what the commands write: read_with_numpy.py BIN_FOLDER WORK_FOLDER."""
import base64
import json
import pathlib
import re
import sys
import zlib

import files
import numpy

bin_folder, work = map(pathlib.Path, sys.argv[1:])
diagram, points, faces = files.write_files(bin_folder, work)
sheet = ["sheet.off", "--vertices", ",".join(map(str, files.GENERATORS))]
files.run(bin_folder, work, "gvd-segment", *sheet, "--face-labels", "labels.npy", "--vertex-distances", "segment.npy")
labels, distances = numpy.load(work / "labels.npy"), numpy.load(work / "segment.npy")
assert labels.dtype == numpy.dtype("<i4") and distances.dtype == numpy.dtype("<f8")
assert labels.tolist() == diagram["face_labels"]
assert distances.tolist() == files.unnull(diagram["vertex_distances"]) and numpy.isinf(distances).any()

sources = ["--from", ",".join(map(str, files.GENERATORS))]
files.run(bin_folder, work, "gvd-distance", "sheet.off", *sources, "-o", "nearest.npy", "-o", "nearest.csv")
files.run(bin_folder, work, "gvd-distance", "sheet.off", *sources, "--each", "-o", "each.npy")
files.run(bin_folder, work, "gvd-distance", "sheet.off", *sources, "--to", "0,5", "--each", "-o", "some.npy")
nearest, each, some = (numpy.load(work / f"{name}.npy") for name in ("nearest", "each", "some"))
assert nearest.shape == (len(points),) and each.shape == (len(files.GENERATORS), len(points))
assert some.shape == (len(files.GENERATORS), 2) and (some == each[:, [0, 5]]).all()
assert numpy.allclose(nearest, distances, rtol=1e-12, atol=1e-14)
assert numpy.allclose(nearest, each.min(axis=0), rtol=1e-12, atol=1e-14)
table = numpy.genfromtxt(work / "nearest.csv", delimiter=",", names=True)
assert table.dtype.names == ("source", "vertex", "distance", "source_vertex") and (table["distance"] == nearest).all()
reached = table["source"] >= 0
assert (table["source_vertex"][reached] == numpy.array(files.GENERATORS)[table["source"][reached].astype(int)]).all()


def page_colors(name):
    """Red, green and blue of the labels in the last picture of a page."""
    page = (work / name).read_text()
    manifest = json.loads(re.search('id="manifest">(.*?)</script>', page, re.DOTALL).group(1))
    fills = max(manifest["scenes"], key=lambda scene: scene.get("iteration", 0))["fills"]
    assert fills["type"] == "u8"
    data = zlib.decompress(base64.b64decode(re.search(f'id="blob-{fills["blob"]}">(.*?)</script>', page, re.DOTALL).group(1)))
    return numpy.frombuffer(data, "u1").reshape(-1, 3).tolist()


def file_colors(name):
    """The same of the labels of vertices in a PLY as text."""
    head, body = (work / name).read_text().split("end_header\n")
    count = int(re.search(r"element vertex (\d+)", head).group(1))
    rows = [line.split() for line in body.split("\n")[:count]]
    return files.one_color_each([int(row[4]) for row in rows], [tuple(map(int, row[5:8])) for row in rows])


if files.has_viewer(bin_folder, work):
    for call in (["gvd-segment", "-n", "30"], ["gvd-segment", "-n", "30", "--cut"], ["gvd-segment", "-n", "9", "--labels", "nearest"],
                 ["gvd-lloyd", "-n", "20", "--iterations", "5"], ["gvd-lloyd", "-n", "12", "--method", "gbgvd"]):
        files.run(bin_folder, work, call[0], "ball.off", *call[1:], "--ascii-ply", "-o", "colors.ply", "--view", "colors.html")
        shown, written = page_colors("colors.html"), file_colors("colors.ply")
        assert {k: tuple(shown[k]) for k in written if k >= 0} == {k: v for k, v in written.items() if k >= 0}, call
        assert len(set(written.values())) > 3, call
