# SPDX-License-Identifier: MIT
# bench/lane_kernels: the lanes' kernels against the FMA peak of one core. It looks into src/tracker_lanes.
if(TARGET moivre_tracker_lanes AND TARGET moivre_start)
  add_executable(lane_kernels lane_kernels.cpp)
  target_include_directories(lane_kernels PRIVATE ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/src/tracker_lanes)
  target_link_libraries(lane_kernels PRIVATE moivre::tracker_lanes moivre::start hwy::hwy moivre_warnings)
  if(MOIVRE_BUILD_TESTS)
    add_test(NAME "bench: lane kernels once"
             COMMAND lane_kernels ${PROJECT_SOURCE_DIR}/problems/polynomials/katsura-5.phc)
    set_tests_properties("bench: lane kernels once" PROPERTIES LABELS bench-smoke)
  endif()
endif()
