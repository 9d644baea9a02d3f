# SPDX-License-Identifier: MIT
# Does every citation [Key] in code and prose resolve to one entry of docs/references.md?
include(${CMAKE_CURRENT_LIST_DIR}/text.cmake)

# A key is a name that begins with a capital and ends with two digits of a year; one is a product without a year.
set(key "([A-Z][A-Za-z]+[0-9][0-9]|SUNDIALS)")

read_text(references ${ROOT}/docs/references.md)
string(REGEX MATCHALL "\n- \\*\\*${open}[^${close}]+${close}" entries "${references}")
set(known "")
foreach(entry IN LISTS entries)
  string(REGEX REPLACE ".*${open}([^${close}]+)${close}" "\\1" name "${entry}")
  if(NOT name MATCHES "^${key}$")
    fault(${ROOT}/docs/references.md "'${name}' is not formed as a key")
  elseif(name IN_LIST known)
    fault(${ROOT}/docs/references.md "${name} stands twice")
  endif()
  list(APPEND known ${name})
endforeach()

foreach(file IN LISTS code_files prose_files)
  read_text(text ${file})
  string(REGEX MATCHALL "${open}${key}(, [^${close}\n]*)?${close}" citations "${text}")
  foreach(citation IN LISTS citations)
    string(REGEX MATCH "${key}" name "${citation}")
    if(NOT name IN_LIST known)
      fault(${file} "${citation} is not in docs/references.md")
    endif()
  endforeach()
endforeach()
finish()
