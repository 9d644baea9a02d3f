# SPDX-License-Identifier: MIT
# The shares of the hot path; bench/peers and bench/memory are scripts and need no build.
add_executable(hot_path hot_path.cpp)
target_link_libraries(hot_path PRIVATE moivre::solver moivre::tracker_cvode moivre_warnings)
if(MOIVRE_BUILD_TESTS)
  add_test(NAME bench.hot_path
    COMMAND hot_path ${PROJECT_SOURCE_DIR}/problems/polynomials/katsura-5.phc)
  set_tests_properties(bench.hot_path PROPERTIES LABELS bench-smoke)
endif()
