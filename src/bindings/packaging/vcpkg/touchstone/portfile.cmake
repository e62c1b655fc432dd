# Builds the tree that this port lies in. vcpkg does not know when that tree changes: use --no-binarycaching.
# SPDX-License-Identifier: MIT
get_filename_component(SOURCE_PATH "${CURRENT_PORT_DIR}/../../../../.." ABSOLUTE)

vcpkg_check_features(OUT_FEATURE_OPTIONS options
  FEATURES
    cgal TOUCHSTONE_WITH_CGAL
    program TOUCHSTONE_BUILD_PROGRAM
    program TOUCHSTONE_WITH_HDF5)
vcpkg_cmake_configure(
  SOURCE_PATH "${SOURCE_PATH}"
  OPTIONS
    ${options}
    -DCMAKE_SKIP_INSTALL_ALL_DEPENDENCY=ON  # `all` has a checker more where Coq is installed
    -DTOUCHSTONE_BUILD_ENGINES=OFF
    -DTOUCHSTONE_BUILD_PYTHON=OFF
    -DTOUCHSTONE_BUILD_TESTS=OFF
  OPTIONS_DEBUG
    -DTOUCHSTONE_BUILD_PROGRAM=OFF)
vcpkg_cmake_build(TARGET touchstone_installed)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(PACKAGE_NAME touchstone CONFIG_PATH lib/cmake/touchstone)
vcpkg_fixup_pkgconfig()
if("program" IN_LIST FEATURES)
  vcpkg_copy_tools(TOOL_NAMES touchstone touchstone-check AUTO_CLEAN)
endif()

file(REMOVE_RECURSE
  "${CURRENT_PACKAGES_DIR}/debug/include"
  "${CURRENT_PACKAGES_DIR}/debug/share"
  "${CURRENT_PACKAGES_DIR}/share/doc")
file(INSTALL "${CMAKE_CURRENT_LIST_DIR}/usage" DESTINATION "${CURRENT_PACKAGES_DIR}/share/${PORT}")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE")
