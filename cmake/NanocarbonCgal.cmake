# SPDX-License-Identifier: GPL-2.0-or-later
# Whether the program has --wrap, --unite and --untangle. They need CGAL 5.5 or newer, whose packages for that are under
# GPL-3.0-or-later; so is then the program as a whole. Nothing else links it: neither the plugin nor the installed library.
# It asks for Boost by a module that CMake 3.30 takes for removed, and would warn of every time.
set(CMAKE_POLICY_DEFAULT_CMP0167 OLD)
find_package(CGAL QUIET)  # no version: CGAL 6 says that it does not do for 5.5
unset(CMAKE_POLICY_DEFAULT_CMP0167)
if(CGAL_FOUND AND CGAL_VERSION VERSION_LESS 5.5)
  set(CGAL_FOUND FALSE)
endif()
set(has_cgal OFF)
if(CGAL_FOUND)
  set(has_cgal ON)
endif()
option(NANOCARBON_CGAL "Build --wrap, --unite and --untangle into the program, by CGAL (GPL-3.0-or-later)" ${has_cgal})
if(NANOCARBON_CGAL AND NOT CGAL_FOUND)
  message(FATAL_ERROR "NANOCARBON_CGAL needs CGAL 5.5 or newer (Debian's libcgal-dev)")
endif()
if(NOT NANOCARBON_CGAL)
  message(STATUS "The program is built without --wrap, --unite and --untangle: they need CGAL 5.5 or newer (libcgal-dev)")
endif()
