# Untested: Conan was not at hand. Another module played its part (tests/repository/recipes_test).
# conan create . --build=missing    (Conan 2)
import os

from conan import ConanFile
from conan.tools.build import check_min_cppstd
from conan.tools.cmake import CMake, CMakeDeps, CMakeToolchain, cmake_layout
from conan.tools.files import copy, download, get, rmdir
from conan.tools.gnu import PkgConfigDeps


class Vandplan(ConanFile):
    name = "vandplan"
    version = "@VERSION@"
    description = "Plans paths for trucks and buses"
    license = "BSD-3-Clause"
    package_type = "static-library"
    settings = "os", "arch", "compiler", "build_type"
    options = {
        "simd": [True, False],
        "threads": [True, False],
        "tables": [True, False],
        "io": [True, False],
        "geography": [True, False],
        "draw": [True, False],
        "evaluation": [True, False],
        "app": [True, False],
        "ompl": [True, False],
    }
    default_options = {
        "simd": True,
        "threads": True,
        "tables": True,
        "io": True,
        "geography": True,
        "draw": True,
        "evaluation": False,
        "app": False,
        "ompl": False,
        "ompl/*:shared": True,
    }

    def configure(self):
        if self.options.app:
            self.options.evaluation = True
        if self.options.evaluation:
            self.options.io = True
            self.options.draw = True

    def layout(self):
        cmake_layout(self)

    def validate(self):
        check_min_cppstd(self, 20)

    def requirements(self):
        if self.options.simd:
            self.requires("highway/[>=1.0.7 <2]")
        if self.options.io:
            self.requires("fmt/[>=9.1 <13]")
            self.requires("libpng/[>=1.6 <2]")
            self.requires("nlohmann_json/[>=3.11 <4]")
            self.requires("pugixml/[>=1.13 <2]")
            self.requires("yaml-cpp/[>=0.7 <1]")
            self.requires("zlib/[>=1.2.11 <2]")
            if self.options.geography:
                self.requires("geographiclib/[>=2.3 <3]")
        if self.options.draw:
            self.requires("cairo/[>=1.16 <2]")
        if self.options.evaluation:
            self.requires("sqlite3/[>=3.40 <4]")
        if self.options.app:
            self.requires("cli11/[>=2.3 <3]")
        if self.options.ompl:
            self.requires("ompl/[>=1.7 <2]")

    def build_requirements(self):
        self.tool_requires("cmake/[>=3.25 <5]")
        if self.options.draw:
            self.tool_requires("pkgconf/[>=2.0 <3]")

    def source(self):
        get(self, "@ADDRESS@", sha256="@SHA256@", strip_root=True)
        download(self, "@D3_ADDRESS@", "d3.min.js", sha256="@D3_SHA256@")

    def generate(self):
        dependencies = CMakeDeps(self)
        dependencies.set_property("highway", "cmake_file_name", "hwy")
        dependencies.set_property("highway::hwy", "cmake_target_name", "hwy::hwy")
        dependencies.generate()
        PkgConfigDeps(self).generate()
        toolchain = CMakeToolchain(self)
        toolchain.cache_variables["VANDPLAN_TESTS"] = False
        toolchain.cache_variables["VANDPLAN_D3"] = os.path.join(self.source_folder, "d3.min.js")
        for option in ("simd", "threads", "tables", "io", "geography", "draw", "evaluation", "app", "ompl"):
            toolchain.cache_variables["VANDPLAN_" + option.upper()] = bool(getattr(self.options, option))
        toolchain.generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        CMake(self).install()
        copy(self, "LICENSE", self.source_folder, os.path.join(self.package_folder, "licenses"))
        rmdir(self, os.path.join(self.package_folder, "lib", "cmake"))
        rmdir(self, os.path.join(self.package_folder, "lib", "pkgconfig"))

    def package_info(self):
        self.cpp_info.set_property("cmake_file_name", "vandplan")
        core = self.cpp_info.components["vandplan"]
        core.libs = ["vandplan"]
        if self.options.simd:
            core.requires.append("highway::hwy")
        if self.options.threads and self.settings.os == "Linux":
            core.system_libs.append("pthread")
        needs = {
            "io": ["fmt::fmt", "libpng::libpng", "nlohmann_json::nlohmann_json", "pugixml::pugixml", "yaml-cpp::yaml-cpp", "zlib::zlib"],
            "draw": ["cairo::cairo"],
            "evaluation": ["io", "draw", "sqlite3::sqlite3"],
            "ompl": ["ompl::ompl"],
        }
        if self.options.geography:
            needs["io"].append("geographiclib::geographiclib")
        if self.options.app:
            needs["evaluation"].append("cli11::cli11")
        for part, libraries in needs.items():
            if getattr(self.options, part):
                component = self.cpp_info.components[part]
                component.set_property("cmake_target_name", "vandplan::" + part)
                component.libs = ["vandplan_" + part]
                component.requires = ["vandplan", *libraries]
