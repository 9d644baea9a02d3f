# SPDX-License-Identifier: MIT
# Are shared libraries built and installed by the names that their users look for? Builds COMPONENTS of ROOT in SCRATCH, installs them to PREFIX.
#
# A few modules are enough: cmake/module.cmake has one rule for all. Nothing is optimized, since only the linker is asked.
cmake_minimum_required(VERSION 3.25)
file(REMOVE_RECURSE ${SCRATCH} ${PREFIX})

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "${command}\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

run(${CMAKE_COMMAND} -S ${ROOT} -B ${SCRATCH} -G ${GENERATOR} -D CMAKE_CXX_COMPILER=${COMPILER} -D CMAKE_CXX_FLAGS=${FLAGS}
    -D CMAKE_BUILD_TYPE=Debug -D CMAKE_CXX_FLAGS_DEBUG=-O0 -D BUILD_SHARED_LIBS=ON -D MOIVRE_COMPONENTS=${COMPONENTS}
    -D CMAKE_DISABLE_PRECOMPILE_HEADERS=ON -D MOIVRE_BUILD_TESTS=OFF -D MOIVRE_WARNINGS_AS_ERRORS=OFF)
run(${CMAKE_COMMAND} --build ${SCRATCH})
run(${CMAKE_COMMAND} --install ${SCRATCH} --prefix ${PREFIX})

# libmoivre_polynomial.so -> .so.0.1 -> .so.0.1.0: the first for the linker, the second for programs that are linked.
string(REGEX MATCH "^[0-9]+\\.[0-9]+" interface ${VERSION})
file(GLOB_RECURSE libraries ${PREFIX}/*.so)
if(NOT libraries)
  message(FATAL_ERROR "no shared library below ${PREFIX}")
endif()
foreach(library IN LISTS libraries)
  get_filename_component(name ${library} NAME)
  foreach(link target IN ZIP_LISTS "${library};${library}.${interface}" "${name}.${interface};${name}.${VERSION}")
    file(READ_SYMLINK ${link} found)
    if(NOT found STREQUAL target)
      message(FATAL_ERROR "${link} leads to ${found}, not to ${target}")
    endif()
  endforeach()
  file(READ_ELF ${library} RUNPATH runpath RPATH rpath)
  if(NOT "${runpath}${rpath}" STREQUAL "$ORIGIN")
    message(FATAL_ERROR "${name} looks for its neighbours in '${runpath}${rpath}', not beside itself")
  endif()
endforeach()
