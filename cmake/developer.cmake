# SPDX-License-Identifier: MIT
# Conveniences of those who work on Moivre itself; a project that includes it by add_subdirectory meets none of them.

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Debug, Release, RelWithDebInfo or MinSizeRel" FORCE)
endif()
# The sources of a target are one unit, as in most presets; where they are to be compiled alone, -DCMAKE_UNITY_BUILD=OFF.
if(NOT DEFINED CMAKE_UNITY_BUILD)
  set(CMAKE_UNITY_BUILD ON)
  set(CMAKE_UNITY_BUILD_BATCH_SIZE 0)
endif()
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)

# A compiler cache is used where there is one that works: it fails for a user who cannot write to the home folder.
find_program(MOIVRE_CCACHE ccache DOC "Compiler cache")
if(MOIVRE_CCACHE AND NOT DEFINED MOIVRE_CCACHE_WORKS)
  file(WRITE ${PROJECT_BINARY_DIR}/ccache_probe.cpp "int probe;\n")
  execute_process(
    COMMAND ${MOIVRE_CCACHE} ${CMAKE_CXX_COMPILER} -c ccache_probe.cpp -o ccache_probe.o
    WORKING_DIRECTORY ${PROJECT_BINARY_DIR} RESULT_VARIABLE probe OUTPUT_QUIET ERROR_QUIET)
  if(probe EQUAL 0)
    set(MOIVRE_CCACHE_WORKS TRUE CACHE INTERNAL "ccache compiled a file for this user")
  else()
    set(MOIVRE_CCACHE_WORKS FALSE CACHE INTERNAL "ccache compiled a file for this user")
  endif()
endif()
# It caches sources behind a precompiled header only when told that what such a header defines is no matter.
if(MOIVRE_CCACHE_WORKS AND NOT DEFINED CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros ${MOIVRE_CCACHE})
  add_compile_options(
    "$<$<COMPILE_LANG_AND_ID:CXX,GNU>:-fpch-preprocess>"
    "$<$<COMPILE_LANG_AND_ID:CXX,Clang>:SHELL:-Xclang -fno-pch-timestamp>")
endif()
# GCC spends up to a tenth of its time looking for memory to free before it has used a gigabyte.
add_compile_options("$<$<COMPILE_LANG_AND_ID:CXX,GNU>:SHELL:--param ggc-min-heapsize=1000000>")
