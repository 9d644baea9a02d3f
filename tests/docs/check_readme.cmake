# SPDX-License-Identifier: MIT
# Do README.md and docs/guide.md show what really happens? README's program is the one in examples/, the commands run and print what stands there.
#
# In a ```console block a line `$ command` is followed by what it prints. A command of scripts/ must be there and may be run;
# a `moivre` command is run here, from the root of the tree (the guide's in docs/guide), with the program MOIVRE. A line `...` stands
# for lines left out.
include(${CMAKE_CURRENT_LIST_DIR}/text.cmake)
set(readme ${ROOT}/README.md)
read_text(text ${readme})

read_text(example ${ROOT}/examples/solve_system.cpp)
string(FIND "${example}" "#include" begin)
string(SUBSTRING "${example}" ${begin} -1 example)
string(FIND "${text}" "${example}" position)
if(position EQUAL -1)
  fault(${readme} "its program is not that of examples/solve_system.cpp")
endif()

# normalize(<variable>): what varies from run to run or from compiler to compiler is blotted out: seconds, threads, bounds on
# errors, and digits beyond the twelfth.
set(digit "[0-9]")
string(REPEAT ${digit} 12 twelve_digits)
function(normalize variable)
  string(REGEX REPLACE "[0-9.e+-]+ (s|ms|seconds|threads?)([^a-z]|$)" "# \\1\\2" text "${${variable}}")
  string(REGEX REPLACE "accuracy [0-9.e+-]+" "accuracy #" text "${text}")
  string(REGEX REPLACE "([0-9][.]${twelve_digits})[0-9]+" "\\1" text "${text}")
  string(REGEX REPLACE " +" " " text "${text}")
  set(${variable} "${text}" PARENT_SCOPE)
endfunction()

function(check_command document folder command expected)
  separate_arguments(words UNIX_COMMAND "${command}")
  list(POP_FRONT words program)
  if(program MATCHES "^scripts/")
    execute_process(COMMAND test -x ${ROOT}/${program} RESULT_VARIABLE missing)
    if(missing)
      fault(${document} "${program} is not there to be run")
    endif()
  elseif(program MATCHES "moivre$" AND MOIVRE)
    execute_process(COMMAND ${MOIVRE} ${words} WORKING_DIRECTORY ${folder}
                    OUTPUT_VARIABLE printed ERROR_VARIABLE printed RESULT_VARIABLE code)
    string(REPLACE "[" "${open}" printed "${printed}")
    string(REPLACE "]" "${close}" printed "${printed}")
    string(REPLACE ";" "${semicolon}" printed "${printed}")
    normalize(printed)
    string(REPLACE "\n" ";" lines "${expected}")
    foreach(line IN LISTS lines)
      normalize(line)
      string(STRIP "${line}" line)
      string(FIND "${printed}" "${line}" position)
      if(position EQUAL -1 AND NOT line STREQUAL "...")
        fault(${document} "`${command}` does not print '${line}'")
      endif()
    endforeach()
  endif()
  set(faults ${faults} PARENT_SCOPE)
endfunction()

# check_document(<file> <folder>): every command of the file's ```console blocks, run in the folder.
function(check_document document folder)
  read_text(text ${document})
  string(REGEX MATCHALL "```console\n[^`]*```" blocks "${text}")
  foreach(block IN LISTS blocks)
    string(REGEX MATCHALL "\\$ [^$]*" commands "${block}")
    foreach(entry IN LISTS commands)
      string(REGEX MATCH "\\$ ([^\n]+)\n([^`]*)" matched "${entry}")
      check_command(${document} ${folder} "${CMAKE_MATCH_1}" "${CMAKE_MATCH_2}")
    endforeach()
  endforeach()
  set(faults ${faults} PARENT_SCOPE)
endfunction()

check_document(${readme} ${ROOT})
check_document(${ROOT}/docs/guide.md ${ROOT}/docs/guide)

# The guide's mechanism is the file that its commands read.
read_text(guide ${ROOT}/docs/guide.md)
read_text(mechanism ${ROOT}/docs/guide/quick-return.toml)
string(FIND "${mechanism}" "title" begin)
string(SUBSTRING "${mechanism}" ${begin} -1 mechanism)
string(FIND "${guide}" "${mechanism}" position)
if(position EQUAL -1)
  fault(${ROOT}/docs/guide.md "its mechanism is not that of docs/guide/quick-return.toml")
endif()
finish()
