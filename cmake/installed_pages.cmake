# SPDX-License-Identifier: MIT
# Which documents are installed? Pages, and what they lead to.

# moivre_installed_pages(<root> <variable> <page>...): the pages, and every page and picture of the tree that a link in one of them, or in one of
# those, leads to. All relative to the root. Configuring is done again where one of them changes.
function(moivre_installed_pages root variable)
  set(found ${ARGN})
  set(waiting ${ARGN})
  while(waiting)
    list(POP_FRONT waiting page)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${root}/${page})
    # In a CMake list brackets have a meaning of their own.
    file(READ ${root}/${page} text)
    string(REGEX REPLACE "[][;]" "|" text "${text}")
    string(REGEX MATCHALL "\\|\\([^)# \n]+" links "${text}")
    foreach(link IN LISTS links)
      string(SUBSTRING "${link}" 2 -1 link)
      cmake_path(GET page PARENT_PATH folder)
      cmake_path(APPEND folder ${link} OUTPUT_VARIABLE target)
      cmake_path(NORMAL_PATH target)
      if(link MATCHES "://" OR target IN_LIST found OR NOT EXISTS ${root}/${target} OR IS_DIRECTORY ${root}/${target})
        continue()
      endif()
      list(APPEND found ${target})
      if(target MATCHES "\\.md$")
        list(APPEND waiting ${target})
      endif()
    endforeach()
  endwhile()
  set(${variable} ${found} PARENT_SCOPE)
endfunction()
