# SPDX-License-Identifier: MIT
# bench/root_counts: every root over many seeds. Its test has the label full-long.
find_package(nlohmann_json 3.11 QUIET)
if(TARGET moivre_tracker_cvode AND TARGET moivre_tracker_lanes AND TARGET moivre_solver AND nlohmann_json_FOUND)
  add_executable(root_counts root_counts.cpp)
  target_link_libraries(root_counts PRIVATE moivre::solver moivre::tracker_cvode moivre::tracker_lanes
                                            nlohmann_json::nlohmann_json moivre_warnings)
  target_include_directories(root_counts PRIVATE ${PROJECT_SOURCE_DIR}/tests/problems)
  target_compile_definitions(root_counts PRIVATE MOIVRE_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  if(MOIVRE_BUILD_TESTS)
    add_test(NAME "bench: katsura-6 once" COMMAND root_counts --seeds 1 --tracker lanes katsura-6)
    set_tests_properties("bench: katsura-6 once" PROPERTIES LABELS bench-smoke)
    add_test(NAME "bench: every root over twenty seeds" COMMAND root_counts)
    set_tests_properties("bench: every root over twenty seeds" PROPERTIES LABELS full-long TIMEOUT 7200)
  endif()
endif()
