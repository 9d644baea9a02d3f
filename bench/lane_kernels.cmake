# SPDX-License-Identifier: MIT
# bench/lane_kernels: the lanes' kernels against the FMA peak of one core. It looks into src/tracker_lanes.
if(TARGET moivre_tracker_lanes AND TARGET moivre_start)
  add_executable(lane_kernels lane_kernels.cpp)
  target_include_directories(lane_kernels PRIVATE ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/src/tracker_lanes)
  target_link_libraries(lane_kernels PRIVATE moivre::tracker_lanes moivre::start hwy::hwy moivre_warnings)
  # The same kernels compiled for this machine alone, to compare with what run-time dispatch chooses.
  include(CheckCXXCompilerFlag)
  check_cxx_compiler_flag(-march=native MOIVRE_HAS_MARCH_NATIVE)
  if(MOIVRE_HAS_MARCH_NATIVE)
    add_executable(lane_kernels_native lane_kernels.cpp)
    target_compile_options(lane_kernels_native PRIVATE -march=native)
    target_compile_definitions(lane_kernels_native PRIVATE HWY_COMPILE_ONLY_STATIC)
    target_include_directories(lane_kernels_native PRIVATE ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/src/tracker_lanes)
    target_link_libraries(lane_kernels_native PRIVATE moivre::tracker_lanes moivre::start hwy::hwy moivre_warnings)
  endif()
  if(MOIVRE_BUILD_TESTS)
    add_test(NAME "bench: lane kernels once"
             COMMAND lane_kernels ${PROJECT_SOURCE_DIR}/problems/polynomials/katsura-5.phc)
    set_tests_properties("bench: lane kernels once" PROPERTIES LABELS bench-smoke)
  endif()
endif()
