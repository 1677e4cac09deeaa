# SPDX-License-Identifier: GPL-2.0-or-later
# Finds the LAMMPS to build the plugin for, as the target nanocarbon_lammps_headers (headers, MPI and definitions), and
# its version as NANOCARBON_LAMMPS_VERSION (20210929) and NANOCARBON_LAMMPS_DATE (29 Sep 2021).
#
# LAMMPS_SOURCE_DIR, the unpacked source of a LAMMPS with the PLUGIN package, goes before an installed LAMMPS.
# Only an installed LAMMPS has the target LAMMPS::lammps, which the host program and the tests link.
#
# LAMMPS's folder holds names of other people: its own nlohmann/json.hpp, which refuses to be included, its own fmt/,
# and an error.h and a memory.h, which the C library has as well. It is therefore searched for includes in quotes alone,
# never for those in angle brackets, after the project's own folders and before the stand-ins: a header that LAMMPS has
# is LAMMPS's, and one that it lacks is ours.
set(LAMMPS_SOURCE_DIR "" CACHE PATH "Source of the LAMMPS to build the plugin for; empty: the installed one")
set(NANOCARBON_LAMMPS_DEFINITIONS "" CACHE STRING "What that source was compiled with, such as LAMMPS_BIGBIG")

find_package(MPI REQUIRED COMPONENTS CXX)
add_library(nanocarbon_lammps_headers INTERFACE)
target_link_libraries(nanocarbon_lammps_headers INTERFACE MPI::MPI_CXX)
# Open MPI's C++ bindings are long gone from the standard and warn under -Wextra.
target_compile_definitions(nanocarbon_lammps_headers INTERFACE OMPI_SKIP_MPICXX MPICH_SKIP_MPICXX)

if(LAMMPS_SOURCE_DIR)
  find_path(lammps_include lammps.h PATHS ${LAMMPS_SOURCE_DIR} ${LAMMPS_SOURCE_DIR}/src NO_DEFAULT_PATH NO_CACHE)
  if(NOT lammps_include)
    message(FATAL_ERROR "LAMMPS_SOURCE_DIR: no lammps.h in ${LAMMPS_SOURCE_DIR} or its folder src")
  endif()
  file(STRINGS ${lammps_include}/version.h version_line REGEX "define LAMMPS_VERSION")
  string(REGEX MATCH "\"([0-9]+) ([A-Z][a-z][a-z])[a-z]* ([0-9]+)\"" matched "${version_line}")
  if(NOT matched)
    message(FATAL_ERROR "No LAMMPS_VERSION in ${lammps_include}/version.h")
  endif()
  set(day ${CMAKE_MATCH_1})
  set(month ${CMAKE_MATCH_2})
  set(year ${CMAKE_MATCH_3})
  set(lammps_date "${day} ${month} ${year}")
  set(months Jan Feb Mar Apr May Jun Jul Aug Sep Oct Nov Dec)
  list(FIND months ${month} index)
  math(EXPR NANOCARBON_LAMMPS_VERSION "${year} * 10000 + (${index} + 1) * 100 + ${day}")
  target_compile_definitions(nanocarbon_lammps_headers INTERFACE ${NANOCARBON_LAMMPS_DEFINITIONS})
else()
  # Its package config also looks for what LAMMPS itself was linked with; the plugin needs none of that.
  find_package(LAMMPS REQUIRED)
  # The folder with the headers, or since 2022 the one above.
  get_target_property(include_folders LAMMPS::lammps INTERFACE_INCLUDE_DIRECTORIES)
  find_path(lammps_include lammps.h PATHS ${include_folders} PATH_SUFFIXES lammps NO_DEFAULT_PATH NO_CACHE)
  if(NOT lammps_include)
    message(FATAL_ERROR "The installed LAMMPS, ${LAMMPS_DIR}, has no lammps.h in ${include_folders}")
  endif()
  get_target_property(definitions LAMMPS::lammps INTERFACE_COMPILE_DEFINITIONS)
  if(definitions)
    target_compile_definitions(nanocarbon_lammps_headers INTERFACE ${definitions})
  endif()
  # Written as 20250204, and since 2026 as 2026.7.4.0.
  if(NOT "${LAMMPS_VERSION}" MATCHES "^([0-9][0-9][0-9][0-9])[.]?([0-9][0-9]?)[.]?([0-9][0-9]?)([.]|$)")
    message(FATAL_ERROR "The installed LAMMPS, ${LAMMPS_DIR}, has a version without a date: '${LAMMPS_VERSION}'")
  endif()
  set(year ${CMAKE_MATCH_1})
  math(EXPR index "${CMAKE_MATCH_2} - 1")
  math(EXPR day "${CMAKE_MATCH_3}")
  math(EXPR NANOCARBON_LAMMPS_VERSION "${year} * 10000 + (${index} + 1) * 100 + ${day}")
  set(months Jan Feb Mar Apr May Jun Jul Aug Sep Oct Nov Dec)
  list(GET months ${index} month)
  set(lammps_date "${day} ${month} ${year}")
endif()
foreach(folder ${PROJECT_SOURCE_DIR}/lammps-plugin ${PROJECT_BINARY_DIR}/generated ${PROJECT_SOURCE_DIR}/preprocessor
        ${lammps_include} ${PROJECT_SOURCE_DIR}/lammps-plugin/compat/stand-in)
  target_compile_options(nanocarbon_lammps_headers INTERFACE "SHELL:-iquote \"${folder}\"")
endforeach()
# For the tests, too, which are another folder's.
set(NANOCARBON_LAMMPS_DATE ${lammps_date} CACHE INTERNAL "")
set(NANOCARBON_LAMMPS_INCLUDE ${lammps_include} CACHE INTERNAL "")
message(STATUS "LAMMPS ${lammps_date}: ${lammps_include}")
