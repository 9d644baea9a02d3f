# SPDX-License-Identifier: MIT
# Would check_sentences.cmake see English that stands elsewhere? Copies the sources to SCRATCH, plants statements one by one, and wants each
# refused by its words, and what is no English of results let through.
cmake_minimum_required(VERSION 3.25)

file(REMOVE_RECURSE ${SCRATCH})
file(COPY ${ROOT}/src DESTINATION ${SCRATCH})

function(check result_variable output_variable)
  execute_process(
    COMMAND ${CMAKE_COMMAND} -D ROOT=${SCRATCH} -P ${CMAKE_CURRENT_LIST_DIR}/check_sentences.cmake
    RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  set(${result_variable} ${result} PARENT_SCOPE)
  set(${output_variable} "${output}" PARENT_SCOPE)
endfunction()

# refused(<file> <statements> <words>): with these the check has to fail, and to say <words>.
function(refused file statements words)
  file(WRITE ${SCRATCH}/${file} "${statements}\n")
  check(result output)
  file(REMOVE ${SCRATCH}/${file})
  string(FIND "${output}" "${file}: English outside of a sentences file: ${words}" position)
  if(result EQUAL 0 OR position EQUAL -1)
    message(FATAL_ERROR "not refused with '${words}':\n${output}")
  endif()
endfunction()

# accepted(<statements>): these are no breach.
function(accepted statements)
  file(WRITE ${SCRATCH}/src/motion/planted.cpp "${statements}\n")
  check(result output)
  file(REMOVE ${SCRATCH}/src/motion/planted.cpp)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "refused:\n${output}")
  endif()
endfunction()

accepted("")
refused(src/motion/planted.cpp "result.message = \"some paths failed\";" "\"some paths failed\"")
refused(src/motion/planted.cpp "left_out.push_back({\"what; [was]\",\n  \"it was left\"});" "\"what; [was]\" \"it was left\"")
refused(src/family/planted.h "inline constexpr std::string_view kClaim = \"the file says: \";" "\"the file says: \"")
refused(src/motion/planted.cpp "throw InvalidInput(\"no such path here\");\nwhy = \"it is \" + n + \" of \" + m;"
        "\"it is \" \" of \"")
accepted("// He said \"this is no statement\" here.\nkeys = {{\"one\", 1}, {\"two\", 2}, {\"three\", 3}};")
accepted("if (x) throw InvalidInput(\"the path has no number \" + x);\nbroken.push_back(\"it must be above 0\");")

# A module that has lost its file.
file(REMOVE ${SCRATCH}/src/family/family_sentences.cpp)
check(result output)
if(result EQUAL 0 OR NOT output MATCHES "src/family: no sentences file")
  message(FATAL_ERROR "not refused without its sentences file:\n${output}")
endif()
