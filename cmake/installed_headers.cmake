# SPDX-License-Identifier: MIT
# Which headers does an outsider see? moivre/moivre.h, those that docs/library.md names, and what these include. What only modules share is not
# installed.

# moivre_installed_headers(<root> <variable>): their names, as they are included. Configuring is done again where one of them changes.
function(moivre_installed_headers root variable)
  set(page ${root}/docs/library.md)
  file(STRINGS ${page} lines REGEX "moivre/")
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${page})
  string(REGEX MATCHALL "moivre/[a-z_]+/[a-z_]+\\.h" waiting "${lines}")
  set(found)
  list(APPEND waiting moivre/moivre.h)
  while(waiting)
    list(POP_FRONT waiting header)
    if(header IN_LIST found)
      continue()
    endif()
    list(APPEND found ${header})
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${root}/include/${header})
    file(STRINGS ${root}/include/${header} lines REGEX "^#include \"moivre/")
    string(REGEX MATCHALL "moivre/[a-z_/]+\\.h" included "${lines}")
    list(APPEND waiting ${included})
  endwhile()
  set(${variable} ${found} PARENT_SCOPE)
endfunction()
