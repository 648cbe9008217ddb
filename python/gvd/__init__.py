"""Exact geodesic Voronoi diagrams, distances and paths on triangle meshes.

>>> import gvd
>>> mesh = gvd.read("data/figure.obj")
>>> regions = mesh.segment(30)
>>> regions.to_file("/tmp/regions.html")  # or, in a notebook: regions

NumPy arrays go in and come out; what has a name in the commands has the same name here, and gives the same bytes. Long
calls let other threads run, take progress=True or a function, and end at Ctrl-C. What can't be done raises gvd.Error.
"""
from ._interpreter import check_interpreter

check_interpreter()

from ._described import VERSION as __version__  # noqa: E402
from ._editor import DiagramEditor  # noqa: E402
from ._error import Error  # noqa: E402
from ._mesh import Mesh, read, read_properties, read_values  # noqa: E402
from ._points import Curves, Point, Points  # noqa: E402
from ._results import (Balanced, Bisector, BranchPoints, Cell, Cells, Chart, Cut, Diagram, Isoline, Path, Relaxation,  # noqa: E402
                       Remesh, RemeshMap, Segmentation)

__all__ = ["Balanced", "Bisector", "BranchPoints", "Cell", "Cells", "Chart", "Curves", "Cut", "Diagram", "DiagramEditor", "Error", "Isoline",
           "Mesh", "Path", "Point", "Points", "Relaxation", "Remesh", "RemeshMap", "Segmentation", "__version__", "read",
           "read_properties", "read_values"]
