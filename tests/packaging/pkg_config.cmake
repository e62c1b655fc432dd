# A build that knows pkg-config and not CMake compiles and links with the installed touchstone.pc, in C++ and in C, also
# after the installation was moved. The caller's -D: SOURCE_DIR (the project's), BUILD_DIR and CONFIG of the build to
# install, SCRATCH (a folder of this test's own), COMPILER and C_COMPILER, FLAGS (of both), VERSION.
# SPDX-License-Identifier: MIT
cmake_minimum_required(VERSION 3.18)

find_program(pkg_config NAMES pkg-config pkgconf)
if(NOT pkg_config)
  message("skipped: no pkg-config here (Debian: pkg-config)")
  return()
endif()

include(${CMAKE_CURRENT_LIST_DIR}/run.cmake)

# ask(ARGUMENT...) leaves the answer of pkg-config in `output`.
function(ask)
  run(${pkg_config} ${ARGN})
  string(STRIP "${output}" output)
  set(output "${output}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE ${SCRATCH})
run(${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix ${SCRATCH}/first --config ${CONFIG})
file(RENAME ${SCRATCH}/first ${SCRATCH}/moved)
file(GLOB_RECURSE files ${SCRATCH}/moved/*.pc)
list(LENGTH files count)
if(NOT count EQUAL 2)
  message(FATAL_ERROR "the install has ${count} .pc files, not touchstone.pc and touchstone-fuzz.pc: ${files}")
endif()
list(GET files 0 first)
get_filename_component(folder ${first} DIRECTORY)
set(ENV{PKG_CONFIG_PATH} ${folder})

ask(--modversion touchstone)
if(NOT output STREQUAL VERSION)
  message(FATAL_ERROR "pkg-config says that touchstone is version ${output}, not ${VERSION}")
endif()
ask(--cflags --libs touchstone-fuzz)  # it brings touchstone along
separate_arguments(both UNIX_COMMAND "${output}")
ask(--cflags --libs touchstone)
separate_arguments(alone UNIX_COMMAND "${output}")
string(FIND "${output}" ${SCRATCH}/moved place)
if(place EQUAL -1)
  message(FATAL_ERROR "the flags do not lead to where the installation is: ${output}")
endif()
separate_arguments(flags UNIX_COMMAND "${FLAGS}")
set(consumer ${SOURCE_DIR}/tests/packaging/consumer)
set(version -DEXPECTED_VERSION="${VERSION}")
run(${COMPILER} -std=c++17 ${flags} ${version} -DCONSUMER_FLUSHES=0 -DCONSUMER_WITH_CGAL=1 ${consumer}/consumer.cpp ${both}
  -o ${SCRATCH}/consumer)
run(${C_COMPILER} -std=c11 ${flags} ${version} ${consumer}/consumer.c ${alone} -o ${SCRATCH}/consumer_c)
foreach(program consumer consumer_c)
  run(${CMAKE_COMMAND} -E env LD_LIBRARY_PATH=${folder}/.. ${SCRATCH}/${program})
  message(STATUS "${output}")
endforeach()
