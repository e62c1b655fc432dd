# The target `docs`: the reference of the public headers, made by Doxygen into BUILD/docs/html.
# SPDX-License-Identifier: MIT
configure_file(${CMAKE_CURRENT_LIST_DIR}/Doxyfile.in ${PROJECT_BINARY_DIR}/docs/Doxyfile @ONLY)
# Doxygen is looked for when the target is built, so that installing it is enough.
add_custom_target(docs
  COMMAND ${CMAKE_COMMAND} -D DOXYFILE=${PROJECT_BINARY_DIR}/docs/Doxyfile
          -P ${CMAKE_CURRENT_LIST_DIR}/run-doxygen.cmake
  COMMENT "Reference of the public headers"
  VERBATIM)
