"""`pip install .` without the network, into an environment of its own. GVD_BUILD names the tree that has the module."""
import os
import pathlib
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


class Install(unittest.TestCase):
    def test_pip_install_without_network(self):
        with tempfile.TemporaryDirectory() as folder:
            environment = {**os.environ, "http_proxy": "http://127.0.0.1:9", "https_proxy": "http://127.0.0.1:9",
                           "PIP_INDEX_URL": "http://127.0.0.1:9", "PIP_DISABLE_PIP_VERSION_CHECK": "1", "PIP_CONFIG_FILE": os.devnull}
            environment.pop("PYTHONPATH", None)
            venv = pathlib.Path(folder) / "venv"
            for command in ([sys.executable, "-m", "venv", "--system-site-packages", venv],
                            [venv / "bin" / "pip", "install", "--no-cache-dir", meshes.ROOT]):
                ran = subprocess.run(command, capture_output=True, text=True, env=environment)
                self.assertEqual(ran.returncode, 0, ran.stdout + ran.stderr)
            ran = subprocess.run([venv / "bin" / "python", "-c", USE, meshes.FIGURE], capture_output=True, text=True, cwd=folder,
                                 env=environment)
            self.assertEqual(ran.returncode, 0, ran.stderr)
            version, cells = ran.stdout.split()
            self.assertIn(f"project(gvd VERSION {version} ", (meshes.ROOT / "CMakeLists.txt").read_text())
            self.assertEqual(cells, "5")


if __name__ == "__main__":
    unittest.main()
