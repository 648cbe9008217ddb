"""The build backend of pyproject.toml: setuptools, also where pip's isolated build has none and there is no network.

An isolated build sees no package but those that it asks for, and asks the network for them. So this asks for none, and
adds Debian's own after all others: a setuptools that the build has goes first.
"""
import sys

sys.path.append("/usr/lib/python3/dist-packages")

from setuptools.build_meta import *  # noqa: E402, F401, F403


def get_requires_for_build_wheel(config_settings=None):
    """setuptools asks for the package wheel, which Debian's python3-wheel is."""
    import wheel  # noqa: F401
    return []
