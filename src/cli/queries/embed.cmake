# Writes the C++ source that holds the bundled queries:
#   cmake -D LIST=file -D FOLDER=folder -D OUTPUT=source -P embed.cmake
# LIST names the query files, one a line, relative to FOLDER.
cmake_minimum_required(VERSION 3.18)

# Visual C++ takes 16,380 bytes in one string literal and 65,535 in adjacent ones together.
set(literal_bytes 12000)
set(most_bytes 60000)

set(code [[
// Written by src/cli/queries/embed.cmake; edit the query files instead.
// SPDX-License-Identifier: MIT
#include "cli/queries/bundled.hpp"

namespace touchstone::cli {

const std::vector<BundledFile>& bundled_files() {
  static const std::vector<BundledFile> files = {
]])

file(STRINGS "${LIST}" names)
foreach(name IN LISTS names)
  file(READ "${FOLDER}/${name}" content)
  string(REPLACE "\r\n" "\n" content "${content}")
  string(LENGTH "${content}" length)
  if(length GREATER most_bytes)
    message(FATAL_ERROR "${name} has ${length} bytes; a bundled file has at most ${most_bytes}")
  endif()
  if(content MATCHES "\\)csv\"")
    message(FATAL_ERROR "${name} contains )csv\", which would end its string literal")
  endif()
  string(APPEND code "    {\"bundled/${name}\",\n")
  set(start 0)
  while(start LESS length)
    string(SUBSTRING "${content}" ${start} ${literal_bytes} part)
    string(APPEND code "R\"csv(${part})csv\"\n")
    math(EXPR start "${start} + ${literal_bytes}")
  endwhile()
  string(APPEND code "    },\n")
endforeach()

string(APPEND code [[
  };
  return files;
}

}  // namespace touchstone::cli
]])
file(WRITE "${OUTPUT}" "${code}")
