# SPDX-License-Identifier: MIT
# What every check of the prose needs: text that is safe in CMake's lists, the files of the tree, a count of faults.
cmake_minimum_required(VERSION 3.25)

# In a CMake list `[`, `]` and `;` have meanings of their own; the checks see these three characters in their place.
string(ASCII 1 open)
string(ASCII 2 close)
string(ASCII 3 semicolon)

# read_text(<variable> <file> [LIMIT <bytes>]): the file with brackets and semicolons replaced as above.
function(read_text variable file)
  file(READ ${file} text ${ARGN})
  string(REPLACE "[" "${open}" text "${text}")
  string(REPLACE "]" "${close}" text "${text}")
  string(REPLACE ";" "${semicolon}" text "${text}")
  set(${variable} "${text}" PARENT_SCOPE)
endfunction()

set(faults 0)
function(fault file message)
  file(RELATIVE_PATH shown ${ROOT} ${file})
  string(REPLACE "${open}" "[" message "${message}")
  string(REPLACE "${close}" "]" message "${message}")
  message("${shown}: ${message}")
  math(EXPR count "${faults} + 1")
  set(faults ${count} PARENT_SCOPE)
endfunction()

macro(finish)
  if(faults)
    message(FATAL_ERROR "${faults} faults")
  endif()
endmacro()

# The files that people write and a compiler, CMake or a shell reads.
file(GLOB_RECURSE code_files
  ${ROOT}/bench/*.h ${ROOT}/bench/*.cpp ${ROOT}/examples/*.h ${ROOT}/examples/*.cpp
  ${ROOT}/fuzz/*.h ${ROOT}/fuzz/*.cpp ${ROOT}/include/*.h ${ROOT}/src/*.h ${ROOT}/src/*.cpp
  ${ROOT}/tests/*.h ${ROOT}/tests/*.cpp ${ROOT}/python/*.h ${ROOT}/python/*.cpp)
file(GLOB_RECURSE cmake_files
  ${ROOT}/cmake/*.cmake ${ROOT}/cmake/*.in ${ROOT}/tests/*.cmake ${ROOT}/bench/CMakeLists.txt
  ${ROOT}/examples/CMakeLists.txt ${ROOT}/fuzz/CMakeLists.txt ${ROOT}/src/CMakeLists.txt
  ${ROOT}/tests/CMakeLists.txt ${ROOT}/python/CMakeLists.txt)
file(GLOB script_files ${ROOT}/scripts/* ${ROOT}/.ci/run ${ROOT}/python/*/*.py ${ROOT}/python/*/*.pyi)
file(GLOB_RECURSE prose_files ${ROOT}/docs/*.md)
list(APPEND cmake_files ${ROOT}/CMakeLists.txt)
list(APPEND prose_files ${ROOT}/README.md ${ROOT}/CONTRIBUTING.md)
