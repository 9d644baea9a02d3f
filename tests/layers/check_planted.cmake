# SPDX-License-Identifier: MIT
# Would check.cmake see a breach? Copies the tree to SCRATCH, plants breaches, and wants each refused by name.
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

# plant(<file> <line> <words>): appends <line> to <file> of the copy; the check has to say <words>.
set(wanted "")
function(plant file line words)
  file(APPEND ${SCRATCH}/${file} "${line}\n")
  list(APPEND wanted "${words}")
  set(wanted "${wanted}" PARENT_SCOPE)
endfunction()

# expect_refusal(): of what was planted each is refused with its words.
function(expect_refusal)
  check(result output)
  if(result EQUAL 0)
    message(FATAL_ERROR "not seen: ${wanted}")
  endif()
  foreach(words IN LISTS wanted)
    string(FIND "${output}" "${words}" position)
    if(position EQUAL -1)
      message(FATAL_ERROR "not refused with '${words}':\n${output}")
    endif()
  endforeach()
endfunction()

copy_tree()
check(result output)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "the copy without a breach is refused:\n${output}")
endif()

plant(include/moivre/numeric/planted.h "#include \"moivre/polynomial/system.h\""
      "numeric may not use polynomial")
plant(src/polynomial/planted.cpp "#include \"moivre/solver/solver.h\""
      "polynomial may not use solver")
plant(src/endgame/planted.cpp "#include \"moivre/tracker_cvode/tracker.h\""
      "endgame may not use tracker_cvode")
plant(src/check/planted.cpp "#include \"moivre/tracker/tracker.h\"" "check may not use tracker")
plant(src/check/planted.cpp "#include \"moivre/endgame/endgame.h\"" "check may not use endgame")
plant(src/check/planted.cpp "#include \"moivre/solver/solve.h\"" "check may not use solver")
plant(src/solver/planted.cpp "#include <cvode/cvode.h>" "solver does not name SUNDIALS::cvode")
plant(src/polynomial/planted.cpp "#include <tbb/parallel_for.h>"
      "polynomial does not name TBB::tbb")
plant(src/solver/planted.cpp "  #  include <nlohmann/json.hpp>"
      "solver does not name nlohmann_json::nlohmann_json")
plant(src/numeric/planted.cpp "#include <gsl/gsl_poly.h>" "a package that no module names")
plant(src/polynomial/planted.cpp "#include \"moivre/polynomial/nowhere.h\""
      "no such public header")
plant(src/polynomial/planted.cpp "#include \"../numeric/CMakeLists.txt\"" "nor a file beside this one")
plant(src/planted/planted.cpp "" "no module 'planted'")
plant(src/polynomial/planted.h "namespace moivre {\nstruct Term {\n" "Term has another definition in include/moivre")
plant(src/polynomial/planted.cpp "namespace moivre {\nenum class PathStatus { lost }" "PathStatus has another definition")
expect_refusal()

# A list that is wrong itself spoils the other answers.
copy_tree()
set(wanted "")
plant(cmake/layers.cmake "set(MOIVRE_USES_numeric solver)" "solver does not stand before numeric")
expect_refusal()
