"""nibabel reads GIFTI and FreeSurfer's files, and writes them for the commands: read_with_nibabel.py BIN_FOLDER WORK_FOLDER.

wb_command of the Connectome Workbench reads them, too, where it is installed.
"""
import os
import pathlib
import shutil
import subprocess
import sys

import files
import nibabel
import numpy
from nibabel import freesurfer, gifti

bin_folder, work = map(pathlib.Path, sys.argv[1:])
diagram, points, faces = files.write_files(bin_folder, work)
sheet = ["gvd-segment", "sheet.off", "--vertices", ",".join(map(str, files.GENERATORS))]
run = lambda *arguments: files.run(bin_folder, work, *arguments)
run(*sheet, *files.outputs("whole", "surf.gii", "label.gii", "shape.gii"), "-o", "lh.annot", "-o", "lh.curv")
run(*sheet, "-o", "lh.white", "--output-format", "fs", "--vertex-labels", "lh.other.annot", "--vertex-distances", "b.func.gii")
singles = numpy.array(points, dtype=numpy.float32)
distances = numpy.array(files.unnull(diagram["vertex_distances"]), dtype=numpy.float32)
keys = numpy.array(diagram["vertex_labels"]) + 1
assert (keys == 0).any() and numpy.isinf(distances).any(), "nothing is unreached"


def file_colors():
    """The colour of each label, from the vertices of the PLY."""
    header, _, body = (work / "text.ply").read_text().partition("end_header\n")
    names = [line.split()[-1] for line in header.partition("element face")[0].splitlines() if line.startswith("property")]
    rows = [dict(zip(names, line.split())) for line in body.splitlines()[: len(points)]]
    return {int(row["label"]) + 1: tuple(int(row[c]) for c in ("red", "green", "blue")) for row in rows}


def check_gifti():
    read_points, read_faces = nibabel.load(work / "whole.surf.gii").agg_data()
    assert (read_points == singles).all() and (read_faces == numpy.array(faces)).all()
    labels = nibabel.load(work / "whole.label.gii")
    assert (labels.agg_data() == keys).all() and labels.darrays[0].intent == nibabel.nifti1.intent_codes["NIFTI_INTENT_LABEL"]
    names = labels.labeltable.get_labels_as_dict()
    assert names[0] == "???" and names[3] == "region_2" and len(names) == len(files.GENERATORS) + 1
    colors = {label.key: tuple(round(255 * x) for x in label.rgba[:3]) for label in labels.labeltable.labels}
    assert {key: colors[key] for key in file_colors()} == file_colors(), "other colours than in PLY"
    assert (nibabel.load(work / "whole.shape.gii").agg_data() == distances).all()
    assert (work / "b.func.gii").read_bytes() == (work / "whole.shape.gii").read_bytes()


def check_freesurfer():
    read_points, read_faces = freesurfer.read_geometry(work / "lh.white")
    assert (read_points == singles).all() and (read_faces == numpy.array(faces)).all()
    labels, table, names = freesurfer.read_annot(work / "lh.annot")
    assert (labels == keys).all() and names[0] == b"???" and names[3] == b"region_2"
    for key, color in file_colors().items():
        assert abs(table[key, :3] - color).max() <= 7, "other colours than in PLY"
    assert len(set(table[:, 4])) == len(names), "two regions have one colour"
    assert (work / "lh.other.annot").read_bytes() == (work / "lh.annot").read_bytes()
    assert (freesurfer.read_morph_data(work / "lh.curv") == distances).all()


def write_gifti(name, *arrays, encoding="B64GZ"):
    """Arrays: of numbers, intent and type."""
    made = [gifti.GiftiDataArray(numbers, f"NIFTI_INTENT_{intent}", f"NIFTI_TYPE_{of}", encoding=f"GIFTI_ENCODING_{encoding}")
            for numbers, intent, of in arrays]
    (work / name).write_bytes(gifti.GiftiImage(darrays=made).to_xml())


