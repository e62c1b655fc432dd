# What `cmake --install` puts where: libraries, program, public headers, licence and the package config. The components
# are `program`, `development` and, from src/bindings/python, `python`: cpack makes a Debian package of each.
# SPDX-License-Identifier: MIT
include(CMakePackageConfigHelpers)

set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME development)

set(touchstone_package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/touchstone)

set(touchstone_libraries touchstone)
if(TARGET touchstone_fuzz_library)
  list(APPEND touchstone_libraries touchstone_fuzz_library)
endif()
install(TARGETS ${touchstone_libraries} EXPORT touchstone-targets
  RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR}
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
if(TARGET touchstone_tight_inclusion)
  # An export of its own: the target keeps the name that Tight-Inclusion's users know, and it needs Eigen.
  install(TARGETS touchstone_tight_inclusion EXPORT touchstone-tight-inclusion-targets
    RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR}
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/src/bindings/dropin/tight_inclusion/include/
    DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/touchstone-tight-inclusion FILES_MATCHING PATTERN "*.hpp")
  install(EXPORT touchstone-tight-inclusion-targets NAMESPACE tight_inclusion:: DESTINATION ${touchstone_package_dir})
  list(APPEND touchstone_libraries touchstone_tight_inclusion)
endif()
# Building this target builds everything that `cmake --install` copies, and no test.
add_custom_target(touchstone_installed)
add_dependencies(touchstone_installed ${touchstone_libraries})
if(TARGET touchstone_program)
  if(BUILD_SHARED_LIBS)  # the program finds them wherever both are installed
    file(RELATIVE_PATH to_libraries ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_LIBDIR})
    set_target_properties(touchstone_program PROPERTIES
      INSTALL_RPATH "$<IF:$<PLATFORM_ID:Darwin>,@loader_path,$ORIGIN>/${to_libraries}")
  endif()
  install(TARGETS touchstone_program RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
  add_dependencies(touchstone_installed touchstone_program)
  include(${CMAKE_CURRENT_LIST_DIR}/described.cmake)
endif()
# The theories that `touchstone prove --theorem` writes for; Extract.v is for the build of touchstone-check-proved.
install(DIRECTORY ${PROJECT_SOURCE_DIR}/src/proofs/proved/ DESTINATION ${CMAKE_INSTALL_DATADIR}/touchstone/proved
  COMPONENT program FILES_MATCHING PATTERN "*.v" PATTERN Extract.v EXCLUDE)
if(TARGET touchstone_check)
  install(TARGETS touchstone_check RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
  install(FILES ${PROJECT_SOURCE_DIR}/src/proofs/checker/touchstone-check.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1
    COMPONENT program)
  add_dependencies(touchstone_installed touchstone_check)
endif()
if(TARGET touchstone_python)
  add_dependencies(touchstone_installed touchstone_python)
endif()
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/touchstone DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
  FILES_MATCHING PATTERN "*.hpp" PATTERN "*.h")
install(DIRECTORY ${PROJECT_SOURCE_DIR}/src/fuzz/examples/ DESTINATION ${CMAKE_INSTALL_DATADIR}/touchstone/examples)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})

install(EXPORT touchstone-targets NAMESPACE touchstone:: DESTINATION ${touchstone_package_dir})
configure_package_config_file(
  ${CMAKE_CURRENT_LIST_DIR}/touchstone-config.cmake.in ${PROJECT_BINARY_DIR}/touchstone-config.cmake
  INSTALL_DESTINATION ${touchstone_package_dir})
write_basic_package_version_file(
  ${PROJECT_BINARY_DIR}/touchstone-config-version.cmake COMPATIBILITY SameMinorVersion)
install(
  FILES
    ${PROJECT_BINARY_DIR}/touchstone-config.cmake
    ${PROJECT_BINARY_DIR}/touchstone-config-version.cmake
    ${CMAKE_CURRENT_LIST_DIR}/touchstone-dependencies.cmake
  DESTINATION ${touchstone_package_dir})

include(${CMAKE_CURRENT_LIST_DIR}/pkg_config.cmake)
if(CMAKE_SOURCE_DIR STREQUAL PROJECT_SOURCE_DIR)
  include(${CMAKE_CURRENT_LIST_DIR}/debian.cmake)
endif()
