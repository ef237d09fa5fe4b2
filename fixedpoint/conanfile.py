# SPDX-License-Identifier: MIT
# The Conan recipe: conan create fixedpoint. What the package is stands in library.json.
import json
import pathlib

from conan import ConanFile
from conan.tools.cmake import CMake, CMakeDeps, CMakeToolchain

MANIFEST = json.loads((pathlib.Path(__file__).parent / "library.json").read_text())


class Recipe(ConanFile):
    name = MANIFEST["name"]
    version = MANIFEST["version"]
    license = MANIFEST["license"]
    description = MANIFEST["description"]
    homepage = url = MANIFEST["homepage"]
    topics = tuple(MANIFEST["keywords"])
    package_type = "header-library"
    settings = "os", "arch", "compiler", "build_type"
    exports = "library.json"
    exports_sources = "CMakeLists.txt", "src/*", "LICENSE", "library.json"
    no_copy_source = True

    def generate(self):
        CMakeToolchain(self).generate()
        CMakeDeps(self).generate()

    def package(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.install()

    def package_id(self):
        self.info.clear()

    def package_info(self):
        self.cpp_info.bindirs = self.cpp_info.libdirs = []
        self.cpp_info.set_property("cmake_file_name", "fixedpoint")
        self.cpp_info.set_property("cmake_target_name", "fixedpoint::fixedpoint")
