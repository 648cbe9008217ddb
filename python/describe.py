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

import ast
from typing import Any, Optional

VERSION = {version!r}
SONAME = {soname!r}

OPTIONS: dict[str, list[tuple[str, str, str, str]]] = {options}
"""Of each operation: names, annotations, defaults and help."""

KINDS: dict[str, dict[str, tuple[str, bool, Optional[str]]]] = {kinds}
"""Of each option its kind, whether words stand for values, and what numbers are of."""

ARRAYS: dict[str, list[str]] = {arrays}
"""Of each kind of objects."""


def value(text: str) -> Any:
    return ast.literal_eval(text)
'''


def annotate(option):
    """The type of an option and its default, both as Python's text."""
    kind, usual = option["kind"], None if option["usual"] else option["default"]  # not one that depends on others
    words = "".join(f"Literal[{word!r}], " for word in option.get("choices", ()))
    if kind == "choice":
        names = f"Literal[{', '.join(map(repr, option['choices']))}]"
        return (names, repr(usual)) if usual in option["choices"] else (f"Optional[{names}]", "None")
    if kind == "flag":
        return "bool", "True" if usual is True else "False"
    if kind == "switch":
        return "Optional[bool]", "None"
    if kind in ("whole number", "number"):
        plain = "int" if kind == "whole number" else "float"
        if is_number(usual) and not words:
            return plain, repr(int(float(usual)) if plain == "int" else float(usual))
        return f"Optional[Union[{words}{plain}]]" if words else f"Optional[{plain}]", "None"
    if kind in ("bound", "crease angle"):
        return "Optional[Union[float, str]]", "None"
    if kind == "counts":
        return "Optional[Sequence[int]]", "None"
    if kind == "values":
        return f"Optional[Union[{words}ArrayLike]]" if words else "Optional[ArrayLike]", "None"
    if kind in ("input file", "output file"):
        return "Optional[str]", "None"
    return "Any", "None"


def is_number(usual):
    try:
        float(usual)
        return not isinstance(usual, bool)
    except (TypeError, ValueError):
        return False


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
        options=pretty({name: [describe_option(one) for one in options] for name, options in tables.items()}),
        kinds=pretty({name: {one["name"]: (one["kind"], bool(one.get("choices")), one.get("of")) for one in options}
                      for name, options in tables.items()}),
        arrays=pretty({name: [one["name"] for one in made["arrays"]] for name, made in objects.items()}))


def pretty(table):
    return "{\n" + "".join(f"    {key!r}: {value!r},\n" for key, value in table.items()) + "}"


class Stub(ast.NodeTransformer):
    """Leaves the signatures of a module."""

    def __init__(self, expand):
        self.expand = expand
        self.expanded = {}

    def visit_ClassDef(self, node):
        made = [one for function in node.body if isinstance(function, ast.FunctionDef) and function.name == "__init__"
                for one in function.body if isinstance(one, ast.AnnAssign) and isinstance(one.target, ast.Attribute)]
        attributes = [ast.AnnAssign(ast.Name(one.target.attr), one.annotation, None, 1) for one in made]
        self.expanded = {function.name: marks for function in node.body if isinstance(function, ast.FunctionDef)
                         and (marks := self.marks(function))}
        overloaded = {one.name for one in node.body if isinstance(one, ast.FunctionDef) and self.is_overload(one)}
        kept = [one for one in node.body if not self.is_text(one) and (getattr(one, "name", "") not in overloaded or self.is_overload(one))]
        node.body = attributes + [self.visit(one) for one in kept] or [ast.Expr(ast.Constant(...))]
        self.expanded = {}
        return node

    def visit_FunctionDef(self, node):
        marks = self.marks(node) or self.expanded.get(node.name)
        node.decorator_list = [one for one in node.decorator_list if self.operation(one) is None]
        if marks and node.args.kwarg:
            own = [one.arg for one in (*node.args.args, *node.args.kwonlyargs)]
            node.args.kwarg = None
            for name, kind, usual, _ in self.expand(own=own, **marks):
                node.args.kwonlyargs.append(ast.arg(name, ast.parse(kind, mode="eval").body))
                node.args.kw_defaults.append(ast.parse(usual, mode="eval").body)
        node.body = [ast.Expr(ast.Constant(...))]
        return node

    def visit_AnnAssign(self, node):
        """What `view` and `figure` make is a property."""
        if getattr(getattr(node.value, "func", None), "id", "") not in ("view", "figure"):
            return node
        function = ast.parse(f"@property\ndef {node.target.id}(self): ...").body[0]
        function.returns = node.annotation
        return function

    def visit_Module(self, node):
        node.body = [self.visit(one) for one in node.body if not self.is_text(one)]
        return node

    def visit_Assign(self, node):
        is_alias = isinstance(node.value, (ast.Subscript, ast.Name))
        return node if is_alias else ast.AnnAssign(node.targets[0], ast.Name("Any"), None, 1)

    @staticmethod
    def is_overload(function):
        return any(getattr(one, "id", "") == "overload" for one in function.decorator_list)

    @staticmethod
    def is_text(node):
        return isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant)

    @staticmethod
    def operation(decorator):
        is_mark = isinstance(decorator, ast.Call) and getattr(decorator.func, "id", "") == "described"
        return decorator if is_mark else None

    def marks(self, node):
        """What a function is marked with: its operation, and the options that it is without."""
        for decorator in filter(None, map(self.operation, node.decorator_list)):
            given = {one.arg: ast.literal_eval(one.value) for one in decorator.keywords}
            return {"operation": decorator.args[0].value, "without": given.get("without", "").split(), "runs": given.get("runs", True)}
        return None


MORE = "from collections.abc import Sequence\nfrom typing import Any, Literal, Optional, Union\n\n" \
       "from numpy.typing import ArrayLike\n\nfrom ._progress import Progress\n"


def main(library, sources, output):
    output.mkdir(parents=True, exist_ok=True)
    (output / "_described.py").write_text(describe(library), encoding="utf-8")
    spec = importlib.util.spec_from_file_location("_described", output / "_described.py")
    table = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(table)

    def expand(operation, own, without, runs):
        run = (("threads", "int", "0", ""), ("progress", "Progress", "None", ""), ("time_limit", "Optional[float]", "None", ""))
        return [one for one in (*table.OPTIONS[operation], *(run if runs else ())) if one[0] not in (*own, *without)]

    for source in sources.glob("*.py"):
        text = source.read_text(encoding="utf-8")
        if "@described(" in text and source.name != "_options.py":
            tree = ast.fix_missing_locations(Stub(expand).visit(ast.parse(text)))
            future = "from __future__ import annotations\n"
            (output / f"{source.stem}.pyi").write_text(ast.unparse(tree).replace(future, future + MORE), encoding="utf-8")


if __name__ == "__main__":
    main(*map(pathlib.Path, sys.argv[1:]))
