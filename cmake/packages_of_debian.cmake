# SPDX-License-Identifier: MIT
# Which .debs does `cpack` make? The program, the libraries, what one compiles against them with, and the Python module (scripts/packages).
#
# Dependencies are read from what each file links (dpkg-shlibdeps). The program is whole without the libraries where these are static.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME moivre)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(MOIVRE_PACKAGE_CONTACT "The Moivre authors <moivre@example.org>" CACHE STRING "Who answers for the .debs: name <address>")
set(CPACK_PACKAGE_CONTACT ${MOIVRE_PACKAGE_CONTACT})
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "every isolated root of a polynomial system")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_CURRENT_LIST_DIR}/finish_packages.cmake)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION math)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS_POLICY =)
set(CPACK_COMPONENTS_ALL program development)
set(exact "(= ${PROJECT_VERSION})")

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME moivre)
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION "every isolated root of a polynomial system: the program
 Finds all roots of polynomial systems, all closures of mechanisms and all
 postures of robot arms by homotopy continuation, and says whether the list is
 complete.")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libmoivre-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION "every isolated root of a polynomial system: headers
 What programs are compiled with that use the C++ library of Moivre.")
# What moivreConfig.cmake looks for.
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
  "libeigen3-dev, libboost-dev, libsundials-dev, libtbb-dev, libmpfr-dev, libgmp-dev, libflint-dev, libsqlite3-dev, libtomlplusplus-dev, libpugixml-dev")
# Beside FLINT 2 Arb is a package of its own.
if(ARB_LIBRARY)
  string(APPEND CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS ", libflint-arb-dev")
endif()
if(BUILD_SHARED_LIBS)
  list(APPEND CPACK_COMPONENTS_ALL library)
  set(library libmoivre${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
  set(CPACK_DEBIAN_LIBRARY_PACKAGE_NAME ${library})
  set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libs)
  set(CPACK_DEBIAN_LIBRARY_DESCRIPTION "every isolated root of a polynomial system: libraries
 Shared libraries of Moivre, one for each of its modules.")
  file(WRITE ${PROJECT_BINARY_DIR}/debian/triggers "activate-noawait ldconfig\n")
  set(CPACK_DEBIAN_LIBRARY_PACKAGE_CONTROL_EXTRA ${PROJECT_BINARY_DIR}/debian/triggers)
  string(APPEND CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS ", ${library} ${exact}")
  set(CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS "${library} ${exact}")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "${library} ${exact}, ")
  # A package's libraries are not installed yet when what links them is looked at.
  foreach(module IN LISTS MOIVRE_BUILT_MODULES)
    list(APPEND CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${PROJECT_BINARY_DIR}/src/${module})
  endforeach()
endif()
if(TARGET moivre_python)
  list(APPEND CPACK_COMPONENTS_ALL python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-moivre)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
  string(APPEND CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "${MOIVRE_PYTHON_PACKAGES}")
  set(CPACK_DEBIAN_PYTHON_DESCRIPTION "every isolated root of a polynomial system: Python module
 The module moivre: roots of systems, closures of mechanisms and postures of
 robot arms as numpy's arrays.")
endif()
include(CPack)
