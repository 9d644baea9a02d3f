# SPDX-License-Identifier: MIT
# bench/family: what a member of a family costs, many at once.
if(TARGET moivre_tracker_lanes AND TARGET moivre_family)
  add_executable(family_members family.cpp)
  target_link_libraries(family_members PRIVATE moivre::family moivre::tracker_lanes moivre_warnings)
  target_include_directories(family_members PRIVATE ${PROJECT_SOURCE_DIR}/tests/family)
  target_compile_definitions(family_members PRIVATE MOIVRE_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  if(MOIVRE_BUILD_TESTS)
    add_test(NAME "bench: members of families, a few" COMMAND family_members --members 20)
    set_tests_properties("bench: members of families, a few" PROPERTIES LABELS bench-smoke)
  endif()
endif()
