# Writes the C++ source of a function that returns the names and contents of text files:
#   cmake -D LIST=file -D FOLDER=folder -D PREFIX=text -D FOR_PAGES=ON|OFF -D HEADER=header -D TYPE=type
#         -D FUNCTION=name -D OUTPUT=source -P embed.cmake
# LIST names the files, one a line, relative to FOLDER. HEADER declares `const std::vector<TYPE>& FUNCTION()`, both with
# their namespaces; a TYPE has a name, which is PREFIX and that of the list, and a content. FOR_PAGES asks for files
# that can stand in the <script> and <style> of a page.
# SPDX-License-Identifier: MIT
cmake_minimum_required(VERSION 3.18)

# Visual C++ takes 16,380 bytes in one string literal and 65,535 in adjacent ones together.
set(literal_bytes 12000)
set(most_bytes 60000)

set(code "// Written by src/core/cmake/embed.cmake; edit the files in ${FOLDER} instead.
// SPDX-License-Identifier: MIT
#include \"${HEADER}\"

const std::vector<${TYPE}>& ${FUNCTION}() {
  static const std::vector<${TYPE}> files = {
")
file(STRINGS "${LIST}" names)
foreach(name IN LISTS names)
  file(READ "${FOLDER}/${name}" content)
  string(REPLACE "\r\n" "\n" content "${content}")
  string(LENGTH "${content}" length)
  if(length GREATER most_bytes)
    message(FATAL_ERROR "${name} has ${length} bytes; an embedded file has at most ${most_bytes}")
  endif()
  if(content MATCHES "\\)text\"")
    message(FATAL_ERROR "${name} contains )text\", which would end its string literal")
  endif()
  if(FOR_PAGES AND content MATCHES "</script|</style|[^\n\t -~]")
    message(FATAL_ERROR "${name} contains </script, </style or a character that is not of ASCII")
  endif()
  string(APPEND code "    {\"${PREFIX}${name}\",\n")
  set(start 0)
  while(start LESS length)
    string(SUBSTRING "${content}" ${start} ${literal_bytes} part)
    string(APPEND code "R\"text(${part})text\"\n")
    math(EXPR start "${start} + ${literal_bytes}")
  endwhile()
  string(APPEND code "    },\n")
endforeach()
string(APPEND code "  };\n  return files;\n}\n")
file(WRITE "${OUTPUT}" "${code}")
