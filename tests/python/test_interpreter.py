"""`import gvd` under an interpreter that can't use it says in one line why; any other one from 3.9 on can use the same library."""
import ast
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

import gvd
import meshes
from gvd._described import SONAME

PACKAGE = pathlib.Path(gvd.__file__).parent
VERSION = f"{sys.version_info.major}.{sys.version_info.minor}"


def last_line_of_import(folder, *options):
    """What `import gvd` ends with in an interpreter that finds it in `folder`."""
    ran = subprocess.run([sys.executable, *options, "-c", "import gvd"], capture_output=True, text=True,
                         env={**os.environ, "PYTHONPATH": str(folder)})
    assert ran.returncode == 1, ran.stderr
    return ran.stderr.splitlines()[-1]


class Interpreter(unittest.TestCase):
    def copy(self):
        """A copy of the package."""
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        return pathlib.Path(shutil.copytree(PACKAGE, pathlib.Path(folder.name) / "gvd"))

    def test_without_numpy_it_says_how_to_get_it(self):
        # -S leaves out the folders of installed packages, NumPy with them.
        self.assertEqual(last_line_of_import(PACKAGE.parent, "-S"),
                         f"ImportError: gvd needs NumPy, which {sys.executable} does not have: run `apt-get install python3-numpy`")

    def test_an_environment_without_numpy_hears_of_the_system_s_python(self):
        with tempfile.TemporaryDirectory() as name:
            subprocess.run([sys.executable, "-m", "venv", "--without-pip", name], check=True)
            python = pathlib.Path(name) / "bin/python3"
            ran = subprocess.run([python, "-c", "import gvd"], capture_output=True, text=True,
                                 env={**os.environ, "PYTHONPATH": str(PACKAGE.parent)})
            self.assertEqual(ran.stderr.splitlines()[-1],
                             f"ImportError: gvd needs NumPy, which {python} (Python {VERSION}) does not have: run "
                             f"`{python} -m pip install numpy`, or use /usr/bin/python3")

    def test_without_the_library_it_says_how_to_build_it(self):
        folder = self.copy()
        (folder / SONAME).unlink()
        self.assertRegex(last_line_of_import(folder.parent), r"^ImportError: gvd needs the library libgvd_c.so.0.\d+: .*; build it with "
                         "`make python`, and set PYTHONPATH to the folder python of the build tree$")

    def test_the_library_of_another_version_is_refused(self):
        folder = self.copy()
        described = folder / "_described.py"
        described.write_text(described.read_text().replace(f"VERSION = {gvd.__version__!r}", "VERSION = '9.8.7'"))
        self.assertEqual(last_line_of_import(folder.parent), f"ImportError: gvd 9.8.7 needs its own library, and {folder}/{SONAME} is "
                         f"that of {gvd.__version__}: install both together")

    def test_sources_alone_say_how_to_build_the_package(self):
        self.assertEqual(last_line_of_import(meshes.ROOT / "python"),
                         f"ImportError: {meshes.ROOT / 'python/gvd'} is not built: build the package with `make python`, and set PYTHONPATH "
                         "to the folder python of the build tree")

    def test_sources_are_those_of_python_3_9(self):
        for source in PACKAGE.glob("*.py"):
            ast.parse(source.read_text(), feature_version=(3, 9))

    def test_the_library_has_no_symbol_of_python(self):
        told = subprocess.run(["nm", "-D", PACKAGE / SONAME], capture_output=True, text=True, check=True).stdout
        self.assertIn(" gvd_call", told)
        self.assertNotRegex(told, r" _?Py")


if __name__ == "__main__":
    unittest.main()
