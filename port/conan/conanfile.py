"""Conan 2 recipe: conan create port/conan"""

import pathlib
import re

from conan import ConanFile
from conan.tools.cmake import CMake, CMakeToolchain, cmake_layout
from conan.tools.files import copy


class Roomseg(ConanFile):
    name = "roomseg"
    description = "Cuts a robot's 2D occupancy grid into rooms, in fixed memory and integers"
    license = "MIT"
    topics = ("robotics", "segmentation", "occupancy-grid")
    package_type = "static-library"
    settings = "os", "arch", "compiler", "build_type"
    languages = "C"
    generators = "CMakeDeps"

    def root(self):
        return pathlib.Path(self.recipe_folder).parent.parent

    def set_version(self):
        header = (self.root() / "include" / "roomseg" / "roomseg.h").read_text()
        self.version = ".".join(re.findall(r"#define ROOMSEG_VERSION_\w+ (\d+)", header))

    def export_sources(self):
        for pattern in ("CMakeLists.txt", "LICENSE", "cmake/*", "include/*", "src/*"):
            copy(self, pattern, self.root(), self.export_sources_folder)

    def layout(self):
        cmake_layout(self)

    def generate(self):
        toolchain = CMakeToolchain(self)
        toolchain.cache_variables["ROOMSEG_BUILD_TOOLS"] = False
        toolchain.cache_variables["ROOMSEG_BUILD_TESTS"] = False
        toolchain.generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        copy(self, "LICENSE", self.source_folder, pathlib.Path(self.package_folder) / "licenses")
        CMake(self).install()

    def package_info(self):
        self.cpp_info.libs = ["roomseg"]
        self.cpp_info.set_property("cmake_file_name", "roomseg")
        self.cpp_info.set_property("cmake_target_name", "roomseg::roomseg")
