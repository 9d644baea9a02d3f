# SPDX-License-Identifier: MIT
# Finds Arb, with FLINT that it stands on or is part of, as the target Arb::Arb (neither brings a CMake package that all builds of it have).
#
# FLINT 3 has taken Arb in: one library, flint, headers under flint/, and Arb_VERSION is FLINT's. Beside FLINT 2.9 it is a library of its
# own, which Debian calls flint-arb and its authors call arb.
find_path(FLINT_INCLUDE_DIR flint/flint.h)
find_library(FLINT_LIBRARY flint)
# Inline functions of FLINT's headers call GMP's.
find_library(GMP_LIBRARY gmp)
set(arb_libraries FLINT_LIBRARY GMP_LIBRARY)
if(FLINT_INCLUDE_DIR AND EXISTS ${FLINT_INCLUDE_DIR}/flint/acb.h)
  set(ARB_INCLUDE_DIR ${FLINT_INCLUDE_DIR})
  set(version_header ${FLINT_INCLUDE_DIR}/flint/flint.h)
  set(version_name FLINT_VERSION)
else()
  find_path(ARB_INCLUDE_DIR arb.h)
  find_library(ARB_LIBRARY NAMES flint-arb arb)
  list(PREPEND arb_libraries ARB_LIBRARY)
  set(version_header ${ARB_INCLUDE_DIR}/arb.h)
  set(version_name ARB_VERSION)
endif()
if(ARB_INCLUDE_DIR)
  file(STRINGS ${version_header} version_line REGEX "define ${version_name} +\"")
  string(REGEX MATCH "[0-9]+\\.[0-9]+(\\.[0-9]+)?" Arb_VERSION "${version_line}")
endif()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Arb
  REQUIRED_VARS ${arb_libraries} ARB_INCLUDE_DIR FLINT_INCLUDE_DIR VERSION_VAR Arb_VERSION)

if(Arb_FOUND AND NOT TARGET Arb::Arb)
  add_library(Arb::Arb INTERFACE IMPORTED)
  set(libraries "")
  foreach(library IN LISTS arb_libraries)
    list(APPEND libraries ${${library}})
  endforeach()
  set_target_properties(Arb::Arb PROPERTIES
    INTERFACE_INCLUDE_DIRECTORIES "${ARB_INCLUDE_DIR};${FLINT_INCLUDE_DIR}"
    INTERFACE_LINK_LIBRARIES "${libraries}")
endif()
mark_as_advanced(ARB_INCLUDE_DIR FLINT_INCLUDE_DIR ARB_LIBRARY FLINT_LIBRARY GMP_LIBRARY)
