# SPDX-License-Identifier: GPL-2.0-or-later
# cmake --install: the library with a package config, and the examples. (The program and the plugin install themselves.)
# Two components: "program" is what runs, "library" what a program of one's own is built with.
include(CMakePackageConfigHelpers)
include(NanocarbonPublicHeaders)

get_property(rooms GLOBAL PROPERTY NANOCARBON_ROOMS)
install(TARGETS ${rooms} EXPORT nanocarbonTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT library)
install(EXPORT nanocarbonTargets NAMESPACE nanocarbon:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/nanocarbon
        COMPONENT library)
foreach(header IN LISTS NANOCARBON_PUBLIC_HEADERS)
  get_filename_component(folder ${header} DIRECTORY)
  set(root preprocessor)
  if(header STREQUAL "core/version.h")
    set(root ${PROJECT_BINARY_DIR}/generated)
  endif()
  install(FILES ${root}/nanocarbon/${header} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/nanocarbon/${folder}
          COMPONENT library)
endforeach()
install(FILES LICENSE RENAME copyright DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/nanocarbon COMPONENT program)
install(FILES LICENSE RENAME copyright DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/libnanocarbon-dev COMPONENT library)
install(DIRECTORY examples/ DESTINATION ${CMAKE_INSTALL_DATADIR}/nanocarbon/examples COMPONENT program)

# What find_package(nanocarbon COMPONENTS <room>...) has to find for each room: the packages of all that it links, and
# of what the rooms that it links do, since all of them are static libraries.
function(nanocarbon_packages_of room result)
  set(packages "")
  get_target_property(links nanocarbon_${room} LINK_LIBRARIES)
  foreach(link ${links})
    if(link MATCHES "^nanocarbon::(.*)")
      nanocarbon_packages_of(${CMAKE_MATCH_1} found)
      list(APPEND packages ${found})
    elseif(link MATCHES "^OpenMesh")
      list(APPEND packages OpenMesh)
    elseif(link MATCHES "^(Eigen3|fmt|nlohmann_json|nanoflann|OpenMP|Threads|Spectra|TBB|ZLIB|muparser|pugixml)::")
      list(APPEND packages ${CMAKE_MATCH_1})
    elseif(NOT link MATCHES "nanocarbon_settings")
      message(FATAL_ERROR "nanocarbon::${room} links ${link}: say in cmake/NanocarbonInstall.cmake which package has it")
    endif()
  endforeach()
  list(REMOVE_DUPLICATES packages)
  set(${result} ${packages} PARENT_SCOPE)
endfunction()

set(NANOCARBON_COMPONENTS "")
set(NANOCARBON_COMPONENT_PACKAGES "")
foreach(target ${rooms})
  get_target_property(room ${target} EXPORT_NAME)
  nanocarbon_packages_of(${room} packages)
  list(APPEND NANOCARBON_COMPONENTS ${room})
  string(APPEND NANOCARBON_COMPONENT_PACKAGES "set(nanocarbon_${room}_packages ${packages})\n")
endforeach()

configure_package_config_file(cmake/nanocarbonConfig.cmake.in ${PROJECT_BINARY_DIR}/nanocarbonConfig.cmake
                              INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/nanocarbon)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/nanocarbonConfigVersion.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/nanocarbonConfig.cmake ${PROJECT_BINARY_DIR}/nanocarbonConfigVersion.cmake
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/nanocarbon COMPONENT library)
