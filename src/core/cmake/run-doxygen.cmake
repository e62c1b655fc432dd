# cmake -D DOXYFILE=file -P run-doxygen.cmake: runs Doxygen, or says what to install.
# SPDX-License-Identifier: MIT
find_program(doxygen doxygen)
if(NOT doxygen)
  message("docs: left out, since doxygen is not installed (Debian, Ubuntu, Fedora and Arch: the package doxygen)")
  return()
endif()
execute_process(COMMAND ${doxygen} ${DOXYFILE} RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "docs: doxygen ended with ${status}; its warnings stand above")
endif()
