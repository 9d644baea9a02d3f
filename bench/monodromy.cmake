# SPDX-License-Identifier: MIT
# bench/monodromy: do loops find the published numbers of roots, with every seed?
if(TARGET moivre_tracker_lanes AND TARGET moivre_family)
  add_executable(monodromy monodromy.cpp)
  target_link_libraries(monodromy PRIVATE moivre::family moivre::tracker_lanes moivre_warnings)
  target_include_directories(monodromy PRIVATE ${PROJECT_SOURCE_DIR}/tests/family)
  target_compile_definitions(monodromy PRIVATE MOIVRE_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  if(MOIVRE_BUILD_TESTS)
    add_test(NAME "bench: roots by loops, one seed" COMMAND monodromy --seeds 1 four-bar 6R seven-link-14)
    set_tests_properties("bench: roots by loops, one seed" PROPERTIES LABELS bench-smoke)
  endif()
endif()
