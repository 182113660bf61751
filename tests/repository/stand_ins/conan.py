# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the Vändplan authors
"""Conan's modules, as a recipe sees them: they note what it asks for."""

import sys
import types
from collections import defaultdict


class Component:
    def __init__(self):
        self.libs, self.requires, self.system_libs, self.properties = [], [], [], {}

    def set_property(self, key, value):
        self.properties[key] = value


class ConanFile:
    source_folder = package_folder = "/nowhere"

    def __init__(self, **options):
        defaults = {key: value for key, value in self.default_options.items() if "/" not in key}
        assert set(defaults) == set(self.options), "an option has no default"
        self.options = types.SimpleNamespace(**{**defaults, **options})
        self.settings = types.SimpleNamespace(os="Linux")
        self.asked, self.tools, self.downloads, self.told = [], [], [], {}
        self.cpp_info = Component()
        self.cpp_info.components = defaultdict(Component)

    def requires(self, reference):
        self.asked.append(reference)

    def tool_requires(self, reference):
        self.tools.append(reference)


class Generator:
    def __init__(self, conanfile):
        self.cache_variables = conanfile.told

    def generate(self):
        pass

    def set_property(self, *_):
        pass


def load(recipe):
    """The class of a recipe, its module having been run."""

    def fetch(conanfile, address, *_, sha256, **__):
        conanfile.downloads.append((address, sha256))

    def nothing(*_):
        pass

    modules = {
        "conan": {"ConanFile": ConanFile},
        "conan.tools": {},
        "conan.tools.build": {"check_min_cppstd": nothing},
        "conan.tools.cmake": {"CMake": Generator, "CMakeDeps": Generator, "CMakeToolchain": Generator, "cmake_layout": nothing},
        "conan.tools.files": {"copy": nothing, "download": fetch, "get": fetch, "rmdir": nothing},
        "conan.tools.gnu": {"PkgConfigDeps": Generator},
    }
    for name, members in modules.items():
        sys.modules[name] = types.ModuleType(name)
        vars(sys.modules[name]).update(members)
    module = types.ModuleType("conanfile")
    exec(compile(recipe.read_text("utf-8"), str(recipe), "exec"), vars(module))
    return next(one for one in vars(module).values() if isinstance(one, type) and issubclass(one, ConanFile) and one is not ConanFile)
