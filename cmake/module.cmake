# SPDX-License-Identifier: MIT
# moivre_module(<name> <source>...): one library a module, linked and installed as cmake/layers.cmake says. Static, or shared where
# BUILD_SHARED_LIBS says so (decision 64).

function(moivre_module name)
  set(sources ${ARGN})
  if(sources)
    add_library(moivre_${name} ${sources})
    set(scope PUBLIC)
    moivre_independent(moivre_${name})
    # Below 1.0 a minor version may change the interface.
    set_target_properties(moivre_${name} PROPERTIES
      VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}
      INSTALL_RPATH "$ORIGIN" DEFINE_SYMBOL "")
    target_link_libraries(moivre_${name} PRIVATE $<BUILD_INTERFACE:moivre_warnings>)
  else()
    add_library(moivre_${name} INTERFACE)
    set(scope INTERFACE)
  endif()
  add_library(moivre::${name} ALIAS moivre_${name})
  set_target_properties(moivre_${name} PROPERTIES EXPORT_NAME ${name})
  target_compile_features(moivre_${name} ${scope} cxx_std_20)
  set(headers moivre_headers)
  if(name IN_LIST MOIVRE_LIGHT)
    target_compile_options(moivre_${name} PRIVATE $<$<CONFIG:Release>:-O1>)
    set(headers moivre_light_headers)
  endif()
  if(COMMAND moivre_precompile AND sources AND NOT name IN_LIST MOIVRE_OWN_FLAGS)
    moivre_precompile(moivre_${name} ${headers})
  endif()
  set(linked ${MOIVRE_USES_${name}})
  list(REMOVE_ITEM linked ${MOIVRE_OF_PROGRAMS})
  foreach(used IN LISTS linked)
    target_link_libraries(moivre_${name} ${scope} moivre::${used})
  endforeach()
  moivre_link_packages(${name} ${scope})
  moivre_module_headers(${name} ${scope})
endfunction()

# moivre_independent(<target>): code that may stand in a shared object, also where its library is static. A function calls its
# neighbours directly: nobody puts functions of his own in the place of ours, and GCC would not inline what could be replaced.
function(moivre_independent target)
  set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  target_compile_options(${target} PRIVATE -fno-semantic-interposition)
endfunction()

# moivre_alone(<source>...): compiled alone where the other sources of a target are compiled together (CMAKE_UNITY_BUILD), since
# they name something of their own as a neighbour does, or since a test counts calls into them at the linker.
function(moivre_alone)
  set_source_files_properties(${ARGN} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()

# Vocabulary is passed on to those who link the module; of what else is header-only nothing but its headers is used.
function(moivre_link_packages name scope)
  foreach(package IN LISTS MOIVRE_THIRD_PARTY_${name})
    set(reach PRIVATE)
    if(package IN_LIST MOIVRE_VOCABULARY OR scope STREQUAL "INTERFACE")
      set(reach ${scope})
    endif()
    if(package IN_LIST MOIVRE_HEADER_ONLY AND NOT package IN_LIST MOIVRE_VOCABULARY)
      target_include_directories(moivre_${name} SYSTEM PRIVATE
        $<BUILD_INTERFACE:$<TARGET_PROPERTY:${package},INTERFACE_INCLUDE_DIRECTORIES>>)
      continue()
    endif()
    target_link_libraries(moivre_${name} ${reach} ${package})
  endforeach()
endfunction()

# The headers of a module are the files of include/moivre/<name>: the folder is the list. Those of MOIVRE_INSTALLED_HEADERS are installed; of the
# others it is verified, where that is asked for, that each compiles alone.
function(moivre_module_headers name scope)
  set(base ${PROJECT_SOURCE_DIR}/include)
  file(GLOB headers CONFIGURE_DEPENDS ${base}/moivre/${name}/*.h)
  if(name STREQUAL "numeric")
    list(APPEND headers ${base}/moivre/version.h)
  endif()
  set(installed "")
  set(shared "")
  foreach(header IN LISTS headers)
    cmake_path(RELATIVE_PATH header BASE_DIRECTORY ${base} OUTPUT_VARIABLE included)
    if(included IN_LIST MOIVRE_INSTALLED_HEADERS)
      list(APPEND installed ${header})
    else()
      list(APPEND shared ${header})
    endif()
  endforeach()
  target_sources(moivre_${name} ${scope} FILE_SET HEADERS BASE_DIRS ${base} FILES ${installed})
  if(CMAKE_VERIFY_INTERFACE_HEADER_SETS AND shared)
    add_library(moivre_${name}_shared_headers INTERFACE)
    target_link_libraries(moivre_${name}_shared_headers INTERFACE moivre_${name})
    target_sources(moivre_${name}_shared_headers INTERFACE FILE_SET HEADERS BASE_DIRS ${base} FILES ${shared})
  endif()
endfunction()
