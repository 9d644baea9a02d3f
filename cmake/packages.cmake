# SPDX-License-Identifier: MIT
# Which modules are built, and the packages that these need: nothing is looked for that no module asks for.

option(MOIVRE_WITH_CVODE "Build the CVODE tracker (needs SUNDIALS)" ON)
option(MOIVRE_WITH_LANES "Build the lane tracker (needs Highway)" ON)
option(MOIVRE_WITH_MULTIPRECISION "Build the roots to many digits (needs MPFR)" ON)
set(switched_CVODE tracker_cvode)
set(switched_LANES tracker_lanes)
set(switched_MULTIPRECISION multiprecision)
foreach(switch CVODE LANES MULTIPRECISION)
  if(NOT MOIVRE_WITH_${switch})
    list(REMOVE_ITEM MOIVRE_MODULES ${switched_${switch}})
    list(REMOVE_ITEM MOIVRE_USES_cli ${switched_${switch}})
  endif()
endforeach()

if(MOIVRE_COMPONENTS STREQUAL "all")
  set(MOIVRE_BUILT_MODULES ${MOIVRE_MODULES})
else()
  foreach(module IN LISTS MOIVRE_COMPONENTS)
    if(NOT module IN_LIST MOIVRE_MODULES)
      message(FATAL_ERROR "MOIVRE_COMPONENTS: no module '${module}'; the modules are ${MOIVRE_MODULES}")
    endif()
  endforeach()
  moivre_closure(MOIVRE_BUILT_MODULES ${MOIVRE_COMPONENTS})
endif()

# Finders of packages that bring none themselves stand beside this file.
list(APPEND CMAKE_MODULE_PATH ${CMAKE_CURRENT_LIST_DIR})
foreach(module IN LISTS MOIVRE_BUILT_MODULES)
  foreach(package IN LISTS MOIVRE_THIRD_PARTY_${module})
    find_package(${MOIVRE_FIND_${package}} REQUIRED GLOBAL)
  endforeach()
endforeach()
