# SPDX-License-Identifier: MIT
# What does Debian want in each package besides the files of the build? cpack runs this before it packs: copyright, changelog, and man
# pages compressed. The time is that of SOURCE_DATE_EPOCH, where it is set.

set(root ${CMAKE_CURRENT_LIST_DIR}/..)
find_program(GZIP gzip REQUIRED)

# Lines of a paragraph begin with a space, and an empty one is a point.
file(READ ${root}/LICENSE license)
string(REGEX REPLACE "^MIT License\n+Copyright \\(c\\) ([^\n]*)\n+" "" license "${license}")
set(holder "${CMAKE_MATCH_1}")
string(STRIP "${license}" license)
string(REPLACE "\n" "\n " license "${license}")
string(REGEX REPLACE "\n +\n" "\n .\n" license "${license}")
set(copyright "Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/
Upstream-Name: Moivre

Files: *
Copyright: ${holder}
License: Expat
 ${license}
")

string(TIMESTAMP time "%a, %d %b %Y %H:%M:%S +0000" UTC)
set(changelog "moivre (${CPACK_PACKAGE_VERSION}) unstable; urgency=medium

  * See CHANGELOG.md of the sources.

 -- ${CPACK_PACKAGE_CONTACT}  ${time}
")

foreach(component IN LISTS CPACK_COMPONENTS_ALL)
  string(TOUPPER ${component} name)
  set(staged ${CPACK_TEMPORARY_DIRECTORY}/${component}${CPACK_PACKAGING_INSTALL_PREFIX})
  set(folder ${staged}/share/doc/${CPACK_DEBIAN_${name}_PACKAGE_NAME})
  file(WRITE ${folder}/copyright "${copyright}")
  file(WRITE ${folder}/changelog "${changelog}")
  file(GLOB pages ${staged}/share/man/man1/*.1)
  execute_process(COMMAND ${GZIP} -9nf ${folder}/changelog ${pages} COMMAND_ERROR_IS_FATAL ANY)
endforeach()
