# SPDX-License-Identifier: GPL-2.0-or-later
# nanocarbon_room(<name> SOURCES <files...> [LINKS <public libraries...>] [PRIVATE_LINKS <libraries...>])
#
# A room is one folder of preprocessor/nanocarbon and one static library, nanocarbon::<name>. What it may include is
# what it links: the boundaries between rooms are those of these targets.
function(nanocarbon_room name)
  cmake_parse_arguments(ROOM "" "" "SOURCES;LINKS;PRIVATE_LINKS" ${ARGN})
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
  if(NOT "OpenMP::OpenMP_CXX" IN_LIST ROOM_PRIVATE_LINKS)  # compiled by other options than the headers
    nanocarbon_precompiled(nanocarbon_${name} nanocarbon_headers)
  endif()
  set_property(GLOBAL APPEND PROPERTY NANOCARBON_ROOMS nanocarbon_${name})
endfunction()
