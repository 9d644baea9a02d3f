# SPDX-License-Identifier: MIT
# Which modules are built, and the packages that these need: nothing is looked for that no module asks for.

option(MOIVRE_WITH_CVODE "Build the CVODE tracker (needs SUNDIALS)" ON)
option(MOIVRE_WITH_LANES "Build the lane tracker (needs Highway)" ON)
option(MOIVRE_WITH_MULTIPRECISION "Build the roots to many digits (needs MPFR)" ON)
option(MOIVRE_WITH_MECHANISM "Build mechanisms, and all that needs them (needs toml++)" ON)

# Takes a module out of the list, and every module that cannot do without it; cli makes do with what is there.
macro(moivre_switch_off module)
  foreach(other IN LISTS MOIVRE_MODULES)
    moivre_closure(needed ${other})
    if("${module}" IN_LIST needed AND NOT other STREQUAL "cli")
      list(REMOVE_ITEM MOIVRE_USES_cli ${other})
      list(APPEND switched_off ${other})
    endif()
  endforeach()
  list(REMOVE_ITEM MOIVRE_MODULES ${switched_off})
endmacro()

set(switches CVODE LANES MULTIPRECISION MECHANISM)
set(switched_modules tracker_cvode tracker_lanes multiprecision mechanism)
foreach(switch module IN ZIP_LISTS switches switched_modules)
  if(NOT MOIVRE_WITH_${switch})
    moivre_switch_off(${module})
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
    list(GET MOIVRE_FIND_${package} 0 name)
    list(APPEND MOIVRE_BUILT_PACKAGES "${name} ${${name}_VERSION}")
  endforeach()
endforeach()
list(REMOVE_DUPLICATES MOIVRE_BUILT_PACKAGES)
