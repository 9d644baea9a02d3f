# SPDX-License-Identifier: MIT
# bench/random_linkages: closures of random linkages, judged by Newton's method.
if(TARGET moivre_tracker_cvode AND TARGET moivre_tracker_lanes AND TARGET moivre_closures)
  add_executable(random_linkages random_linkages.cpp)
  target_link_libraries(random_linkages PRIVATE moivre::closures moivre::tracker_cvode moivre::tracker_lanes
                                               moivre_warnings)
  target_include_directories(random_linkages PRIVATE ${PROJECT_SOURCE_DIR}/tests/closures)
  if(MOIVRE_BUILD_TESTS)
    add_test(NAME "bench: closures of three random linkages" COMMAND random_linkages --count 3)
    set_tests_properties("bench: closures of three random linkages" PROPERTIES LABELS bench-smoke)
  endif()
endif()
