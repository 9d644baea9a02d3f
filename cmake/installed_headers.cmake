# SPDX-License-Identifier: MIT
# Which headers does an outsider see? moivre/moivre.h, and those that it names, one by one (decision 100). What only modules share is not
# installed. tests/layers sees that they include no others, and that they stay few.

# moivre_installed_headers(<root> <variable>): their names, as they are included. Configuring is done again where the list changes.
function(moivre_installed_headers root variable)
  set(all ${root}/include/moivre/moivre.h)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${all})
  file(STRINGS ${all} lines REGEX "^#include \"moivre/")
  list(TRANSFORM lines REPLACE "^#include \"(.*)\"$" "\\1")
  set(${variable} moivre/moivre.h ${lines} PARENT_SCOPE)
endfunction()
