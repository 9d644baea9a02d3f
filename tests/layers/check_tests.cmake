# SPDX-License-Identifier: MIT
# Is every test compiled? A file tests/<folder>/<name>_test.cpp that its folder's CMakeLists.txt does not name is run by nobody. Prints each
# and fails if there is any.
#
# Run as: cmake -D ROOT=<tree> -P check_tests.cmake. A function of the folder may put "_test.cpp" to a name.
cmake_minimum_required(VERSION 3.25)

set(left_out 0)
file(GLOB_RECURSE files RELATIVE ${ROOT}/tests ${ROOT}/tests/*_test.cpp)
foreach(file IN LISTS files)
  get_filename_component(folder ${file} DIRECTORY)
  get_filename_component(name ${file} NAME)
  string(REPLACE "_test.cpp" "" stem ${name})
  file(READ ${ROOT}/tests/${folder}/CMakeLists.txt text)
  if(NOT text MATCHES "[ (\n]${stem}(_test\\.cpp)?[ )\n]")
    message("tests/${file} is named by no CMakeLists.txt")
    math(EXPR left_out "${left_out} + 1")
  endif()
endforeach()
if(left_out GREATER 0)
  message(FATAL_ERROR "${left_out} tests are not compiled")
endif()
