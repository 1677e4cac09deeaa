# SPDX-License-Identifier: GPL-2.0-or-later
# Finds the LAMMPS to build the plugin for, as the target nanocarbon_lammps_headers (headers, MPI and definitions), and
# its version as NANOCARBON_LAMMPS_VERSION (20210929) and NANOCARBON_LAMMPS_DATE (29 Sep 2021).
#
# LAMMPS_SOURCE_DIR, the unpacked source of a LAMMPS with the PLUGIN package, goes before an installed LAMMPS.
# Only an installed LAMMPS has the target LAMMPS::lammps, which the host program and the tests link.
set(LAMMPS_SOURCE_DIR "" CACHE PATH "Source of the LAMMPS to build the plugin for; empty: the installed one")
set(NANOCARBON_LAMMPS_DEFINITIONS "" CACHE STRING "What that source was compiled with, such as LAMMPS_BIGBIG")

find_package(MPI REQUIRED COMPONENTS CXX)
add_library(nanocarbon_lammps_headers INTERFACE)
target_link_libraries(nanocarbon_lammps_headers INTERFACE MPI::MPI_CXX)
# Open MPI's C++ bindings are long gone from the standard and warn under -Wextra.
target_compile_definitions(nanocarbon_lammps_headers INTERFACE OMPI_SKIP_MPICXX MPICH_SKIP_MPICXX)

if(LAMMPS_SOURCE_DIR)
  find_path(NANOCARBON_LAMMPS_INCLUDE lammps.h PATHS ${LAMMPS_SOURCE_DIR} ${LAMMPS_SOURCE_DIR}/src NO_DEFAULT_PATH)
  if(NOT NANOCARBON_LAMMPS_INCLUDE)
    message(FATAL_ERROR "LAMMPS_SOURCE_DIR: no lammps.h in ${LAMMPS_SOURCE_DIR} or its folder src")
  endif()
  file(STRINGS ${NANOCARBON_LAMMPS_INCLUDE}/version.h version_line REGEX "define LAMMPS_VERSION")
  string(REGEX MATCH "\"([0-9]+) ([A-Z][a-z][a-z])[a-z]* ([0-9]+)\"" matched "${version_line}")
  if(NOT matched)
    message(FATAL_ERROR "No LAMMPS_VERSION in ${NANOCARBON_LAMMPS_INCLUDE}/version.h")
  endif()
  set(day ${CMAKE_MATCH_1})
  set(month ${CMAKE_MATCH_2})
  set(year ${CMAKE_MATCH_3})
  set(NANOCARBON_LAMMPS_DATE "${day} ${month} ${year}")
  set(months Jan Feb Mar Apr May Jun Jul Aug Sep Oct Nov Dec)
  list(FIND months ${month} index)
  math(EXPR NANOCARBON_LAMMPS_VERSION "${year} * 10000 + (${index} + 1) * 100 + ${day}")
  target_compile_definitions(nanocarbon_lammps_headers INTERFACE ${NANOCARBON_LAMMPS_DEFINITIONS})
else()
  # Its package config also looks for what LAMMPS itself was linked with; the plugin needs none of that.
  find_package(LAMMPS REQUIRED)
  get_target_property(NANOCARBON_LAMMPS_INCLUDE LAMMPS::lammps INTERFACE_INCLUDE_DIRECTORIES)
  get_target_property(definitions LAMMPS::lammps INTERFACE_COMPILE_DEFINITIONS)
  if(definitions)
    target_compile_definitions(nanocarbon_lammps_headers INTERFACE ${definitions})
  endif()
  set(NANOCARBON_LAMMPS_VERSION ${LAMMPS_VERSION})
  string(REGEX MATCH "^([0-9][0-9][0-9][0-9])([0-9][0-9])([0-9][0-9])$" matched "${LAMMPS_VERSION}")
  set(months Jan Feb Mar Apr May Jun Jul Aug Sep Oct Nov Dec)
  math(EXPR index "${CMAKE_MATCH_2} - 1")
  math(EXPR day "${CMAKE_MATCH_3}")
  list(GET months ${index} month)
  set(NANOCARBON_LAMMPS_DATE "${day} ${month} ${CMAKE_MATCH_1}")
endif()
target_include_directories(nanocarbon_lammps_headers SYSTEM INTERFACE ${NANOCARBON_LAMMPS_INCLUDE})
message(STATUS "LAMMPS ${NANOCARBON_LAMMPS_DATE}: ${NANOCARBON_LAMMPS_INCLUDE}")
