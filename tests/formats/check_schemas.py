"""The JSON of the commands follows the schemas of docs/schema: check_schemas.py BIN_FOLDER WORK_FOLDER.

The schemas allow members that they do not name, so that later versions can add some. Here each member must be named.
"""
import json
import os
import pathlib
import re
import subprocess
import sys

import files
import jsonschema

bin_folder, work = map(pathlib.Path, sys.argv[1:])
SCHEMAS = pathlib.Path(__file__).resolve().parents[2] / "docs" / "schema"


def strict(schema):
    """The schema with every member forbidden that it does not name."""
    if isinstance(schema, list):
        return [strict(item) for item in schema]
    if not isinstance(schema, dict):
        return schema
    result = {key: strict(value) for key, value in schema.items()}
    if schema.get("type") == "object" and "properties" in schema:
        result.setdefault("additionalProperties", False)
    return result


def load(name):
    schema = json.loads((SCHEMAS / f"{name}.schema.json").read_text())
    jsonschema.Draft202012Validator.check_schema(schema)
    return schema


def errors(schema, document):
    found = list(jsonschema.Draft202012Validator(schema).iter_errors(document))
    return [f"{'/'.join(map(str, e.absolute_path))}: {e.message[:200]}" for e in found]


def check(name):
    document = json.loads((work / name).read_text())
    schema = load(document["schema"].replace("/", "-"))
    found = errors(strict(schema), document)
    assert not found, f"{name}: " + "; ".join(found[:5])
    # A schema that allows everything would be no check: each required member is missed, each wrong type seen.
    is_valid = jsonschema.Draft202012Validator(schema).is_valid  # ends at the first error
    for member in schema["required"]:
        assert not is_valid({key: value for key, value in document.items() if key != member}), f"{name}: nobody misses {member}"
        wrong = 7 if isinstance(document[member], bool) else True
        assert not is_valid({**document, member: wrong}), f"{name}: {member} may be {wrong}"
    return document


def save_manifest(name, *arguments):
    """The manifest of a page, as a file of its own."""
    files.run(bin_folder, work, *arguments, "--view", "page.html")
    page = (work / "page.html").read_text()
    manifest = re.search('<script type="application/json" id="manifest">(.*?)</script>', page, re.DOTALL)
    (work / name).write_text(manifest.group(1))


def write_documents():
    files.write_files(bin_folder, work)
    vertices = ["--vertices", ",".join(map(str, files.GENERATORS))]
    run = lambda *arguments: files.run(bin_folder, work, *arguments)
    run("gvd-segment", "sheet.off", *vertices, "-o", "s.json", "--report", "s-report.json")
    run("gvd-segment", "sheet.off", *vertices, "--cut", "-o", "c.json", "--diagram", "d.json", "--report", "c-report.json")
    run("gvd-segment", "ball.off", "-n", "4", "--method", "gbgvd", "-o", "g.json", "--report", "g-report.json")
    run("gvd-segment", "ball.off", "--levels", "2,5", "-o", "n.json", "-o", "n.ply", "--report", "n-report.json")
    run("gvd-segment", "n.ply", "--within", "label_1", "-n", "9", "--cut", "-o", "i.json", "--report", "i-report.json")
    run("gvd-segment", "ball.off", "-n", "1", "--disc", "--uv", "flat", "-o", "u.json", "--report", "u-report.json")
    run("gvd-segment", "ball.off", "-n", "3", "--uv", "logmap", "-o", "u.obj", "--report", "o-report.json")
    run("gvd-lloyd", "ball.off", "-n", "6", "--sampling", "random", "-o", "l.json", "--report", "l-report.json")
    run("gvd-remesh", "ball.off", "--generators", "l.json", "-o", "r.json", "--map", "m.json", "--report", "r-report.json")
    run("gvd-distance", "sheet.off", "--from", "0,80", "--to", "3,77,155", "--paths", "--isolines", ".5", "--max-distance", "2",
        "-o", "distance.json", "--report", "d-report.json")
    run("gvd-distance", "n.ply", "--from", "0", "--within", "label_1", "-o", "h.json", "--report", "h-report.json")
    run("gvd-distance", "ball.off", "--from", "0,9", "--each", "-o", "each.json", "--report", "e-report.json")
    run("gvd-segment", "ball.off", "-n", "4", "--balance", "area", "-o", "b.json", "--report", "b-report.json")
    run("gvd-lloyd", "ball.off", "-n", "4", "--balance", "area", "--report", "w-report.json")
    (work / "list.txt").write_text("p 0 0 1.5\n3\n")
    run("gvd-remesh", "ball.off", "--generators", "list.txt", "--report", "p-report.json")
    subprocess.run([str(bin_folder / "test_io"), "[.list]"], check=True, stdout=subprocess.DEVNULL,
                   env={**os.environ, "GVD_LIST_SAMPLE": str(work / "list.json")})


write_documents()
assert "face_labels" in check("s.json")
assert None in check("c.json")["cut_mesh"]["vertex_distances"]
assert sorted(check("n.json")["face_numbers"]) == ["label_1", "label_2"]
assert len(check("i.json")["cut_mesh"]["face_numbers"]["region"]) == len(check("i.json")["cut_mesh"]["faces"])
assert "remesh" in check("r.json")
assert check("m.json")["output_vertices"]
assert "snap_distance" in check("p-report.json")["generators"][0]
distances = check("distance.json")
assert None in distances["distances"][0] and distances["paths"][0]["points"] and distances["isolines"]
assert check("each.json")["nearest"] is None
assert len(check("b.json")["weights"]) == 4
for name in ["d.json", "g.json", "l.json", "list.json"] + [f"{x}-report.json" for x in "scgnilrdebwuoh"]:
    check(name)
assert check("h-report.json")["results"]["within"]["regions"] > 0
if files.has_viewer(bin_folder, work):
    save_manifest("v1.json", "gvd-segment", "sheet.off", "--vertices", "0,77")
    save_manifest("v2.json", "gvd-remesh", "ball.off", "-n", "2")
    save_manifest("v3.json", "gvd-segment", "ball.off", "-n", "9", "--method", "gbgvd")
    save_manifest("v4.json", "gvd-distance", "ball.off", "--from", "0", "--to", "9", "--paths", "--isolines", ".5")
    for name in ("v1.json", "v2.json", "v3.json", "v4.json"):
        check(name)
