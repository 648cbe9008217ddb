"""Meshes of a folder, as the battery takes them."""
import re
import shutil

from meshes import HostileMesh


class FileMesh(HostileMesh):
    """A file of which only the number of faces is known. It may be refused for its defects."""

    def __init__(self, path, faces):
        super().__init__(path.stem, range(faces // 2 + 1), range(faces), refused=(3, 4))
        self.path = path

    def write(self, path):
        shutil.copyfile(self.path, path)


def count_faces(path):
    """How many faces a file holds, roughly where polygons will be cut; 0 where it can't be told."""
    data = path.read_bytes()
    words = re.sub(rb"#.*", b"", data[:4096]).split()
    try:
        if path.suffix == ".off":
            return int([word for word in words if word.isdigit()][1])
        if path.suffix == ".ply":
            return int(words[words.index(b"face") + 1])
    except (IndexError, ValueError):
        return 0
    if path.suffix == ".obj":
        return len(re.findall(rb"^f ", data, re.MULTILINE))
    return data.count(b"endfacet") or (len(data) - 84) // 50


def corpus_meshes(folder, most_faces):
    """The files of a folder, each as the name in.off: the commands tell the format from the content."""
    meshes = []
    for path in sorted(folder.rglob("*")):
        faces = count_faces(path) if path.suffix in (".off", ".obj", ".ply", ".stl") else 0
        if 0 < faces <= most_faces:
            meshes.append(FileMesh(path, faces))
    return meshes
