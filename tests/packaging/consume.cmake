# Configures, builds and runs the consumer project. The caller's -D: SOURCE_DIR (the project's), SCRATCH (a folder of
# this test's own), GENERATOR, COMPILER, FLAGS (the consumer's, for both languages' sake also the linker's), VERSION,
# TIGHT_INCLUSION (whether the drop-in is there), and
#   WAY=installed  BUILD_DIR and CONFIG: install that build into a fresh prefix and find it there
#   WAY=fetched    build the sources as a part of the consumer, with every flag of the consumer's own hostile to exact
#                  arithmetic, and without CGAL; as a static library, then shared, then install the shared one and find
#                  it
# SPDX-License-Identifier: MIT
cmake_minimum_required(VERSION 3.18)

set(consumer ${SOURCE_DIR}/tests/packaging/consumer)
set(programs consumer)
if(TIGHT_INCLUSION)
  list(APPEND programs line_search)
endif()

include(${CMAKE_CURRENT_LIST_DIR}/run.cmake)

# Configure and build the consumer in `build` with further -D options, and run its programs.
function(consume build)
  run(${CMAKE_COMMAND} -S ${consumer} -B ${build} -G ${GENERATOR}
    -DCMAKE_CXX_COMPILER=${COMPILER} -DCONSUMER_EXPECTS_VERSION=${VERSION}
    -DCONSUMER_TIGHT_INCLUSION=${TIGHT_INCLUSION} ${ARGN})
  run(${CMAKE_COMMAND} --build ${build} --parallel 2)
  foreach(program ${programs})
    foreach(mode plain fast_math)
      run(${build}/${program}_${mode})
      message(STATUS "${output}")
    endforeach()
  endforeach()
  run(${build}/consumer_c)
  message(STATUS "${output}")
endfunction()

# The shared libraries in `build` show the public namespace of this version and the C interface, and nothing else.
function(expect_public_names build)
  find_program(nm NAMES nm llvm-nm)
  file(GLOB_RECURSE libraries ${build}/*.so)
  if(NOT nm OR NOT libraries)
    message(STATUS "skipped: the names of shared libraries, because there is no nm or no *.so")
    return()
  endif()
  string(REGEX MATCH "^([0-9]+)[.]([0-9]+)" abi ${VERSION})
  set(abi v${CMAKE_MATCH_1}_${CMAKE_MATCH_2})
  string(LENGTH ${abi} length)
  set(public "^(touchstone_[a-z0-9_]+|_Z(NK?|T[ISV]N?)(10touchstone${length}${abi}|5ticcd)[0-9a-z].*)$")
  set(all "")
  foreach(library ${libraries})
    run(${nm} --dynamic --defined-only ${library})
    string(REGEX MATCHALL "[^ \n]+\n" names "${output}")
    foreach(name ${names})
      string(STRIP ${name} name)
      if(NOT name MATCHES ${public})
        message(FATAL_ERROR "${library} shows a name that is not public: ${name}")
      endif()
      list(APPEND all ${name})
    endforeach()
  endforeach()
  foreach(name touchstone_solve _ZN10touchstone${length}${abi}7versionEv)
    if(NOT name IN_LIST all)
      message(FATAL_ERROR "no shared library in ${build} shows ${name}")
    endif()
  endforeach()
endfunction()

# Nothing of CGAL may be needed by who uses an installed touchstone.
set(found_in -DCONSUMER_FETCHES=OFF -DCMAKE_BUILD_TYPE=Release -DCMAKE_DISABLE_FIND_PACKAGE_CGAL=ON
  -DCMAKE_DISABLE_FIND_PACKAGE_Boost=ON)

file(REMOVE_RECURSE ${SCRATCH}/prefix ${SCRATCH}/found)
if(WAY STREQUAL "installed")
  run(${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix ${SCRATCH}/prefix --config ${CONFIG})
  consume(${SCRATCH}/found ${found_in} -DCMAKE_PREFIX_PATH=${SCRATCH}/prefix
    -DCMAKE_CXX_FLAGS=${FLAGS} -DCMAKE_C_FLAGS=${FLAGS} -DCMAKE_EXE_LINKER_FLAGS=${FLAGS})
  if(EXISTS ${SCRATCH}/prefix/bin/touchstone)
    run(${SCRATCH}/prefix/bin/touchstone --version)
    if(NOT output STREQUAL "touchstone ${VERSION}\n")
      message(FATAL_ERROR "the installed program says that it is: ${output}")
    endif()
    run(${SCRATCH}/prefix/bin/touchstone certify)
    message(STATUS "${output}")
    # The example plugin, compiled as it says, is what `touchstone fuzz` loads and breaks.
    run(${COMPILER} -x c -std=c99 -O2 -shared -fPIC -I ${SCRATCH}/prefix/include -o ${SCRATCH}/found/naive.so
      ${SCRATCH}/prefix/share/touchstone/examples/plugin.c -lm)
    execute_process(COMMAND ${SCRATCH}/prefix/bin/touchstone fuzz --solver ${SCRATCH}/found/naive.so --cases 2000
      RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
    if(NOT status EQUAL 1 OR NOT output MATCHES "missed")
      message(FATAL_ERROR "exit status ${status} from touchstone fuzz with the example plugin:\n${output}")
    endif()
  endif()
elseif(WAY STREQUAL "fetched")
  set(fetched -DCONSUMER_FETCHES=ON -DFETCHCONTENT_SOURCE_DIR_TOUCHSTONE=${SOURCE_DIR} -DCMAKE_BUILD_TYPE=
    "-DCMAKE_CXX_FLAGS=-O1 -ffast-math" -DTOUCHSTONE_INSTALL=ON -DTOUCHSTONE_BUILD_FUZZ=ON
    -DTOUCHSTONE_WITH_CGAL=OFF -DCONSUMER_WITH_CGAL=OFF -DCMAKE_DISABLE_FIND_PACKAGE_CGAL=ON
    -DTOUCHSTONE_BUILD_TIGHT_INCLUSION=${TIGHT_INCLUSION})
  foreach(shared OFF ON)  # the same object files: only the library is linked anew
    consume(${SCRATCH}/fetched ${fetched} -DBUILD_SHARED_LIBS=${shared})
  endforeach()
  expect_public_names(${SCRATCH}/fetched)
  run(${CMAKE_COMMAND} --install ${SCRATCH}/fetched --prefix ${SCRATCH}/prefix)
  consume(${SCRATCH}/found ${found_in} -DCMAKE_PREFIX_PATH=${SCRATCH}/prefix -DCONSUMER_WITH_CGAL=OFF)
else()
  message(FATAL_ERROR "WAY is installed or fetched, not \"${WAY}\"")
endif()
