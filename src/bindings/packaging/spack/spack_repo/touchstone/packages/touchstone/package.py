"""Has no address to fetch from: spack develop names the tree to build. docs/packaging.md shows how."""
# SPDX-License-Identifier: MIT
from spack_repo.builtin.build_systems.cmake import CMakePackage

from spack.package import *


class Touchstone(CMakePackage):
    """Exact continuous collision detection: a library for C++ and C, and a program."""

    license("MIT")

    version("0.2.0")

    variant("shared", default=True, description="Build shared libraries")
    variant("cgal", default=True, description="The second opinion, Method::oracle and Method::fast_cgal")
    variant("program", default=True, description="The programs touchstone and touchstone-check")

    depends_on("cxx", type="build")
    depends_on("cmake@3.18:", type="build")
    depends_on("eigen@3.3:")
    depends_on("gmp")
    depends_on("tbb")
    with when("+cgal"):
        depends_on("cgal@5:", type="build")
        depends_on("mpfr")
    with when("+program"):
        depends_on("cli11@2.1:", type="build")
        depends_on("expat")
        depends_on("fmt@7:")
        depends_on("hdf5~mpi")  # its header would need that of MPI
        depends_on("nlohmann-json@3.9:", type="build")
        depends_on("zlib-api")

    conflicts("platform=windows")

    build_targets = ["touchstone_installed"]

    def cmake_args(self):
        return [
            self.define_from_variant("BUILD_SHARED_LIBS", "shared"),
            self.define_from_variant("TOUCHSTONE_WITH_CGAL", "cgal"),
            self.define_from_variant("TOUCHSTONE_WITH_HDF5", "program"),
            self.define_from_variant("TOUCHSTONE_BUILD_PROGRAM", "program"),
            self.define("CMAKE_SKIP_INSTALL_ALL_DEPENDENCY", True),
            self.define("TOUCHSTONE_BUILD_ENGINES", False),
            self.define("TOUCHSTONE_BUILD_PYTHON", False),
            self.define("TOUCHSTONE_BUILD_TESTS", False),
        ]
