"""Writes what the package knows of the library from its description: _described.py, and stubs (.pyi) for editors.

    describe.py LIBRARY SOURCES OUTPUT

LIBRARY: libgvd_c.so; SOURCES: the folder gvd beside this file; OUTPUT: the folder of the package that is built. The
functions that are marked @described get the options of their operations in the stubs, as they do in a running program.
"""
import ast
import ctypes
import importlib.util
import json
import pathlib
import sys

RESULTS = {"label": "segment", "map": "remesh"}
"""Operations whose results are of another one's kind."""

HEADER = '''"""What the library says of itself. The build makes this file (python/describe.py)."""
from __future__ import annotations

from typing import Any

VERSION = {version!r}
SONAME = {soname!r}

OPTIONS: dict[str, list[tuple[str, str, Any, str]]] = {options}
"""Of each operation: names, annotations, defaults and help."""

KINDS: dict[str, dict[str, tuple[str, bool]]] = {kinds}
"""Of each option its kind, and whether words stand for values."""

ALSO: dict[str, list[str]] = {also}
"""Of options: other words for them, which have a hint."""

ARRAYS: dict[str, list[str]] = {arrays}
"""Of each kind of objects."""
'''

RUN = [("threads", "int", 0, "for the work; 0: one a core. Results do not depend on it"),
       ("progress", "Progress", None, "True for a bar, or a function of (step, fraction), which ends the call by returning False"),
       ("time_limit", "Optional[float]", None, "seconds above 0 after which the call ends with an error")]
"""How a call runs: options beside those of the operation."""


KINDS = {"bound": "Union[float, str]", "crease angle": "Union[float, str]", "counts": "Sequence[int]", "input file": "str",
         "output file": "str", "switch": "bool", "whole number": "int", "number": "float", "values": "ArrayLike"}
"""Of options that may be None, as Python writes them."""


def annotate(option):
    """The type of an option, as Python's text, and its default."""
    kind, usual = option["kind"], None if option["usual"] else option["default"]  # not one that depends on others
    if kind == "flag":
        return "bool", usual is True
    if kind not in KINDS and kind != "choice":
        return "Any", None
    words = ", ".join(map(repr, option.get("choices", ())))
    plain = f"Literal[{words}]" if kind == "choice" else f"Union[Literal[{words}], {KINDS[kind]}]" if words else KINDS[kind]
    if kind in ("whole number", "number") and isinstance(usual, (int, float)):
        return plain, int(usual) if KINDS[kind] == "int" else float(usual)
    return (plain, usual) if usual in option.get("choices", ()) else (f"Optional[{plain}]", None)


def describe_option(option):
    kind, usual = annotate(option)
    unit = f" ({option['unit']})" if option["unit"] else ""
    otherwise = f". Default: {option['usual']}" if option["usual"] else ""
    return option["name"], kind, usual, option["help"] + unit + otherwise


def describe(library):
    """The text of _described.py."""
    loaded = ctypes.CDLL(str(library))
    loaded.gvd_describe_for.restype = ctypes.c_char_p
    described = json.loads(loaded.gvd_describe_for(1))
    tables = {one["name"]: one["options"] for one in described["operations"]}
    tables["file_options"] = described["file_options"]
    objects = {**described["objects"], **{one["name"]: one["result"] for one in described["operations"]
                                          if one["name"] not in (*RESULTS, "diagram", "mesh")}}
    major, minor = described["version"].split(".")[:2]
    return HEADER.format(
        version=described["version"], soname=f"libgvd_c.so.{major}.{minor}",
        options=pretty({name: [*map(describe_option, options), *(() if name in ("mesh", "file_options") else RUN)]
                        for name, options in tables.items()}),
        kinds=pretty({name: {one["name"]: (one["kind"], bool(one.get("choices"))) for one in options}
                      for name, options in tables.items()}),
        also=pretty({one["name"]: one["also"] for options in tables.values() for one in options if one["also"]}),
        arrays=pretty({name: [one["name"] for one in made["arrays"]] for name, made in objects.items()}))


