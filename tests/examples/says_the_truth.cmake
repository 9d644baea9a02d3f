# SPDX-License-Identifier: MIT
# Does the program end well, and print each line that is true?
execute_process(COMMAND ${PROGRAM} ${ARGUMENTS} OUTPUT_VARIABLE printed ERROR_VARIABLE complaint RESULT_VARIABLE code)
if(NOT code EQUAL 0)
  message(FATAL_ERROR "exit code ${code}: ${complaint}\n${printed}")
endif()
foreach(line IN LISTS TRUTH)
  if(NOT printed MATCHES "${line}")
    message(FATAL_ERROR "it does not print ${line}, but:\n${printed}")
  endif()
endforeach()
