# SPDX-License-Identifier: MIT
# Configures, builds and runs the project in SOURCE against the package installed in PREFIX; works in SCRATCH.
#
# The program is called `stranger`. A project that holds a file `refusal` must fail to configure, with the words of that file.
cmake_minimum_required(VERSION 3.25)
file(REMOVE_RECURSE ${SCRATCH})

execute_process(
  COMMAND ${CMAKE_COMMAND} -S ${SOURCE} -B ${SCRATCH} -G ${GENERATOR} -D CMAKE_PREFIX_PATH=${PREFIX}
          -D CMAKE_CXX_COMPILER=${COMPILER} -D CMAKE_CXX_FLAGS=${FLAGS} -D CMAKE_BUILD_TYPE=${BUILD_TYPE}
          ${ARGUMENTS}
  RESULT_VARIABLE configured OUTPUT_VARIABLE output ERROR_VARIABLE output)

if(EXISTS ${SOURCE}/refusal)
  file(READ ${SOURCE}/refusal words)
  string(STRIP "${words}" words)
  string(REGEX REPLACE "[ \n]+" " " output "${output}")
  string(FIND "${output}" "${words}" position)
  if(configured EQUAL 0 OR position EQUAL -1)
    message(FATAL_ERROR "wanted a refusal with '${words}', got:\n${output}")
  endif()
  return()
endif()

if(NOT configured EQUAL 0)
  message(FATAL_ERROR "configuring failed:\n${output}")
endif()
execute_process(COMMAND ${CMAKE_COMMAND} --build ${SCRATCH} COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${SCRATCH}/stranger COMMAND_ERROR_IS_FATAL ANY)
