# run(COMMAND ARGUMENT...) runs a command and leaves what it printed in `output`; an exit status but 0 ends the test.
# SPDX-License-Identifier: MIT
function(run)
  list(JOIN ARGN " " line)
  message(STATUS "${line}")
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE errors)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "exit status ${status} from: ${line}\n${output}${errors}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()
