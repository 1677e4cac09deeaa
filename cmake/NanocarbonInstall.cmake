# SPDX-License-Identifier: GPL-2.0-or-later
# cmake --install: the program, the library with a package config, the examples. (The plugin installs itself.)
include(CMakePackageConfigHelpers)
include(NanocarbonPublicHeaders)

get_property(rooms GLOBAL PROPERTY NANOCARBON_ROOMS)
install(TARGETS ${rooms} EXPORT nanocarbonTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(EXPORT nanocarbonTargets NAMESPACE nanocarbon:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/nanocarbon)
foreach(header IN LISTS NANOCARBON_PUBLIC_HEADERS)
  get_filename_component(folder ${header} DIRECTORY)
  set(root preprocessor)
  if(header STREQUAL "core/version.h")
    set(root ${PROJECT_BINARY_DIR}/generated)
  endif()
  install(FILES ${root}/nanocarbon/${header} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/nanocarbon/${folder})
endforeach()
install(DIRECTORY examples/ DESTINATION ${CMAKE_INSTALL_DATADIR}/nanocarbon/examples)

configure_package_config_file(cmake/nanocarbonConfig.cmake.in ${PROJECT_BINARY_DIR}/nanocarbonConfig.cmake
                              INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/nanocarbon)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/nanocarbonConfigVersion.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/nanocarbonConfig.cmake ${PROJECT_BINARY_DIR}/nanocarbonConfigVersion.cmake
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/nanocarbon)
