# SPDX-License-Identifier: MIT
# bench/honesty: is the reported accuracy true? A short run is a test, the whole problem set has the label full-long.
find_package(nlohmann_json 3.11 QUIET)
if(TARGET moivre_multiprecision AND TARGET moivre_tracker_cvode AND TARGET moivre_tracker_lanes AND TARGET moivre_solver
   AND nlohmann_json_FOUND)
  add_executable(honesty honesty.cpp)
  target_link_libraries(honesty PRIVATE moivre::solver moivre::multiprecision moivre::tracker_cvode moivre::tracker_lanes
                                        nlohmann_json::nlohmann_json moivre_warnings)
  target_include_directories(honesty PRIVATE ${PROJECT_SOURCE_DIR}/tests/problems)
  target_compile_definitions(honesty PRIVATE MOIVRE_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  if(MOIVRE_BUILD_TESTS)
    add_test(NAME "bench: reported accuracies are true" COMMAND honesty --seeds 1 --paths 40)
    set_tests_properties("bench: reported accuracies are true" PROPERTIES LABELS bench-smoke)
    add_test(NAME "bench: reported accuracies are true on the whole set" COMMAND honesty)
    set_tests_properties("bench: reported accuracies are true on the whole set" PROPERTIES LABELS full-long TIMEOUT 7200)
  endif()
endif()
