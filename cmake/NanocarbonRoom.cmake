# SPDX-License-Identifier: GPL-2.0-or-later
# nanocarbon_room(<name> [PROGRAM_ONLY] SOURCES <files...> [LINKS <public libraries...>] [PRIVATE_LINKS <libraries...>])
#
# A room is one folder of preprocessor/nanocarbon and one static library, nanocarbon::<name>. What it may include is
# what it links: the boundaries between rooms are those of these targets. A room that is PROGRAM_ONLY is not installed
# with the library: no other room may link it.
function(nanocarbon_room name)
  cmake_parse_arguments(ROOM "PROGRAM_ONLY" "" "SOURCES;LINKS;PRIVATE_LINKS" ${ARGN})
  add_library(nanocarbon_${name} STATIC ${ROOM_SOURCES})
  add_library(nanocarbon::${name} ALIAS nanocarbon_${name})
  set_target_properties(nanocarbon_${name} PROPERTIES EXPORT_NAME ${name})
  target_compile_features(nanocarbon_${name} PUBLIC cxx_std_20)
  target_include_directories(nanocarbon_${name} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/preprocessor>
    $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/generated>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_link_libraries(nanocarbon_${name} PUBLIC ${ROOM_LINKS} PRIVATE ${ROOM_PRIVATE_LINKS}
                        $<BUILD_INTERFACE:nanocarbon_settings>)
  # Compiled by other options than the headers?
  if(NOT "OpenMP::OpenMP_CXX" IN_LIST ROOM_PRIVATE_LINKS AND NOT "CGAL::CGAL" IN_LIST ROOM_PRIVATE_LINKS)
    nanocarbon_precompiled(nanocarbon_${name} nanocarbon_headers)
  endif()
  if(NOT ROOM_PROGRAM_ONLY)
    set_property(GLOBAL APPEND PROPERTY NANOCARBON_ROOMS nanocarbon_${name})
  endif()
endfunction()
