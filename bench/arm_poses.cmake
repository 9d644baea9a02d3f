# SPDX-License-Identifier: MIT
# bench/arm_poses: does inverse kinematics miss anything in a thousand poses, and what does a pose take?
if(TARGET moivre_tracker_lanes AND TARGET moivre_arms)
  add_executable(arm_poses arm_poses.cpp)
  target_link_libraries(arm_poses PRIVATE moivre::arms moivre::tracker_lanes moivre_warnings)
  target_include_directories(arm_poses PRIVATE ${PROJECT_SOURCE_DIR}/tests/arms ${PROJECT_SOURCE_DIR}/src/arms)
  target_compile_definitions(arm_poses PRIVATE MOIVRE_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  if(MOIVRE_BUILD_TESTS)
    add_test(NAME "bench: poses of arms, a few" COMMAND arm_poses --poses 8 --hunted 1 --starts 20)
    set_tests_properties("bench: poses of arms, a few" PROPERTIES LABELS bench-smoke)
  endif()
endif()
