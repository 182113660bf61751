# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the Vändplan authors
"""Builds the wheel with scikit-build, which Debian 12 has. Everything else is in pyproject.toml."""

import pathlib
import re

from skbuild import setup

project = (pathlib.Path(__file__).parent / "CMakeLists.txt").read_text("utf-8")

setup(
    version=re.search(r"project\(vandplan VERSION ([0-9.]+)", project).group(1),
    packages=["vandplan"],
    package_dir={"": "bindings/python"},
    package_data={"vandplan": ["py.typed"]},
    cmake_languages=("CXX",),
    cmake_install_dir="bindings/python",
    cmake_install_target="install/strip",
)
