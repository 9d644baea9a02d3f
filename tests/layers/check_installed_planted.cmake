# SPDX-License-Identifier: MIT
# Would check_installed.cmake see a header that is installed by mistake? Copies what it reads to SCRATCH, plants breaches, and wants each
# refused by name.
cmake_minimum_required(VERSION 3.25)

function(copy_tree)
  file(REMOVE_RECURSE ${SCRATCH})
  file(COPY ${ROOT}/include ${ROOT}/examples ${ROOT}/cmake DESTINATION ${SCRATCH})
  file(COPY ${ROOT}/docs/library.md DESTINATION ${SCRATCH}/docs)
endfunction()

# expect(<words> [<prefix>]): the check refuses the copy with these words; without words it refuses nothing.
function(expect words)
  set(prefix "")
  if(ARGN)
    set(prefix -D PREFIX=${ARGN})
  endif()
  execute_process(
    COMMAND ${CMAKE_COMMAND} -D ROOT=${SCRATCH} ${prefix} -P ${CMAKE_CURRENT_LIST_DIR}/check_installed.cmake
    RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  string(FIND "${output}" "${words}" position)
  if(words STREQUAL "" AND NOT result EQUAL 0)
    message(FATAL_ERROR "refused without a breach:\n${output}")
  elseif(NOT words STREQUAL "" AND (result EQUAL 0 OR position EQUAL -1))
    message(FATAL_ERROR "not refused with '${words}':\n${output}")
  endif()
endfunction()

copy_tree()
expect("")

# A public header that takes in one that only modules share.
file(APPEND ${SCRATCH}/include/moivre/solver/solve.h "#include \"moivre/start/choose_start.h\"\n")
expect("moivre/solver/solve.h: includes moivre/start/choose_start.h, which moivre.h does not name")

# It is named, too: then there are too many, and what it includes is not named.
file(APPEND ${SCRATCH}/include/moivre/moivre.h "#include \"moivre/start/choose_start.h\"\n")
expect("moivre/start/choose_start.h: includes moivre/start/mixed_cells.h")
expect("more than 60")

copy_tree()
file(APPEND ${SCRATCH}/docs/library.md "`moivre/report/json.h`\n")
expect("docs/library.md: shows moivre/report/json.h")

copy_tree()
file(APPEND ${SCRATCH}/include/moivre/moivre.h "#include \"moivre/version.h\"\n")
expect("moivre.h names a header twice")

# An installation with one header more, and with one less.
copy_tree()
include(${SCRATCH}/cmake/installed_headers.cmake)
moivre_installed_headers(${SCRATCH} named)
set(prefix ${SCRATCH}/prefix)
foreach(header IN LISTS named)
  file(WRITE ${prefix}/include/${header} "")
endforeach()
expect("" ${prefix})
file(WRITE ${prefix}/include/moivre/report/json.h "")
expect("moivre/report/json.h: laid down, and not named" ${prefix})
file(REMOVE ${prefix}/include/moivre/report/json.h ${prefix}/include/moivre/version.h)
expect("moivre/version.h: named by moivre.h, and not laid down" ${prefix})
