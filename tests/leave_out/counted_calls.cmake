# SPDX-License-Identifier: MIT
# How does the linker come to count? --wrap=f sends calls of f to __wrap_f, and those of __real_f to f. For every Counted<&f> of
# counted_calls.h in the object files, call() gets the first of these names and real() the second. No source can give them without writing the
# linker's name of f: the object files have it beside the one as written.
#
#   cmake -DNM=<program> -DOBJCOPY=<program> "-DOBJECTS=<file>;..." -DOPTIONS=<file to write> -P counted_calls.cmake
# Renames within the object files, and writes options for the linker, as a compiler takes them. What was renamed before stays so.
cmake_minimum_required(VERSION 3.25)

set(as_linked --no-sort)
set(as_written --no-sort --demangle)
foreach(form IN ITEMS linked written)
  execute_process(COMMAND ${NM} ${as_${form}} ${OBJECTS} OUTPUT_VARIABLE lines COMMAND_ERROR_IS_FATAL ANY)
  # In a CMake list brackets and semicolons have a meaning of their own.
  string(REGEX REPLACE "[][;]" "|" lines "${lines}")
  string(REGEX MATCHALL "[^\n]+" ${form} "${lines}")
endforeach()

# Of each member of a Counted, and of each function that the objects only use: the linker's name, and the written one.
set(options "")
foreach(linked written IN ZIP_LISTS linked written)
  string(REGEX MATCH "[^ ]+$" symbol "${linked}")
  if(written MATCHES "moivre::test::Counted<&.*>::(call|real)[(|]")
    list(APPEND member_symbols ${symbol})
    list(APPEND member_names "${written}")
  elseif(symbol MATCHES "^__wrap_(.+)$")
    string(APPEND options "-Wl,--wrap=${CMAKE_MATCH_1}\n")
  elseif(written MATCHES " U (.+)$")
    list(APPEND function_symbols ${symbol})
    list(APPEND function_names "${CMAKE_MATCH_1}")
  endif()
endforeach()

set(renamings "")
foreach(member name IN ZIP_LISTS member_symbols member_names)
  set(found "")
  foreach(function written IN ZIP_LISTS function_symbols function_names)
    # A template's argument is written with its parameters or without.
    string(REGEX REPLACE "\\(.*$" "" bare "${written}")
    foreach(argument IN ITEMS "(${written})" "${written}" "${bare}")
      string(FIND "${name}" "::Counted<&${argument}, " place)
      if(NOT place EQUAL -1)
        list(APPEND found ${function})
        break()
      endif()
    endforeach()
  endforeach()
  list(LENGTH found count)
  if(NOT count EQUAL 1)
    message(FATAL_ERROR "not one but ${count} functions may be meant by ${name}: ${found}")
  endif()
  if(name MATCHES ">::call[(|]")
    list(APPEND renamings --redefine-sym ${member}=__wrap_${found})
    string(APPEND options "-Wl,--wrap=${found}\n")
  else()
    list(APPEND renamings --redefine-sym ${member}=__real_${found})
  endif()
endforeach()
if(renamings)
  # Where an object is newer than its compilation, Ninja compiles it again.
  foreach(object IN LISTS OBJECTS)
    execute_process(COMMAND ${OBJCOPY} --preserve-dates ${renamings} ${object} COMMAND_ERROR_IS_FATAL ANY)
  endforeach()
endif()
file(WRITE ${OPTIONS} "${options}")
