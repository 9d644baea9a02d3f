# SPDX-License-Identifier: MIT
# bench/end_parameters: does a verdict hang on a number of the endgame's? Run by hand, on a folder of random systems.
find_package(nlohmann_json 3.11 QUIET)
if(TARGET moivre_tracker_lanes AND TARGET moivre_solver AND nlohmann_json_FOUND)
  add_executable(end_parameters end_parameters.cpp)
  target_link_libraries(end_parameters PRIVATE moivre::solver moivre::tracker_lanes nlohmann_json::nlohmann_json
                                               moivre_warnings)
endif()
