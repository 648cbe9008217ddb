"""`pip install .` without the network, into an environment of its own. GVD_BUILD names the tree that has the package."""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

import meshes

USE = """
import gvd, pathlib, sys
assert pathlib.Path(gvd.__file__).is_relative_to(sys.prefix), gvd.__file__
assert (pathlib.Path(gvd.__file__).parent / "py.typed").exists()
mesh = gvd.read(sys.argv[1])
print(gvd.__version__, len(mesh.segment(5).diagram.cells))
"""


# In place of cmake: it configures, but copies the package of another tree instead of building it for minutes.
CMAKE = """#!/bin/sh
[ "$1" = --build ] || exec {cmake} "$@"
mkdir -p "$2/python"
echo "[1/2] Building"
exec cp -r {built}/python/gvd "$2/python"
"""


class Install(unittest.TestCase):
    def install(self, source, folder, **changes):
        """Installs into a new environment in `folder`, and uses the package there."""
        environment = {**os.environ, "http_proxy": "http://127.0.0.1:9", "https_proxy": "http://127.0.0.1:9",
                       "PIP_INDEX_URL": "http://127.0.0.1:9", "PIP_DISABLE_PIP_VERSION_CHECK": "1", "PIP_CONFIG_FILE": os.devnull, **changes}
        environment.pop("PYTHONPATH", None)
        venv = folder / "venv"
        for command in ([sys.executable, "-m", "venv", "--system-site-packages", venv],
                        [venv / "bin" / "pip", "install", "--no-cache-dir", source]):
            ran = subprocess.run(command, capture_output=True, text=True, env=environment)
            self.assertEqual(ran.returncode, 0, ran.stdout + ran.stderr)
        ran = subprocess.run([venv / "bin" / "python", "-c", USE, meshes.FIGURE], capture_output=True, text=True, cwd=folder,
                             env=environment)
        self.assertEqual(ran.returncode, 0, ran.stderr)
        version, cells = ran.stdout.split()
        self.assertIn(f"project(gvd VERSION {version} ", (meshes.ROOT / "CMakeLists.txt").read_text())
        self.assertEqual(cells, "5")
        tag, = (venv / "lib").glob("python3*/site-packages/gvd-*.dist-info/WHEEL")
        self.assertRegex(tag.read_text(), r"Tag: py3-none-linux_")  # for any Python

    def test_pip_install_without_network(self):
        with tempfile.TemporaryDirectory() as folder:
            self.install(meshes.ROOT, pathlib.Path(folder))

    def test_pip_configures_a_tree_of_its_own(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            shutil.copytree(meshes.ROOT, folder / "gvd", ignore=shutil.ignore_patterns(".git", "build*", "tests", "docs", "demo-output"))
            (folder / "cmake").write_text(CMAKE.format(cmake=shutil.which("cmake"), built=pathlib.Path(os.environ["GVD_BUILD"]).resolve()))
            (folder / "cmake").chmod(0o755)
            self.install(folder / "gvd", folder, GVD_BUILD="", PATH=f"{folder}:{os.environ['PATH']}")
            self.assertTrue((folder / "gvd/build-python/cmake/CMakeCache.txt").exists())


if __name__ == "__main__":
    unittest.main()
