# SPDX-License-Identifier: GPL-2.0-or-later
# cpack in the build folder: a package of Debian with the program, the plugin, its host, manual pages and completion, and
# one, -dev, with the library to build with. What they depend on is read off what they link.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME nanocarbon)
set(CPACK_PACKAGE_CONTACT "the nanocarbon authors <nanocarbon@example.org>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL program library)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME nanocarbon)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS "lammps-data")  # CH.rebo, the parameters of pair_style rebo
set(CPACK_COMPONENT_PROGRAM_DESCRIPTION
"Turns a triangle mesh into a molecule of sp2 carbon that stays whole under
 REBO2 molecular dynamics. With a plugin for LAMMPS that watches its bonds and
 evaluates REBO2, and lmp-nanocarbon, a LAMMPS that loads it.")
set(CPACK_DEBIAN_LIBRARY_PACKAGE_NAME libnanocarbon-dev)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_DEPENDS "libeigen3-dev, libfmt-dev, libmuparser-dev, libnanoflann-dev, libopenmesh-dev, libpugixml-dev, nlohmann-json3-dev, zlib1g-dev")
set(CPACK_COMPONENT_LIBRARY_DESCRIPTION
"The library of nanocarbon: headers, static libraries and a CMake package,
 found by find_package(nanocarbon COMPONENTS ...).")
include(CPack)
