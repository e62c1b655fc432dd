"""Builds the tree that this file lies in: conan create src/bindings/packaging/conan --build=missing"""
# SPDX-License-Identifier: MIT
import os

from conan import ConanFile
from conan.errors import ConanInvalidConfiguration
from conan.tools.cmake import CMake, CMakeDeps, CMakeToolchain, cmake_layout
from conan.tools.files import copy, rmdir


class TouchstoneConan(ConanFile):
    name = "touchstone"
    version = "0.2.0"
    description = "Exact continuous collision detection"
    license = "MIT"
    topics = ("collision-detection", "exact-arithmetic", "geometry")
    package_type = "library"
    settings = "os", "compiler", "build_type", "arch"
    options = {"shared": [True, False], "cgal": [True, False], "program": [True, False]}
    default_options = {"shared": False, "cgal": True, "program": False}

    def export_sources(self):
        root = os.path.join(self.recipe_folder, "..", "..", "..", "..")
        for pattern in ("CMakeLists.txt", "LICENSE", "include/*", "src/*"):
            copy(self, pattern, root, self.export_sources_folder)

    def layout(self):
        cmake_layout(self)

    def validate(self):
        if self.settings.os == "Windows":
            raise ConanInvalidConfiguration("Touchstone needs the options of GCC or clang")

    def requirements(self):
        # The versions of cgal's own recipe.
        self.requires("eigen/3.4.0", transitive_headers=True)  # touchstone/eigen.hpp and the drop-ins
        self.requires("gmp/6.3.0")
        if self.options.cgal:
            self.requires("cgal/[>=5.5 <7]", visible=False)
            self.requires("mpfr/4.2.1")
        self.requires("onetbb/[>=2021]")
        if self.options.program:
            self.requires("cli11/[>=2.1 <3]")
            self.requires("expat/[>=2.5 <3]")
            self.requires("fmt/[>=7]")
            self.requires("hdf5/[>=1.10 <2]")
            self.requires("nlohmann_json/[>=3.9 <4]")
            self.requires("zlib/[>=1.2.11 <2]")

    def generate(self):
        CMakeDeps(self).generate()
        toolchain = CMakeToolchain(self)
        toolchain.cache_variables.update({
            "TOUCHSTONE_WITH_CGAL": bool(self.options.cgal),
            "TOUCHSTONE_WITH_HDF5": bool(self.options.program),
            "TOUCHSTONE_BUILD_PROGRAM": bool(self.options.program),
            "TOUCHSTONE_BUILD_ENGINES": False,
            "TOUCHSTONE_BUILD_PYTHON": False,
            "TOUCHSTONE_BUILD_TESTS": False,
        })
        toolchain.generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build(target="touchstone_installed")

    def package(self):
        CMake(self).install()
        copy(self, "LICENSE", self.source_folder, os.path.join(self.package_folder, "licenses"))
        for folder in ("lib/cmake", "lib/pkgconfig", "share/doc"):  # Conan writes its own from package_info
            rmdir(self, os.path.join(self.package_folder, folder))

    def package_info(self):
        numbers = ["gmp::gmp"] + (["mpfr::mpfr"] if self.options.cgal else [])
        core = self.cpp_info.components["touchstone"]
        core.libs = ["touchstone"]
        core.requires = numbers + ["onetbb::libtbb"]
        core.system_libs = ["m", "pthread"]
        core.set_property("cmake_target_name", "touchstone::touchstone")
        core.set_property("pkg_config_name", "touchstone")
        fuzz = self.cpp_info.components["fuzz"]
        fuzz.libs = ["touchstone_fuzz"]
        fuzz.requires = ["touchstone"]
        fuzz.system_libs = ["dl"]
        fuzz.set_property("cmake_target_name", "touchstone::fuzz")
        fuzz.set_property("pkg_config_name", "touchstone-fuzz")
        drop_in = self.cpp_info.components["tight_inclusion"]
        drop_in.libs = ["touchstone_tight_inclusion"]
        drop_in.includedirs = ["include/touchstone-tight-inclusion"]
        drop_in.requires = ["touchstone", "eigen::eigen"]
        drop_in.set_property("cmake_target_name", "tight_inclusion::tight_inclusion")
