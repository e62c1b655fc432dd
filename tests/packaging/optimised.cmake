# A project that adds touchstone without a build type gets it compiled with -O2, and keeps a level of its own. It gets
# the library alone, and no warning. The caller's -D: SOURCE_DIR, SCRATCH, GENERATOR and COMPILER.
# SPDX-License-Identifier: MIT
cmake_minimum_required(VERSION 3.18)

foreach(flags "" "-O1")
  file(REMOVE_RECURSE ${SCRATCH})
  file(WRITE ${SCRATCH}/CMakeLists.txt
    "cmake_minimum_required(VERSION 3.18)\nproject(user CXX)\nset(CMAKE_EXPORT_COMPILE_COMMANDS ON)\n"
    "add_subdirectory(${SOURCE_DIR} touchstone)\n")
  execute_process(COMMAND ${CMAKE_COMMAND} -E env --unset=CXXFLAGS ${CMAKE_COMMAND} -S ${SCRATCH} -B ${SCRATCH}/build
      -G ${GENERATOR} -DCMAKE_CXX_COMPILER=${COMPILER} "-DCMAKE_CXX_FLAGS=${flags}"
    RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "exit status ${status}:\n${output}")
  endif()
  if(output MATCHES "CMake [A-Za-z ]*Warning")
    message(FATAL_ERROR "the configuration warns:\n${output}")
  endif()
  file(READ ${SCRATCH}/build/compile_commands.json commands)
  string(REGEX MATCHALL "\"file\": \"[^\"]*" files "${commands}")
  list(TRANSFORM files REPLACE "^\"file\": \"${SOURCE_DIR}/" "")
  list(FILTER files EXCLUDE REGEX "^src/(core/|bindings/c_api/|version\\.cpp$)")
  if(files)
    message(FATAL_ERROR "more than the library is compiled: ${files}")
  endif()
  string(REGEX MATCH "[^\n]*touchstone_solver.dir/cascade.cpp.o[^\n]*" command "${commands}")
  string(REGEX MATCHALL " -O[0-9s]" levels "${command}")
  set(right " -O2")
  if(flags)
    set(right " ${flags}")
  endif()
  if(NOT levels STREQUAL right)
    message(FATAL_ERROR "with CMAKE_CXX_FLAGS '${flags}' the levels are '${levels}', not '${right}': ${command}")
  endif()
endforeach()
