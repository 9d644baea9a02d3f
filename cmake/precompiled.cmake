# SPDX-License-Identifier: MIT
# moivre_precompile(<target> <carrier>): what nearly every source includes is read once, not once a source.
#
# A precompiled header serves targets of its own compiler flags only, so that there is one for each optimization level and one
# for the tests; modules with flags of their own do without. So do the presets dev and tidy
# (CMAKE_DISABLE_PRECOMPILE_HEADERS), in which every source has to include what it uses.

# Where no module wants Eigen, as expressions alone do not, it is not looked for.
set(MOIVRE_PRECOMPILED_PACKAGES Boost::headers)
set(vocabulary <boost/multiprecision/cpp_int.hpp>)
if(TARGET Eigen3::Eigen)
  list(PREPEND MOIVRE_PRECOMPILED_PACKAGES Eigen3::Eigen)
  list(PREPEND vocabulary <Eigen/Core>)
endif()

# moivre_precompiled(<carrier> OPTIONS <flag>... HEADERS <header>...): a target of an empty source, that has the header.
function(moivre_precompiled carrier)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "OPTIONS;HEADERS")
  set(source ${PROJECT_BINARY_DIR}/precompiled/${carrier}.cpp)
  file(CONFIGURE OUTPUT ${source} CONTENT "// Carries a precompiled header.\n")
  add_library(${carrier} OBJECT EXCLUDE_FROM_ALL ${source})
  target_compile_options(${carrier} PRIVATE ${arg_OPTIONS})
  target_link_libraries(${carrier} PRIVATE ${MOIVRE_PRECOMPILED_PACKAGES} moivre_warnings)
  target_precompile_headers(${carrier} PRIVATE ${vocabulary} <algorithm> <cmath>
    <complex> <functional> <map> <memory> <optional> <set> <sstream> <string> <vector> ${arg_HEADERS})
endfunction()

function(moivre_precompile target carrier)
  target_precompile_headers(${target} REUSE_FROM ${carrier})
endfunction()

# Half of the light modules write JSON.
find_package(nlohmann_json QUIET)
set(json "")
if(nlohmann_json_FOUND)
  set(json <nlohmann/json.hpp>)
endif()
moivre_precompiled(moivre_headers)
moivre_independent(moivre_headers)
moivre_precompiled(moivre_light_headers OPTIONS $<$<CONFIG:Release>:-O1> HEADERS ${json})
moivre_independent(moivre_light_headers)
