# SPDX-License-Identifier: MIT
# bench/spatial_counts: every closure of every spatial mechanism over many seeds, also with its dimensions off.
if(TARGET moivre_tracker_cvode AND TARGET moivre_tracker_lanes AND TARGET moivre_closures)
  add_executable(spatial_counts spatial_counts.cpp)
  target_link_libraries(spatial_counts PRIVATE moivre::closures moivre::tracker_cvode moivre::tracker_lanes
                                               moivre_warnings)
  target_include_directories(spatial_counts PRIVATE ${PROJECT_SOURCE_DIR}/tests/closures)
  target_compile_definitions(spatial_counts PRIVATE MOIVRE_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  if(MOIVRE_BUILD_TESTS)
    add_test(NAME "bench: closures of an RSSR, also disturbed" COMMAND spatial_counts --seeds 1 rssr)
    set_tests_properties("bench: closures of an RSSR, also disturbed" PROPERTIES LABELS bench-smoke)
  endif()
endif()
