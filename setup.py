"""Builds the module _gvd with CMake, for pip. pyproject.toml says the rest.

    GVD_BUILD  a CMake tree with GVD_BUILD_PYTHON=ON to take the module from; without one, build-python/cmake is configured
"""
import os
import pathlib
import re
import subprocess
import sys

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = pathlib.Path(__file__).resolve().parent
OWN = ROOT / "build-python"  # setuptools' own default, build/, is that of make
FLAGS = ["-DGVD_BUILD_PYTHON=ON", "-DGVD_BUILD_APPS=OFF", "-DGVD_BUILD_TESTS=OFF", "-DGVD_WITH_CGAL_GPL=OFF"]


class BuildWithCMake(build_ext):
    """Builds the target gvd_python, and puts the module where setuptools expects it."""

    def build_extension(self, ext):
        given = os.environ.get("GVD_BUILD")
        tree = pathlib.Path(given or OWN / "cmake")
        if given:
            self.build_tree(tree)
        else:
            self.build_own_tree(tree)
        target = pathlib.Path(self.get_ext_fullpath(ext.name))
        target.parent.mkdir(parents=True, exist_ok=True)
        self.copy_file(str(tree / "python" / "gvd" / target.name), str(target))

    def build_own_tree(self, tree):
        """Without the page if that can't be built: its packages come from the network, and nothing else does."""
        try:
            self.build_tree(tree, "-DGVD_WITH_VIEWER=ON")
        except subprocess.CalledProcessError:
            print("gvd: trying again without the page (.html), which needs npm and the network", file=sys.stderr, flush=True)
            self.build_tree(tree, "-DGVD_WITH_VIEWER=OFF")

    def build_tree(self, tree, *flags):
        environment = {**os.environ, "npm_config_fetch_retries": "0"}
        environment.pop("PYTHONPATH", None)  # an isolated build hides NumPy by it, which CMake looks for
        if flags:
            subprocess.run([ROOT / "scripts" / "configure.sh", "release", tree, *FLAGS, *flags,
                            f"-DGVD_PYTHON={sys.executable}"], cwd=ROOT, check=True, env=environment)
        jobs = str(os.cpu_count() or 1)
        subprocess.run(["cmake", "--build", tree, "--target", "gvd_python", "-j", jobs], check=True, env=environment)


def find_version():
    return re.search(r"project\(gvd VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text()).group(1)


OWN.mkdir(exist_ok=True)
setup(version=find_version(), ext_modules=[Extension("gvd._gvd", [])], cmdclass={"build_ext": BuildWithCMake},
      options={"build": {"build_base": str(OWN)}, "egg_info": {"egg_base": str(OWN)}})
