"""Relaxed generators and remeshes."""
from __future__ import annotations

import functools
import os
from typing import TYPE_CHECKING, Any

from . import _gvd
from ._diagram import Diagram
from ._files import PathLike, Writable, forward
from ._points import Points
from ._progress import Progress, reporting

if TYPE_CHECKING:
    from ._mesh import Mesh


class Relaxation(Writable):
    """Generators at the centroids of their cells. `to_file` writes what gvd-lloyd writes with -o, .txt and .csv (the
    generators) and .json included."""

    def __init__(self, mesh: Mesh, native: _gvd.Relaxation) -> None:
        self._relaxation = native
        self.diagram = Diagram(mesh, native.diagram())
        self._native = self.diagram._native

    def __repr__(self) -> str:
        return f"gvd.Relaxation({len(self.generators.face)} generators, energy {self.energies[-1]:.6g})"

    @property
    def generators(self) -> Points:
        """The relaxed generators; views."""
        return self.diagram.generators

    energies = forward(_gvd.Relaxation.energies,
                       "The energy at the start and after each iteration, mesh units to the fourth.", "_relaxation")
    areas = forward(_gvd.Relaxation.areas, "The area of each cell, square mesh units; a view.", "_relaxation")
    cell_energies = forward(_gvd.Relaxation.cell_energies,
                            "The squared distance over each cell, integrated; mesh units to the fourth; a view.", "_relaxation")
    residual = forward(_gvd.Relaxation.residual,
                       "The largest distance of a generator from its centroid, mesh units.", "_relaxation")
    stop = forward(_gvd.Relaxation.stop,
                   'Why it ended: "centroids", "energy", "no descent", "prediction" or "iterations".', "_relaxation")

    def points_to_file(self, path: PathLike) -> None:
        """Writes the generators with normals, areas and energies (.ply, .xyz, .npy), as gvd-lloyd --points does."""
        self._relaxation.write_samples(os.fspath(path))

    def to_vtk(self) -> Any:
        """The surface as vtkPolyData, with Label and Distance of its vertices."""
        return self.diagram.to_vtk()


class RemeshMap:
    """Where the vertices of a surface are on its remesh, and where those of the remesh come from.

    `points`: for each vertex of the surface its point of the remesh. `origins`: for each vertex of the remesh its point
    of the surface. `one_to_one`: whether both come from a map that was checked to be one-to-one.
    """

    def __init__(self, native: _gvd.RemeshMap) -> None:
        self._native = native
        self.points = Points(*native.points())
        self.origins = Points(*native.origins())
        self.one_to_one = native.one_to_one()

    def __repr__(self) -> str:
        return f"gvd.RemeshMap({len(self.points.face)} vertices to {len(self.origins.face)})"

    def to_file(self, path: PathLike) -> None:
        """Writes what gvd-remesh --map writes (JSON)."""
        self._native.write(os.fspath(path))


class Remesh(Writable):
    """A coarse mesh: a vertex for each generator, a triangle for each branch point. `to_file` writes what gvd-remesh
    writes with -o, .json included."""

    _native: _gvd.Remesh

    def __init__(self, surface: Mesh, native: _gvd.Remesh) -> None:
        self.surface = surface
        self._native = native

    def __repr__(self) -> str:
        return f"gvd.Remesh({len(self.mesh.vertices)} vertices, {len(self.mesh.faces)} faces)"

    @functools.cached_property
    def mesh(self) -> Mesh:
        """The coarse mesh."""
        return self.surface._wrap(self._native.mesh())

    @functools.cached_property
    def diagram(self) -> Diagram:
        """The diagram of all generators on the surface; generator i is vertex i of the mesh."""
        return Diagram(self.surface, self._native.diagram())

    figures = forward(_gvd.Remesh.describe,
                      "Generators added and left out, distances to and from the surface (mesh units), mean Q, "
                      "least angle (degrees).")

    def map(self, *, progress: Progress = None) -> RemeshMap:
        """The map between the surface and the coarse mesh."""
        with reporting(progress) as callback:
            return RemeshMap(self._native.map(callback))

    def to_vtk(self) -> Any:
        """The coarse mesh as vtkPolyData."""
        return self.mesh.to_vtk()
