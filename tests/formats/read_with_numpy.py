"""NumPy reads what the commands write: read_with_numpy.py BIN_FOLDER WORK_FOLDER."""
import pathlib
import sys

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
assert table.dtype.names == ("source", "vertex", "distance") and (table["distance"] == nearest).all()
