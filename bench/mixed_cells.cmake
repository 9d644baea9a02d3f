# SPDX-License-Identifier: MIT
# bench/mixed_cells: mixed volumes of families and what their cells cost, beside PHCpack where it is installed.
if(TARGET moivre_start)
  add_executable(mixed_cells mixed_cells.cpp)
  target_link_libraries(mixed_cells PRIVATE moivre::start moivre_warnings)
  target_include_directories(mixed_cells PRIVATE ${PROJECT_SOURCE_DIR}/tests/start)
  if(MOIVRE_BUILD_TESTS)
    add_test(NAME "bench: mixed cells of cyclic-5" COMMAND mixed_cells --seeds 1 --no-peer cyclic-5)
    set_tests_properties("bench: mixed cells of cyclic-5" PROPERTIES LABELS bench-smoke)
  endif()
endif()
