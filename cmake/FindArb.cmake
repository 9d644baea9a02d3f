# SPDX-License-Identifier: MIT
# Finds Arb 2 with FLINT 2 that it stands on (none brings a CMake package of its own): the target Arb::Arb has the headers,
# Arb_RUNTIME_NAME is the name to load the library by.
# Debian calls Arb's library flint-arb, its authors call it arb. Not supported: FLINT 3, which took Arb in.
find_path(ARB_INCLUDE_DIR arb.h)
find_path(FLINT_INCLUDE_DIR flint/flint.h)
find_library(ARB_LIBRARY NAMES flint-arb arb)
if(ARB_INCLUDE_DIR)
  file(STRINGS ${ARB_INCLUDE_DIR}/arb.h version_line REGEX "define ARB_VERSION ")
  string(REGEX MATCH "[0-9]+\\.[0-9]+\\.[0-9]+" ARB_VERSION "${version_line}")
endif()

if(ARB_LIBRARY)
  execute_process(COMMAND ${CMAKE_READELF} -d ${ARB_LIBRARY} OUTPUT_VARIABLE dynamic ERROR_QUIET)
  string(REGEX MATCH "SONAME[^\n]*\\[([^]]+)\\]" soname "${dynamic}")
  set(Arb_RUNTIME_NAME ${CMAKE_MATCH_1})
endif()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Arb
  REQUIRED_VARS ARB_LIBRARY Arb_RUNTIME_NAME ARB_INCLUDE_DIR FLINT_INCLUDE_DIR
  VERSION_VAR ARB_VERSION)
set(Arb_VERSION ${ARB_VERSION})

if(Arb_FOUND AND NOT TARGET Arb::Arb)
  add_library(Arb::Arb INTERFACE IMPORTED)
  set_target_properties(Arb::Arb PROPERTIES
    INTERFACE_INCLUDE_DIRECTORIES "${ARB_INCLUDE_DIR};${FLINT_INCLUDE_DIR}")
endif()
mark_as_advanced(ARB_INCLUDE_DIR FLINT_INCLUDE_DIR ARB_LIBRARY)
