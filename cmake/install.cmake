# SPDX-License-Identifier: MIT
# What `cmake --install` lays down: each module's library and headers, the command, a package for find_package(moivre), and one for
# pkg-config.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/moivre)

# One export a module, so that a consumer meets the packages of the components it asked for and no others.
set(installed_modules ${MOIVRE_BUILT_MODULES})
list(REMOVE_ITEM installed_modules ${MOIVRE_OF_PROGRAMS})
foreach(module IN LISTS installed_modules)
  install(TARGETS moivre_${module} EXPORT moivre_${module}
    LIBRARY COMPONENT library NAMELINK_COMPONENT development ARCHIVE COMPONENT development
    FILE_SET HEADERS COMPONENT development)
  install(EXPORT moivre_${module} DESTINATION ${package_dir} NAMESPACE moivre::
          FILE moivre_${module}.cmake COMPONENT development)
endforeach()
# All of it by one header.
install(FILES ${PROJECT_SOURCE_DIR}/include/moivre/moivre.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/moivre
  COMPONENT development)
if(TARGET moivre)
  install(TARGETS moivre COMPONENT program)
  if(TARGET moivre_mpi)
    install(TARGETS moivre_mpi COMPONENT program)
  endif()
  # What one reads, as it stands in the source tree, so that links between pages hold; and what one tries first.
  include(${CMAKE_CURRENT_LIST_DIR}/installed_pages.cmake)
  file(GLOB pages CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/docs/*.md)
  list(FILTER pages EXCLUDE REGEX "/(walkthrough|notation|seed-pages|gallery)\\.md$")
  moivre_installed_pages(${PROJECT_SOURCE_DIR} pages README.md ${pages})
  foreach(page IN LISTS pages)
    cmake_path(GET page PARENT_PATH folder)
    install(FILES ${PROJECT_SOURCE_DIR}/${page} DESTINATION ${CMAKE_INSTALL_DOCDIR}/${folder} COMPONENT program)
  endforeach()
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs/schema DESTINATION ${CMAKE_INSTALL_DOCDIR}/docs COMPONENT program)
  set(problems ${PROJECT_SOURCE_DIR}/problems)
  install(FILES ${problems}/polynomials/puma.phc ${problems}/polynomials/cassou.phc ${problems}/mechanisms/four-bar.toml
    ${problems}/robots/puma560.urdf ${problems}/robots/ur5.urdf
    DESTINATION ${CMAKE_INSTALL_DOCDIR}/examples COMPONENT program)
endif()

configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/moivreConfig.cmake.in
  ${PROJECT_BINARY_DIR}/moivreConfig.cmake INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/moivreConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/moivreConfig.cmake ${PROJECT_BINARY_DIR}/moivreConfigVersion.cmake
  ${CMAKE_CURRENT_LIST_DIR}/layers.cmake ${CMAKE_CURRENT_LIST_DIR}/FindMPFR.cmake ${CMAKE_CURRENT_LIST_DIR}/FindArb.cmake
  DESTINATION ${package_dir} COMPONENT development)
include(${CMAKE_CURRENT_LIST_DIR}/pkg_config.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/packages_of_debian.cmake)

# All that is laid down, without the tests.
add_custom_target(moivre_to_install)
list(TRANSFORM installed_modules PREPEND moivre_ OUTPUT_VARIABLE to_build)
foreach(target IN LISTS to_build ITEMS moivre moivre_mpi moivre_share moivre_python)
  if(TARGET ${target})
    add_dependencies(moivre_to_install ${target})
  endif()
endforeach()
