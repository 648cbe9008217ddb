"""Exact geodesic Voronoi diagrams, distances and paths on triangle meshes.

>>> import gvd
>>> mesh = gvd.read("data/figure.obj")
>>> regions = mesh.segment(30)
>>> regions.to_file("/tmp/regions.html")  # or, in a notebook: regions

NumPy arrays go in and come out; what has a name in the commands has the same name here, and gives the same bytes. Long
calls let other threads run, take progress=True or a function, and end at Ctrl-C. What can't be done raises gvd.Error.
"""
from ._diagram import Balanced, Bisector, BranchPoints, Cell, Chart, Cut, Diagram, Segmentation
from ._editor import DiagramEditor
from ._error import Error
from ._gvd import version as __version__
from ._mesh import Mesh, read, read_properties, read_values
from ._path import Path
from ._points import Curves, Points
from ._remesh import Relaxation, Remesh, RemeshMap

__all__ = ["Balanced", "Bisector", "BranchPoints", "Cell", "Chart", "Curves", "Cut", "Diagram", "DiagramEditor", "Error", "Mesh",
           "Path", "Points", "Relaxation", "Remesh", "RemeshMap", "Segmentation", "__version__", "read",
           "read_properties", "read_values"]
