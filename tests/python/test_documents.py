"""Docstrings run, and annotations hold: mypy for the package, stubtest for the stub of its module."""
import doctest
import importlib
import inspect
import os
import pathlib
import pkgutil
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import warnings

import gvd
import meshes

PACKAGE = pathlib.Path(gvd.__file__).parent

# What users write, and what mypy says of it.
PROGRAM = """
import gvd
mesh = gvd.read("a.ply")
count: int = mesh.segment(3, labels="nearest", seed=4).labels.shape[0]
length: float = mesh.path(0, 1).length
mesh.remesh(300, refine=False, error="1%").mesh.to_file("b.ply", ascii_ply=True)
mesh.segment(3, lables="nearest")
mesh.segment(3, labels="rough")
"""
FINDINGS = ['Unexpected keyword argument "lables" for "segment" of "Mesh"; did you mean "labels"?',
            'Argument "labels" to "segment" of "Mesh" has incompatible type "Literal[\'rough\']"']

# What needs files, threads or Python's libraries (docs/guide/javascript.md), and what the npm package has in another form.
NOT_IN_JAVASCRIPT = {"to_file", "to_html", "to_vtk", "bisectors_to_vtk", "points_to_file", "show", "colors"}
OTHERWISE_IN_JAVASCRIPT = {"areas", "area", "bounds", "figures", "summary", "position", "generator_array", "offsets", "neighbour_array",
                           "euler_characteristic", "components", "boundary_loops", "torn_share", "flipped_share", "surface", "diagram",
                           "vertex_of_input", "isolines", "generators", "Cells", "Point", "Points", "Isoline"}


class Documents(unittest.TestCase):
    def test_examples_of_docstrings(self):
        tried = 0
        for module in [gvd, *(importlib.import_module(f"gvd.{m.name}") for m in pkgutil.iter_modules(gvd.__path__))]:
            result = doctest.testmod(module)
            self.assertEqual(result.failed, 0, module.__name__)
            tried += result.attempted
        self.assertGreater(tried, 20)

    def test_examples_of_the_pages(self):
        """The ```python blocks of a page run in their order, in a folder that has data/ beside it."""
        for page in ("README.md", "docs/guide/python.md"):
            names = {}
            blocks = re.findall(r"^```python\n(.*?)^```", (meshes.ROOT / page).read_text(), re.MULTILINE | re.DOTALL)
            self.assertGreater(len(blocks), 0, page)
            with tempfile.TemporaryDirectory() as folder:
                os.symlink(meshes.ROOT / "data", pathlib.Path(folder) / "data")
                os.chdir(folder)
                try:
                    with warnings.catch_warnings():
                        warnings.simplefilter("error", UserWarning)
                        for block in blocks:
                            exec(compile(block, page, "exec"), names)
                finally:
                    os.chdir(meshes.ROOT)

    def test_everything_public_has_a_docstring(self):
        for name in gvd.__all__:
            thing = getattr(gvd, name)
            if name.startswith("_"):
                continue
            self.assertTrue(thing.__doc__, name)
            for member, value in vars(thing).items() if isinstance(thing, type) else ():
                if not member.startswith("_") and (callable(value) or isinstance(value, property)):
                    self.assertTrue(value.__doc__, f"{name}.{member}")

    def test_javascript_has_the_same_names(self):
        types = (meshes.ROOT / "web/npm/index.d.ts").read_text()
        for name in gvd.__all__:
            thing = getattr(gvd, name)
            if not isinstance(thing, type) or name in OTHERWISE_IN_JAVASCRIPT:
                continue
            body = re.search(rf"^export (?:class|interface) {name} [^{{]*{{\n(.*?)^}}", types, re.MULTILINE | re.DOTALL)
            self.assertIsNotNone(body, name)
            members = set(re.findall(r"^  (?:readonly )?(\w+)[(:?]", body[1], re.MULTILINE)) | NOT_IN_JAVASCRIPT | OTHERWISE_IN_JAVASCRIPT
            self.assertLessEqual({key for key in vars(thing) if not key.startswith("_")}, members, name)

    def run_mypy(self, folder, *arguments):
        ran = subprocess.run([sys.executable, "-m", *arguments], cwd=folder, capture_output=True, text=True,
                             env={**os.environ, "MYPYPATH": str(folder)})
        return ran.returncode, ran.stdout + ran.stderr

    def test_annotations(self):
        """Of the sources, and of the package with its stubs."""
        with tempfile.TemporaryDirectory() as name:
            shutil.copytree(PACKAGE, pathlib.Path(name) / "gvd", ignore=shutil.ignore_patterns("*.pyi", "*.so.*"))
            for folder in (name, PACKAGE.parent):
                status, told = self.run_mypy(folder, "mypy", "--strict", "--cache-dir", os.devnull, "gvd")
                self.assertEqual(status, 0, told)

    def test_the_stubs_are_those_of_the_modules(self):
        stubs = [f"gvd.{stub.stem}" for stub in PACKAGE.glob("*.pyi")]
        self.assertEqual(set(stubs), {"gvd._mesh", "gvd._object", "gvd._results", "gvd._editor"})
        status, told = self.run_mypy(PACKAGE.parent, "mypy.stubtest", *stubs)
        self.assertEqual(status, 0, told)

    def test_mypy_knows_the_options_of_the_description(self):
        with tempfile.TemporaryDirectory() as folder:
            program = pathlib.Path(folder) / "program.py"
            program.write_text(PROGRAM)
            _, told = self.run_mypy(PACKAGE.parent, "mypy", "--strict", "--cache-dir", os.devnull, str(program))
        lines = [line for line in told.splitlines() if ": error:" in line]
        self.assertEqual(len(lines), len(FINDINGS), told)
        for line, finding in zip(lines, FINDINGS):
            self.assertIn(finding, line)

    def test_help_shows_the_options_of_the_description(self):
        signature, told = inspect.signature(gvd.Mesh.remesh), inspect.getdoc(gvd.Mesh.remesh)
        self.assertEqual(signature.parameters["sampling"].default, "farthest")
        self.assertIn("Literal['generator', 'quadric', 'fit']", str(signature.parameters["place"].annotation))
        self.assertIn("exact_count: Exactly as many vertices as asked for, or no mesh", told)
        self.assertNotIn("{option", told)


if __name__ == "__main__":
    os.chdir(meshes.ROOT)
    unittest.main()
