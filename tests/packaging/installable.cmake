# Every library and program that `cmake --install` copies is an output of the target that src/certify-bundled.sh builds.
# The test run itself has built all targets, so that an install which succeeds here would prove nothing; the build
# system's own graph is asked instead. The caller's -D: SOURCE_DIR, BUILD_DIR and CONFIG of this build, PREFIX (a folder
# of this test's own), GENERATOR and MAKE_PROGRAM.
# SPDX-License-Identifier: MIT
cmake_minimum_required(VERSION 3.18)

if(NOT GENERATOR STREQUAL "Ninja")
  message("skipped: only Ninja can list what a target is made from, and this build uses ${GENERATOR}")
  return()
endif()

# Ends the test unless the command that ran before succeeded.
macro(expect_success status output)
  if(NOT ${status} EQUAL 0)
    message(FATAL_ERROR "exit status ${${status}}:\n${${output}}")
  endif()
endmacro()

file(READ ${SOURCE_DIR}/src/certify-bundled.sh script)
if(NOT script MATCHES "\nbuild_preset release ([a-z_]+)")
  message(FATAL_ERROR "src/certify-bundled.sh does not build a target of the preset release")
endif()
set(target ${CMAKE_MATCH_1})

# `-t query` lists the direct inputs of the target; `-t inputs` lists the inputs of these, and so on.
set(inputs "")
foreach(tool query inputs)
  execute_process(COMMAND ${MAKE_PROGRAM} -C ${BUILD_DIR} -t ${tool} ${target}
    RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(output MATCHES "unknown tool")
    message("skipped: this Ninja has no `-t inputs`, which came with 1.11")
    return()
  endif()
  expect_success(status output)
  string(APPEND inputs "${output}")
endforeach()
string(REGEX REPLACE "[ \n]+" ";" inputs "${inputs}")
# Neither tool looks behind a target that is no file itself.
if("touchstone_described" IN_LIST inputs)
  execute_process(COMMAND ${MAKE_PROGRAM} -C ${BUILD_DIR} -t query touchstone_described
    RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  expect_success(status output)
  string(REGEX REPLACE "[ \n]+" ";" output "${output}")
  list(APPEND inputs ${output})
endif()
list(TRANSFORM inputs REPLACE "^.*/" "")

file(REMOVE_RECURSE ${PREFIX})
execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix ${PREFIX} --config ${CONFIG}
  RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
expect_success(status output)

# Built files, with what the program writes about itself. Headers, the man page of the checker, examples, pages and
# CMake's own files are copied from the sources or written by configuring.
file(GLOB_RECURSE installed LIST_DIRECTORIES FALSE ${PREFIX}/*)
list(FILTER installed INCLUDE REGEX "/bin/[^/]*$|/share/(bash-completion|zsh)/|/touchstone\\.1$|/lib[^/]*\\.(a|so|dylib)[.0-9]*$")
list(LENGTH installed count)
if(count EQUAL 0)
  message(FATAL_ERROR "the install has no library and no program")
endif()
foreach(file ${installed})
  get_filename_component(name ${file} NAME)
  if(NOT name IN_LIST inputs)
    message(FATAL_ERROR "src/certify-bundled.sh builds ${target}, which does not build ${name}; "
      "`cmake --install build/release` fails after it")
  endif()
endforeach()
message(STATUS "${target} builds all ${count} built files that are installed")
