"""Builds the package gvd with CMake, for pip. pyproject.toml says the rest.

    GVD_BUILD  a CMake tree with GVD_BUILD_PYTHON=ON to take the package from; without one, build-python/cmake is configured
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys

from setuptools import Distribution, setup
from setuptools.command.build_py import build_py
from wheel.bdist_wheel import bdist_wheel

ROOT = pathlib.Path(__file__).resolve().parent
OWN = ROOT / "build-python"  # setuptools' own default, build/, is that of make
FLAGS = ["-DGVD_BUILD_PYTHON=ON", "-DGVD_BUILD_APPS=OFF", "-DGVD_BUILD_TESTS=OFF", "-DGVD_WITH_CGAL_GPL=OFF"]


class BuildWithCMake(build_py):
    """Builds the target gvd_python, and takes all files of the package from there."""

    def run(self):
        given = os.environ.get("GVD_BUILD")
        tree = pathlib.Path(given or OWN / "cmake")
        if given:
            self.build_tree(tree)
        else:
            self.build_own_tree(tree)
        shutil.copytree(tree / "python" / "gvd", pathlib.Path(self.build_lib) / "gvd", dirs_exist_ok=True,
                        ignore=shutil.ignore_patterns("__pycache__"))

    def build_own_tree(self, tree):
        """Without the page if that can't be built: its packages come from the network, and nothing else does."""
        try:
            self.build_tree(tree, "-DGVD_WITH_VIEWER=ON")
        except subprocess.CalledProcessError:
            tell("gvd: trying again without the page (.html), which needs npm and the network\n")
            self.build_tree(tree, "-DGVD_WITH_VIEWER=OFF")

    def build_tree(self, tree, *flags):
        environment = {**os.environ, "npm_config_fetch_retries": "0"}
        environment.pop("PYTHONPATH", None)
        if flags:
            subprocess.run([ROOT / "scripts" / "configure.sh", "release", tree, *FLAGS, *flags,
                            f"-DGVD_PYTHON={sys.executable}"], cwd=ROOT, check=True, env=environment)
        command = ["cmake", "--build", tree, "--target", "gvd_python", "-j", str(os.cpu_count() or 1)]
        with subprocess.Popen(command, env=environment, stdout=subprocess.PIPE, text=True) as build:
            for line in build.stdout:
                print(line, end="", flush=True)
                step = re.match(r"\[ *(\d+/\d+|\d+%)\]", line)
                if step:
                    tell(f"\rgvd: compiling {step[1]} ")
        tell("\r\x1b[K")
        if build.returncode:
            raise subprocess.CalledProcessError(build.returncode, command)


def tell(text):
    """Writes to the terminal: pip shows nothing of a build, which takes minutes."""
    try:
        with open("/dev/tty", "w", encoding="utf-8") as terminal:
            terminal.write(text)
    except OSError:
        if not text.startswith("\r"):
            print(text, file=sys.stderr, end="", flush=True)


class WithLibrary(Distribution):
    def has_ext_modules(self):
        return True  # a library of this machine's kind, which any Python can load


class Wheel(bdist_wheel):
    def get_tag(self):
        return ("py3", "none", super().get_tag()[2])


def find_version():
    return re.search(r"project\(gvd VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text()).group(1)


OWN.mkdir(exist_ok=True)
setup(version=find_version(), distclass=WithLibrary, cmdclass={"build_py": BuildWithCMake, "bdist_wheel": Wheel},
      options={"build": {"build_base": str(OWN)}, "egg_info": {"egg_base": str(OWN)}})