def check_inputs():
    """The commands make the same of all surfaces, and of all files of values."""
    files.write_off(work / "singles.off", singles.astype(float).tolist(), faces)
    surfaces, values = ["singles.off", "whole.surf.gii", "lh.white", "n.white"], ["text.txt", "n.curv", "n.npy"]
    corners, weights = numpy.array(faces, numpy.int32), numpy.arange(1, len(points) + 1, dtype=numpy.float32) / 4
    for encoding in ("ASCII", "B64BIN", "B64GZ"):
        values.append(f"{encoding}.shape.gii")
        write_gifti(values[-1], (weights, "SHAPE", "FLOAT32"), encoding=encoding)
        if encoding == "ASCII":
            continue  # nibabel writes six decimals
        surfaces.append(f"{encoding}.surf.gii")
        write_gifti(surfaces[-1], (singles, "POINTSET", "FLOAT32"), (corners, "TRIANGLE", "INT32"), encoding=encoding)
    # The names of nibabel's own constants, which some programs write into files.
    spelled = (work / "B64GZ.surf.gii").read_text()
    for written, name in (("GZipBase64Binary", "GIFTI_ENCODING_B64GZ"), ("LittleEndian", "GIFTI_ENDIAN_LITTLE"),
                          ("RowMajorOrder", "GIFTI_IND_ORD_ROW_MAJOR")):
        assert written in spelled
        spelled = spelled.replace(written, name)
    (work / "spelled.surf.gii").write_text(spelled)
    surfaces.append("spelled.surf.gii")
    freesurfer.write_geometry(work / "n.white", singles, corners, "created by a test")
    freesurfer.write_morph_data(work / "n.curv", weights)
    numpy.save(work / "n.npy", weights)
    (work / "text.txt").write_text(" ".join(map(str, weights.tolist())))
    (work / "n.csv").write_text("vertex,value\n" + "".join(f"{i},{w}\n" for i, w in enumerate(weights.tolist())))
    values.append("n.csv")
    compare(surfaces, lambda name: ["gvd-segment", name, "--vertices", "0,45,77", "--ascii-ply"])
    compare(values, lambda name: ["gvd-lloyd", "sheet.off", "-n", "4", "--density", name])


def compare(names, arguments):
    made = {}
    for name in names:
        run(*arguments(name), "-o", "made.ply")
        made.setdefault((work / "made.ply").read_bytes(), []).append(name)
    assert len(made) == 1, list(made.values())


def check_labels():
    """The key of a label, and the number of a region in an annotation, are values: both give one density."""
    numbers = numpy.array([1 + i % 3 for i in range(len(points))], dtype=numpy.int32)
    write_gifti("n.label.gii", (numbers, "LABEL", "INT32"))
    table = numpy.array([[25, 5, 25, 0], [220, 20, 20, 0], [20, 220, 20, 0], [20, 20, 220, 0]])
    freesurfer.write_annot(work / "n.annot", numbers, table, ["unknown", "a", "b", "c"], fill_ctab=True)
    (work / "labels.txt").write_text(" ".join(map(str, numbers)))
    compare(["labels.txt", "n.label.gii", "n.annot"], lambda name: ["gvd-lloyd", "sheet.off", "-n", "4", "--density", name])


def check_workbench():
    ask = lambda *words: subprocess.run(["wb_command", *words], cwd=work, check=True, text=True, capture_output=True,
                                        env={**os.environ, "QT_QPA_PLATFORM": "offscreen"}).stdout
    assert f"Number of Vertices: {len(points)}" in " ".join(ask("-file-information", "whole.surf.gii").split())
    ask("-label-export-table", "whole.label.gii", "table.txt")
    assert "region_2\n3 " in (work / "table.txt").read_text()
    least = float(ask("-metric-stats", "whole.shape.gii", "-reduce", "MIN"))
    assert abs(least - distances.min()) < 1e-6
    ask("-surface-vertex-areas", "whole.surf.gii", "areas.shape.gii")
    assert (nibabel.load(work / "areas.shape.gii").agg_data() > 0).all()


check_gifti()
check_freesurfer()
check_inputs()
check_labels()
if shutil.which("wb_command"):
    check_workbench()