def pretty(table):
    return "{\n" + "".join(f"    {key!r}: {value!r},\n" for key, value in table.items()) + "}"


class Stub(ast.NodeTransformer):
    """Leaves the signatures of a module."""

    def __init__(self, options):
        self.options = options
        self.expanded = {}

    def visit_ClassDef(self, node):
        made = [one for function in node.body if isinstance(function, ast.FunctionDef) and function.name == "__init__"
                for one in function.body if isinstance(one, ast.AnnAssign) and isinstance(one.target, ast.Attribute)]
        attributes = [ast.AnnAssign(ast.Name(one.target.attr), one.annotation, None, 1) for one in made]
        self.expanded = {function.name: marks for function in node.body if isinstance(function, ast.FunctionDef)
                         and (marks := self.marks(function))}
        overloaded = {one.name for one in node.body if isinstance(one, ast.FunctionDef) and self.is_overload(one)}
        kept = [self.visit(one) for one in node.body if getattr(one, "name", "") not in overloaded or self.is_overload(one)]
        node.body = [*kept, *attributes]
        self.expanded = {}
        return node

    def visit_FunctionDef(self, node):
        marks = self.marks(node) or self.expanded.get(node.name)
        node.decorator_list = [one for one in node.decorator_list if self.operation(one) is None]
        if marks and node.args.kwarg:
            own = [one.arg for one in (*node.args.args, *node.args.kwonlyargs)]
            node.args.kwarg = None
            for name, kind, usual, _ in self.options[marks["operation"]]:
                if name not in (*own, *marks["without"]):
                    node.args.kwonlyargs.append(ast.arg(name, ast.parse(kind, mode="eval").body))
                    node.args.kw_defaults.append(ast.Constant(usual))
        node.body = [ast.Expr(ast.Constant(...))]
        return node

    def visit_AnnAssign(self, node):
        """What `view` and `figure` make is a property."""
        if getattr(getattr(node.value, "func", None), "id", "") not in ("view", "figure"):
            return node
        function = ast.parse(f"@property\ndef {node.target.id}(self): ...").body[0]
        function.returns = node.annotation
        return function

    def visit_Assign(self, node):
        is_alias = isinstance(node.value, (ast.Subscript, ast.Name))
        return node if is_alias else ast.AnnAssign(node.targets[0], ast.Name("Any"), None, 1)

    @staticmethod
    def is_overload(function):
        return any(getattr(one, "id", "") == "overload" for one in function.decorator_list)

    @staticmethod
    def operation(decorator):
        is_mark = isinstance(decorator, ast.Call) and getattr(decorator.func, "id", "") == "described"
        return decorator if is_mark else None

    def marks(self, node):
        """What a function is marked with: its operation, and the options that it is without."""
        for decorator in filter(None, map(self.operation, node.decorator_list)):
            given = {one.arg: ast.literal_eval(one.value) for one in decorator.keywords}
            return {"operation": decorator.args[0].value, "without": given.get("without", "").split()}
        return None


MORE = "from collections.abc import Sequence\nfrom typing import Any, Literal, Optional, Union\n\n" \
       "from numpy.typing import ArrayLike\n\nfrom ._progress import Progress\n"


def main(library, sources, output):
    output.mkdir(parents=True, exist_ok=True)
    (output / "_described.py").write_text(describe(library), encoding="utf-8")
    spec = importlib.util.spec_from_file_location("_described", output / "_described.py")
    table = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(table)

    for source in sources.glob("*.py"):
        text = source.read_text(encoding="utf-8")
        if "@described(" in text and source.name != "_options.py":
            tree = ast.fix_missing_locations(Stub(table.OPTIONS).visit(ast.parse(text)))
            future = "from __future__ import annotations\n"
            (output / f"{source.stem}.pyi").write_text(ast.unparse(tree).replace(future, future + MORE), encoding="utf-8")


if __name__ == "__main__":
    main(*map(pathlib.Path, sys.argv[1:]))
