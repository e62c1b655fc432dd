# Writes the C++ source that holds the styles and scripts of the pages:
#   cmake -D FILES=file,file -D OUTPUT=source -P embed.cmake
cmake_minimum_required(VERSION 3.18)

# Visual C++ takes 16,380 bytes in one string literal and 65,535 in adjacent ones together.
set(literal_bytes 12000)
set(most_bytes 60000)

set(code [[
// Written by src/view/page/embed.cmake; edit the files of src/view/page instead.
// SPDX-License-Identifier: MIT
#include "view/page_files.hpp"

namespace touchstone::view {

const std::vector<PageFile>& page_files() {
  static const std::vector<PageFile> files = {
]])

string(REPLACE "," ";" files "${FILES}")
foreach(file IN LISTS files)
  get_filename_component(name "${file}" NAME)
  file(READ "${file}" content)
  string(REPLACE "\r\n" "\n" content "${content}")
  string(LENGTH "${content}" length)
  if(length GREATER most_bytes)
    message(FATAL_ERROR "${name} has ${length} bytes; a file of a page has at most ${most_bytes}")
  endif()
  if(content MATCHES "\\)page\"|</script|[^\n\t -~]")
    message(FATAL_ERROR "${name} contains )page\", </script or a character that is not of ASCII")
  endif()
  string(APPEND code "    {\"${name}\",\n")
  set(start 0)
  while(start LESS length)
    string(SUBSTRING "${content}" ${start} ${literal_bytes} part)
    string(APPEND code "R\"page(${part})page\"\n")
    math(EXPR start "${start} + ${literal_bytes}")
  endwhile()
  string(APPEND code "    },\n")
endforeach()

string(APPEND code [[
  };
  return files;
}

}  // namespace touchstone::view
]])
file(WRITE "${OUTPUT}" "${code}")
