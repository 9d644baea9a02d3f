# SPDX-License-Identifier: MIT
# Headers of packages that most units read and nobody here changes, compiled once: reading them again was half of a build.
#
# A unit still names what it uses: the presets dev and tidy do without, and see a missing #include.
option(MOIVRE_PRECOMPILED_HEADERS "Compile the packages' headers once for all units" ${PROJECT_IS_TOP_LEVEL})

# moivre_precompile(<name> PACKAGES <package>... HEADERS <header>...): what moivre_reuse(<target> <name>) gives a target.
function(moivre_precompile name)
  cmake_parse_arguments(PARSE_ARGV 1 set "" "" "PACKAGES;HEADERS")
  if(NOT MOIVRE_PRECOMPILED_HEADERS)
    return()
  endif()
  file(WRITE ${PROJECT_BINARY_DIR}/precompiled_${name}.cpp "")
  add_library(moivre_precompiled_${name} OBJECT ${PROJECT_BINARY_DIR}/precompiled_${name}.cpp)
  target_link_libraries(moivre_precompiled_${name} PRIVATE ${set_PACKAGES} moivre_warnings)
  # With the warnings of those who reuse it: -Wpedantic decides what the compiler defines.
  target_compile_features(moivre_precompiled_${name} PRIVATE cxx_std_20)
  list(TRANSFORM set_HEADERS REPLACE "(.+)" "<\\1>")
  target_precompile_headers(moivre_precompiled_${name} PRIVATE ${set_HEADERS})
endfunction()

function(moivre_reuse target name)
  if(TARGET moivre_precompiled_${name})
    target_precompile_headers(${target} REUSE_FROM moivre_precompiled_${name})
  endif()
endfunction()

set(vocabulary algorithm array cmath complex cstdint functional map memory optional set span sstream stdexcept string
  string_view utility variant vector Eigen/Core boost/multiprecision/cpp_int.hpp)
moivre_precompile(library PACKAGES Eigen3::Eigen Boost::headers HEADERS ${vocabulary})
if(TARGET nlohmann_json::nlohmann_json)
  moivre_precompile(json PACKAGES Eigen3::Eigen Boost::headers nlohmann_json::nlohmann_json
    HEADERS ${vocabulary} nlohmann/json.hpp)
endif()
if(TARGET CLI11::CLI11)
  moivre_precompile(cli PACKAGES Eigen3::Eigen Boost::headers nlohmann_json::nlohmann_json CLI11::CLI11
    HEADERS ${vocabulary} nlohmann/json.hpp CLI/CLI.hpp)
endif()
