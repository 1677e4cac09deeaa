# SPDX-License-Identifier: GPL-2.0-or-later
# What a builder may choose, and the settings every target shares. As part of another project (add_subdirectory or
# FetchContent) this one brings its library alone, installs nothing, and leaves the other's choices as they are.
option(NANOCARBON_PREPROCESSOR "Build the program and all of its library; OFF: the LAMMPS plugin and what it needs alone" ON)
option(NANOCARBON_PROGRAM "Build the program nanocarbon (needs CLI11)" ${PROJECT_IS_TOP_LEVEL})
# NANOCARBON_CGAL (cmake/NanocarbonCgal.cmake): --wrap, --unite and --untangle of the program, which is then under GPL-3.0-or-later
option(NANOCARBON_PLUGIN "Build the LAMMPS plugin (needs LAMMPS headers or source, and MPI)" ${PROJECT_IS_TOP_LEVEL})
option(NANOCARBON_PYTHON "Build the Python module nanocarbon_sp2, where pybind11 and Python's headers are" ${PROJECT_IS_TOP_LEVEL})
option(NANOCARBON_INSTALL "Install what is built" ${PROJECT_IS_TOP_LEVEL})
option(NANOCARBON_BENCHMARKS "Build the benchmark programs (needs Google Benchmark)" ON)
option(NANOCARBON_WARNINGS_AS_ERRORS "Treat compiler warnings as errors" OFF)
option(NANOCARBON_PRECOMPILE "Precompile the headers of other libraries: builds in about half the time" ON)
option(NANOCARBON_SANITIZE "Build with the address and undefined-behaviour sanitizers" OFF)
option(NANOCARBON_FUZZERS "Build the fuzzers (needs clang)" OFF)
option(NANOCARBON_COVERAGE "Count which lines run; the target coverage makes a page of it (needs gcovr)" OFF)

if(PROJECT_IS_TOP_LEVEL AND NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Kind of build" FORCE)
endif()

# A project that this one is part of must see the packages that the rooms link.
set(CMAKE_FIND_PACKAGE_TARGETS_GLOBAL ON)
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
# The rooms are static libraries that also go into the plugin's shared object, which exports only its entry point.
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_CXX_VISIBILITY_PRESET hidden)
set(CMAKE_VISIBILITY_INLINES_HIDDEN ON)

# Carried by every target of the project, not exported with the installed library.
add_library(nanocarbon_settings INTERFACE)
target_compile_options(nanocarbon_settings INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor)
# GCC 12 warns of strings that the standard library moves: wrongly, and only where headers are precompiled.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  target_compile_options(nanocarbon_settings INTERFACE -Wno-array-bounds -Wno-restrict -Wno-stringop-overflow
                         -Wno-stringop-overread)
endif()
if(NANOCARBON_WARNINGS_AS_ERRORS)
  target_compile_options(nanocarbon_settings INTERFACE -Werror)
endif()
if(NANOCARBON_SANITIZE)
  target_compile_options(nanocarbon_settings INTERFACE -fsanitize=address,undefined -fno-sanitize-recover=all
                         -fno-omit-frame-pointer)
  target_link_options(nanocarbon_settings INTERFACE -fsanitize=address,undefined)
endif()
if(NANOCARBON_FUZZERS)
  # Every room is compiled for coverage, too, so that a fuzzer sees which branches an input reaches.
  target_compile_options(nanocarbon_settings INTERFACE -fsanitize=fuzzer-no-link,address,undefined
                         -fno-sanitize-recover=all)
  target_link_options(nanocarbon_settings INTERFACE -fsanitize=fuzzer-no-link,address,undefined)
endif()
if(NANOCARBON_COVERAGE)
  target_compile_options(nanocarbon_settings INTERFACE --coverage -fprofile-update=atomic)
  target_link_options(nanocarbon_settings INTERFACE --coverage)
  find_program(NANOCARBON_GCOVR gcovr)
  if(NANOCARBON_GCOVR)
    # Of the runs so far: build, run the tests, then build this.
    file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/coverage)
    add_custom_target(coverage
      COMMAND ${NANOCARBON_GCOVR} --root ${PROJECT_SOURCE_DIR} --filter preprocessor/ --filter lammps-plugin/
              --object-directory ${PROJECT_BINARY_DIR} --exclude-throw-branches --print-summary
              --html-details ${PROJECT_BINARY_DIR}/coverage/index.html
      WORKING_DIRECTORY ${PROJECT_SOURCE_DIR} VERBATIM)
  endif()
endif()

# nanocarbon_precompiled(<target> <headers>) lets a target use headers that are precompiled once:
# nanocarbon_headers (the standard library and Eigen) or nanocarbon_test_headers (GoogleTest as well).
function(nanocarbon_precompiled target headers)
  if(TARGET ${headers})
    target_precompile_headers(${target} REUSE_FROM ${headers})
  endif()
endfunction()

# nanocarbon_precompile(<name> [EXECUTABLES] LINKS <libraries...> HEADERS <headers...>) makes such a set, for
# libraries or for executables, which are compiled by other options.
function(nanocarbon_precompile name)
  if(NOT NANOCARBON_PRECOMPILE)
    return()
  endif()
  cmake_parse_arguments(SET "EXECUTABLES" "" "LINKS;HEADERS" ${ARGN})
  set(source ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp)
  file(CONFIGURE OUTPUT ${source} CONTENT "// Does nothing: its target holds precompiled headers.\nint main() {}\n")
  if(SET_EXECUTABLES)
    add_executable(${name} ${source})
  else()
    add_library(${name} OBJECT ${source})
  endif()
  target_compile_features(${name} PUBLIC cxx_std_20)
  target_link_libraries(${name} PRIVATE ${SET_LINKS} nanocarbon_settings)
  target_precompile_headers(${name} PRIVATE ${SET_HEADERS})
endfunction()
