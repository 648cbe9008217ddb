"""`import gvd` under an interpreter that can't use it says in one line why, and which one can."""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

import gvd

PACKAGE = pathlib.Path(gvd.__file__).parent
VERSION = f"{sys.version_info.major}.{sys.version_info.minor}"


def last_line_of_import(folder, *options):
    """What `import gvd` ends with in an interpreter that finds it in `folder`."""
    ran = subprocess.run([sys.executable, *options, "-c", "import gvd"], capture_output=True, text=True,
                         env={**os.environ, "PYTHONPATH": str(folder)})
    assert ran.returncode == 1, ran.stderr
    return ran.stderr.splitlines()[-1]


class Interpreter(unittest.TestCase):
    def copy_with_module(self, name):
        """A folder with a copy of the package, whose module has another name, or is missing."""
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        copy = pathlib.Path(folder.name) / "gvd"
        shutil.copytree(PACKAGE, copy)
        for module in copy.glob("_gvd.*.so"):
            module.rename(copy / name) if name else module.unlink()
        return copy.parent

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
                             f"ImportError: gvd was built for Python {VERSION} and needs NumPy, which {python} does not have: run "
                             f"`{python} -m pip install numpy`, or use /usr/bin/python{VERSION}")

    def test_a_module_for_another_version_names_that_version(self):
        folder = self.copy_with_module("_gvd.cpython-38-x86_64-linux-gnu.so")
        self.assertEqual(last_line_of_import(folder).replace("/usr/bin/", ""),
                         f"ImportError: gvd was built for Python 3.8, and {sys.executable} is Python {VERSION}: use python3.8, or install "
                         "gvd for this one with its own `pip install .`".replace("/usr/bin/", ""))

    def test_without_a_module_it_says_how_to_build_one(self):
        folder = self.copy_with_module("")
        self.assertEqual(last_line_of_import(folder),
                         f"ImportError: {folder / 'gvd'} has no module _gvd for {sys.executable}: build the package with `make python`, "
                         "and set PYTHONPATH to the folder python of the build tree")


if __name__ == "__main__":
    unittest.main()
