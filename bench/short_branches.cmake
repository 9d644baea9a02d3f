# SPDX-License-Identifier: MIT
# bench/short_branches: does a motion find branches that live for a moment only?
if(TARGET moivre_tracker_cvode AND TARGET moivre_tracker_lanes AND TARGET moivre_motion)
  add_executable(short_branches short_branches.cpp)
  target_link_libraries(short_branches PRIVATE moivre::motion moivre::report moivre::tracker_cvode
                                               moivre::tracker_lanes moivre_warnings)
  target_include_directories(short_branches PRIVATE ${PROJECT_SOURCE_DIR}/tests/motion ${PROJECT_SOURCE_DIR}/tests/closures)
  target_compile_definitions(short_branches PRIVATE MOIVRE_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  if(MOIVRE_BUILD_TESTS)
    add_test(NAME "bench: three short branches" COMMAND short_branches --count 1 --share 1e-3 --share 1e-5)
    set_tests_properties("bench: three short branches" PROPERTIES LABELS bench-smoke)
  endif()
endif()
