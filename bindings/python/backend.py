# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the Vändplan authors
"""Backend by which pip and build make packages (PEP 517), which pyproject.toml names.

It is scikit-build-core, or the older scikit-build where that alone is there, as on Debian 12. Before
anything is compiled, one line says which programs and libraries are missing.
"""

import importlib.util
import os
import pathlib
import shlex
import shutil
import subprocess
import sys
import sysconfig
import tempfile

HERE = pathlib.Path(__file__).resolve().parent


def _is_there(module):
    return importlib.util.find_spec(module) is not None


def _chosen():
    if _is_there("scikit_build_core"):
        import scikit_build_core.build as chosen
    elif _is_there("skbuild"):
        import setuptools.build_meta as chosen
    else:
        sys.exit("vandplan cannot be built, this is missing: scikit-build-core (or Debian's python3-skbuild)")
    return chosen


def _missing():
    """Debian's names of programs and libraries that a build lacks; cmake looks for them."""
    if not shutil.which("cmake"):
        return ["cmake"]
    missing = []
    if not (pathlib.Path(sysconfig.get_path("include")) / "Python.h").exists():
        missing.append("python3-dev")
    with tempfile.TemporaryDirectory() as folder:
        command = ["cmake", "-S", str(HERE / "needs"), "-B", folder, *shlex.split(os.environ.get("CMAKE_ARGS", ""))]
        said = subprocess.run(command, capture_output=True, text=True)
        if said.returncode != 0:
            return []  # cmake says better what it dislikes when it builds
        names = pathlib.Path(folder, "missing").read_text("utf-8").split()
    if _is_there("pybind11"):
        names = [name for name in names if name != "pybind11-dev"]
    return missing + names


def get_requires_for_build_sdist(config_settings=None):
    return [] if _is_there("scikit_build_core") or _is_there("skbuild") else ["scikit-build-core>=0.10"]


def get_requires_for_build_wheel(config_settings=None):
    needed = get_requires_for_build_sdist()
    if needed:
        needed += ["pybind11>=2.10", *(tool for tool in ("cmake>=3.25", "ninja") if not shutil.which(tool.split(">")[0]))]
    return needed


def build_sdist(sdist_directory, config_settings=None):
    return _chosen().build_sdist(sdist_directory, config_settings)


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    missing = _missing()
    if missing:
        sys.exit(f"vandplan cannot be built, these packages of Debian are missing: {' '.join(missing)}")
    return _chosen().build_wheel(wheel_directory, config_settings, metadata_directory)
