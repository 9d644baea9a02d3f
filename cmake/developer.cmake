# SPDX-License-Identifier: MIT
# Conveniences of those who work on Moivre itself; a project that includes it by add_subdirectory meets none of them.

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Debug, Release, RelWithDebInfo or MinSizeRel" FORCE)
endif()

find_program(MOIVRE_CCACHE ccache DOC "Compiler cache; used when it is there")
if(MOIVRE_CCACHE AND NOT DEFINED CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${MOIVRE_CCACHE})
endif()
