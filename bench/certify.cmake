# SPDX-License-Identifier: MIT
# bench/certify: what a certificate costs, in double and in more digits.
if(TARGET moivre_certify)
  add_executable(bench_certify certify.cpp)
  target_link_libraries(bench_certify PRIVATE moivre::certify moivre_warnings)
  if(MOIVRE_BUILD_TESTS)
    add_test(NAME "bench: certificates of one file" COMMAND bench_certify ${PROJECT_SOURCE_DIR}/problems/polynomials/katsura-5.phc)
    set_tests_properties("bench: certificates of one file" PROPERTIES LABELS bench-smoke)
  endif()
endif()
