"""What every result can do: write itself to a file, and show its page in a notebook."""
from __future__ import annotations

import html
import os
from collections.abc import Callable
from typing import Any, Optional, TypeVar, Union, cast

from . import _gvd
from ._error import Error
from ._options import checked

PathLike = Union[str, "os.PathLike[str]"]

_HEIGHT = 600
"""Height of the page in a notebook, in pixels."""


T = TypeVar("T")


def forward(method: Callable[[Any], T], doc: str, native: str = "_native") -> T:
    """A property with the value of a method of the object that a result wraps."""
    return cast(T, property(lambda self: method(getattr(self, native)), doc=doc))


class Writable:
    """A result with a file for each extension and a page."""

    _native: Any

    @checked
    def to_file(self, path: PathLike, *, title: str = "gvd", no_curves: bool = False, ascii_ply: bool = False,
                region_materials: bool = False) -> None:
        """Writes a complete file or none, in the format of its extension, as the commands do.

        .ply, .obj, .off, .coff, .stl, .vtp, .vtu, .glb, .surf.gii and .fs (FreeSurfer) hold meshes, .label.gii and
        .annot labels of vertices, .shape.gii and .curv their distances, .html is the page. `title`: of the page.
        `no_curves`: leaves the bisectors out of .obj, .vtp, .vtu and .glb. `ascii_ply`: PLY as text.
        `region_materials`: .obj has a material for each region, in place of the materials that the mesh was read with.
        """
        self._native.write(os.fspath(path), _gvd.WriteOptions(title, no_curves, ascii_ply, region_materials))

    @checked
    def to_html(self, *, title: str = "gvd") -> str:
        """The page as text: one file that any browser opens, without network."""
        page: str = self._native.page(title)
        return page

    def _repr_html_(self) -> Optional[str]:
        try:
            page = html.escape(self.to_html())
        except Error as error:
            if error.code == "invalid_option":  # built without the page: a notebook then prints the object
                return None
            raise
        return f'<iframe srcdoc="{page}" style="width: 100%; height: {_HEIGHT}px; border: 0"></iframe>'
