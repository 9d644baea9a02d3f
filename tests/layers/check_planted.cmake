# SPDX-License-Identifier: MIT
# Would check.cmake see a breach? Copies the tree to SCRATCH, plants one breach after another, and wants each refused by name.
cmake_minimum_required(VERSION 3.25)

function(copy_tree)
  file(REMOVE_RECURSE ${SCRATCH})
  file(COPY ${ROOT}/include ${ROOT}/src ${ROOT}/cmake DESTINATION ${SCRATCH})
endfunction()

function(check result_variable output_variable)
  execute_process(
    COMMAND ${CMAKE_COMMAND} -D ROOT=${SCRATCH} -P ${CMAKE_CURRENT_LIST_DIR}/check.cmake
    RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  set(${result_variable} ${result} PARENT_SCOPE)
  set(${output_variable} "${output}" PARENT_SCOPE)
endfunction()

# expect_refusal(<file> <line> <words>): with <line> appended to <file>, the check fails and says <words>.
function(expect_refusal file line words)
  copy_tree()
  file(APPEND ${SCRATCH}/${file} "${line}\n")
  check(result output)
  if(result EQUAL 0)
    message(FATAL_ERROR "not seen: '${line}' in ${file}")
  endif()
  string(FIND "${output}" "${words}" position)
  if(position EQUAL -1)
    message(FATAL_ERROR "'${line}' in ${file} was refused, but not with '${words}':\n${output}")
  endif()
endfunction()

copy_tree()
check(result output)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "the copy without a breach is refused:\n${output}")
endif()

expect_refusal(include/moivre/numeric/planted.h "#include \"moivre/polynomial/system.h\""
               "numeric may not use polynomial")
expect_refusal(src/polynomial/planted.cpp "#include \"moivre/solver/solver.h\""
               "polynomial may not use solver")
expect_refusal(src/endgame/planted.cpp "#include \"moivre/tracker_cvode/tracker.h\""
               "endgame may not use tracker_cvode")
expect_refusal(src/check/planted.cpp "#include \"moivre/tracker/tracker.h\"" "check may not use tracker")
expect_refusal(src/check/planted.cpp "#include \"moivre/endgame/endgame.h\"" "check may not use endgame")
expect_refusal(src/check/planted.cpp "#include \"moivre/solver/solve.h\"" "check may not use solver")
expect_refusal(src/solver/planted.cpp "#include <cvode/cvode.h>" "solver does not name SUNDIALS::cvode")
expect_refusal(src/polynomial/planted.cpp "#include <tbb/parallel_for.h>"
               "polynomial does not name TBB::tbb")
expect_refusal(src/solver/planted.cpp "  #  include <nlohmann/json.hpp>"
               "solver does not name nlohmann_json::nlohmann_json")
expect_refusal(src/numeric/planted.cpp "#include <gsl/gsl_poly.h>" "a package that no module names")
expect_refusal(src/polynomial/planted.cpp "#include \"moivre/polynomial/nowhere.h\""
               "no such public header")
expect_refusal(src/polynomial/planted.cpp "#include \"../numeric/CMakeLists.txt\"" "nor a file beside this one")
expect_refusal(src/planted/planted.cpp "" "no module 'planted'")
expect_refusal(cmake/layers.cmake "set(MOIVRE_USES_numeric solver)" "solver does not stand before numeric")
expect_refusal(src/polynomial/planted.h "namespace moivre {\nstruct Term {\n" "Term has another definition in include/moivre")
expect_refusal(src/polynomial/planted.cpp "namespace moivre {\nenum class PathStatus { lost }" "PathStatus has another definition")
