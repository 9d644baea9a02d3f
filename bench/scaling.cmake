# SPDX-License-Identifier: MIT
# bench/scaling: wall and CPU time of tracking over the number of threads.
if(TARGET moivre_tracker_cvode AND TARGET moivre_tracker_lanes AND TARGET moivre_solver)
  add_executable(scaling scaling.cpp)
  target_link_libraries(scaling PRIVATE moivre::solver moivre::tracker_cvode moivre::tracker_lanes moivre_warnings)
  target_compile_definitions(scaling PRIVATE MOIVRE_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  if(MOIVRE_BUILD_TESTS)
    add_test(NAME "bench: scaling of katsura-5" COMMAND scaling --repeat 1 --threads 2 katsura-5)
    set_tests_properties("bench: scaling of katsura-5" PROPERTIES LABELS bench-smoke)
  endif()
endif()
