# SPDX-License-Identifier: MIT
# bench/closure_counts: every closure of every mechanism over many seeds, by both trackers.
if(TARGET moivre_tracker_cvode AND TARGET moivre_tracker_lanes AND TARGET moivre_closures)
  add_executable(closure_counts closure_counts.cpp)
  target_link_libraries(closure_counts PRIVATE moivre::closures moivre::tracker_cvode moivre::tracker_lanes
                                               moivre_warnings)
  target_include_directories(closure_counts PRIVATE ${PROJECT_SOURCE_DIR}/tests/closures)
  target_compile_definitions(closure_counts PRIVATE MOIVRE_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  if(MOIVRE_BUILD_TESTS)
    add_test(NAME "bench: closures of a four-bar once" COMMAND closure_counts --seeds 1 four-bar)
    set_tests_properties("bench: closures of a four-bar once" PROPERTIES LABELS bench-smoke)
  endif()
endif()
