"""networkx reads the graph of the regions: read_with_networkx.py BIN_FOLDER WORK_FOLDER."""
import math
import pathlib
import sys

import files
import networkx

work = pathlib.Path(sys.argv[2])
diagram, points, faces = files.write_files(sys.argv[1], work)
graph = networkx.read_graphml(work / "whole.graphml")
cells = diagram["cells"]
assert not graph.is_directed() and not graph.is_multigraph()
assert list(graph.nodes) == [str(c["generator"]) for c in cells]
lengths = {}
for bisector in diagram["bisectors"]:
    p = [point["position"] for point in bisector["points"]] + [bisector["points"][0]["position"]] * bisector["closed"]
    pair = tuple(sorted((bisector["left"], bisector["right"])))
    lengths[pair] = lengths.get(pair, 0) + sum(math.dist(a, b) for a, b in zip(p, p[1:]))
for cell, generator in zip(cells, diagram["generators"]):
    node = graph.nodes[str(cell["generator"])]
    assert node["label"] == cell["generator"] and node["area"] == cell["area"]
    assert [node["x"], node["y"], node["z"]] == generator["position"]
    assert sorted(int(n) for n in graph[str(cell["generator"])]) == cell["neighbours"]
assert {tuple(sorted(map(int, e))) for e in graph.edges} == set(lengths)
for (a, b), length in lengths.items():
    assert math.isclose(graph.edges[str(a), str(b)]["length"], length, rel_tol=1e-12)
assert networkx.is_connected(graph)
