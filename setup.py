# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the Vändplan authors
"""Builds and installs the Python package: pip install . (docs/python.md)."""

import pathlib
import re

from skbuild import setup

root = pathlib.Path(__file__).parent
version = re.search(r"VERSION ([0-9.]+)", (root / "CMakeLists.txt").read_text("utf-8").split("project(")[1])

setup(
    name="vandplan",
    version=version.group(1),
    description="Plans paths for trucks and buses",
    license="BSD-3-Clause",
    packages=["vandplan"],
    package_dir={"": "bindings/python"},
    package_data={"vandplan": ["py.typed", "*.pyi"]},
    python_requires=">=3.9",
    install_requires=["numpy"],
    extras_require={"plot": ["matplotlib"], "frames": ["pandas"]},
    cmake_args=[
        "-DVANDPLAN_PYTHON=ON",
        "-DVANDPLAN_EVALUATION=ON",
        "-DVANDPLAN_IO=ON",
        "-DVANDPLAN_DRAW=ON",
        "-DVANDPLAN_APP=OFF",
        "-DVANDPLAN_TESTS=OFF",
        "-DVANDPLAN_INSTALL=OFF",
        "-DVANDPLAN_UNITY=ON",  # half the work in a build from nothing
    ],
    cmake_install_target="install",
)
