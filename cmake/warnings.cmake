# SPDX-License-Identifier: MIT
# The warnings that both compilers must be silent at; a target takes them by linking moivre_warnings privately.

add_library(moivre_warnings INTERFACE)
target_compile_options(moivre_warnings INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion
  -Wswitch-enum)
# GCC 12 sees overlaps in std::string's own copies once they are inlined (GCC bug 105651).
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  target_compile_options(moivre_warnings INTERFACE -Wno-restrict)
endif()
# Behind a precompiled header GCC 12 and 14 warn of how data flows through other libraries' code, since they forget whose that is; 14
# also of how std::vector frees what it has.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 15
   AND NOT CMAKE_DISABLE_PRECOMPILE_HEADERS)
  target_compile_options(moivre_warnings INTERFACE -Wno-array-bounds -Wno-stringop-overflow -Wno-stringop-overread
    -Wno-maybe-uninitialized)
  if(CMAKE_CXX_COMPILER_VERSION VERSION_GREATER_EQUAL 13)
    target_compile_options(moivre_warnings INTERFACE -Wno-free-nonheap-object)
  endif()
endif()
if(MOIVRE_WARNINGS_AS_ERRORS)
  target_compile_options(moivre_warnings INTERFACE -Werror)
endif()
