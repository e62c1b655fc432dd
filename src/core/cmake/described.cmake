# The man page and the completions of bash and zsh, written by the program itself after it is linked.
# SPDX-License-Identifier: MIT
if(CMAKE_CROSSCOMPILING)
  message(STATUS "The man page and the shells' completions are left out: the program does not run here")
  return()
endif()
set(touchstone_descriptions "")
# touchstone_describe(FORM FILE FOLDER): `touchstone describe --as FORM` becomes FOLDER/FILE below the prefix.
function(touchstone_describe form file folder)
  set(written ${PROJECT_BINARY_DIR}/described/${form}/${file})
  add_custom_command(OUTPUT ${written}
    COMMAND ${CMAKE_COMMAND} -E make_directory ${PROJECT_BINARY_DIR}/described/${form}
    COMMAND touchstone_program describe --as ${form} --out ${written}
    DEPENDS touchstone_program VERBATIM)
  install(FILES ${written} DESTINATION ${folder} COMPONENT program)
  set(touchstone_descriptions ${touchstone_descriptions} ${written} PARENT_SCOPE)
endfunction()
touchstone_describe(man touchstone.1 ${CMAKE_INSTALL_MANDIR}/man1)
touchstone_describe(bash touchstone ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
touchstone_describe(zsh _touchstone ${CMAKE_INSTALL_DATADIR}/zsh/site-functions)
add_custom_target(touchstone_described ALL DEPENDS ${touchstone_descriptions})
add_dependencies(touchstone_installed touchstone_described)
