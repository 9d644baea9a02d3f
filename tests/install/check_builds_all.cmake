# SPDX-License-Identifier: MIT
# Does the target moivre_to_install build every file of the build folder BUILD that `cmake --install` lays down? Nothing is built: NINJA is asked.
cmake_minimum_required(VERSION 3.25)

# Every file that is built stands as a word in the command that builds it.
execute_process(COMMAND ${NINJA} -C ${BUILD} -t commands moivre_to_install OUTPUT_VARIABLE built COMMAND_ERROR_IS_FATAL ANY)
string(REPLACE "${BUILD}/" "" built "${built}")
string(REGEX REPLACE "[][]" "|" built "${built}")
string(REGEX REPLACE "[; \n]+" ";" built "${built}")
list(REMOVE_DUPLICATES built)

# What the scripts of the installation name, without what was written as the build was configured.
file(GLOB_RECURSE scripts ${BUILD}/cmake_install.cmake)
list(FILTER scripts INCLUDE REGEX "^${BUILD}/(|src/.*|python/)cmake_install\\.cmake$")
set(laid_down "")
foreach(script IN LISTS scripts)
  file(STRINGS ${script} lines REGEX "file\\(INSTALL .* FILES ")
  string(REGEX MATCHALL "\"${BUILD}/(src|bin|share|python)/[^\"]*\"" files "${lines}")
  list(APPEND laid_down ${files})
endforeach()
string(REGEX REPLACE "\"${BUILD}/([^\"]*)\"" "\\1" laid_down "${laid_down}")

# Of the folder share its stamp is built.
list(TRANSFORM laid_down REPLACE "^share/$" "share/made")
list(LENGTH laid_down count)
list(REMOVE_ITEM laid_down ${built})
if(count LESS 2 OR laid_down)
  list(JOIN laid_down "\n  " missing)
  message(FATAL_ERROR "${count} files are laid down; moivre_to_install does not build\n  ${missing}")
endif()
