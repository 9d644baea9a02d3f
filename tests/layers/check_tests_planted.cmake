# SPDX-License-Identifier: MIT
# Would check_tests.cmake see a test that nobody compiles? Plants one in a copy of a folder.
cmake_minimum_required(VERSION 3.25)

file(REMOVE_RECURSE ${SCRATCH})
file(COPY ${ROOT}/tests/start DESTINATION ${SCRATCH}/tests)
file(WRITE ${SCRATCH}/tests/start/planted_test.cpp "")
execute_process(COMMAND ${CMAKE_COMMAND} -D ROOT=${SCRATCH} -P ${CMAKE_CURRENT_LIST_DIR}/check_tests.cmake
                RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
string(FIND "${output}" "tests/start/planted_test.cpp is named by no CMakeLists.txt" position)
if(result EQUAL 0 OR position EQUAL -1 OR NOT output MATCHES "\n? *1 tests are not compiled")
  message(FATAL_ERROR "the planted test was not seen alone:\n${output}")
endif()
