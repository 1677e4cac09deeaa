# SPDX-License-Identifier: GPL-2.0-or-later
# nanocarbon_test(<room>/<unit> [SOURCES <files...>] LINKS <libraries...> [LABEL <label>] [TIMEOUT <seconds>])
#
# One GoogleTest program for tests/<room>/<unit>_test.cpp; every TEST in it becomes a ctest test. Labels in use:
# "slow" (left out under the sanitizers), "lammps" (needs a LAMMPS library), "lammps-slow" (both).
find_package(GTest REQUIRED)
include(GoogleTest)
nanocarbon_precompile(nanocarbon_test_headers EXECUTABLES LINKS Eigen3::Eigen GTest::gmock GTest::gtest
  HEADERS <gmock/gmock.h> <gtest/gtest.h> <Eigen/Core> <Eigen/Geometry> <algorithm> <cmath> <fstream> <functional>
          <optional> <span> <string> <vector>)

function(nanocarbon_test path)
  cmake_parse_arguments(TEST "" "TIMEOUT;LABEL" "SOURCES;LINKS" ${ARGN})
  string(REPLACE "/" "_" program "${path}")
  set(program test_${program})
  add_executable(${program} ${PROJECT_SOURCE_DIR}/tests/${path}_test.cpp ${TEST_SOURCES})
  target_include_directories(${program} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
  target_link_libraries(${program} PRIVATE ${TEST_LINKS} nanocarbon_settings GTest::gmock GTest::gtest_main)
  nanocarbon_precompiled(${program} nanocarbon_test_headers)
  if(NOT TEST_TIMEOUT)
    set(TEST_TIMEOUT 900)
  endif()
  if(NANOCARBON_SANITIZE OR NANOCARBON_COVERAGE)
    math(EXPR TEST_TIMEOUT "5 * ${TEST_TIMEOUT}")  # they cost about as much
  endif()
  set(properties TIMEOUT ${TEST_TIMEOUT})
  if(TEST_LABEL)
    list(APPEND properties LABELS ${TEST_LABEL})
  endif()
  if(TEST_LABEL MATCHES "lammps")
    # Open MPI, which LAMMPS starts, leaves some hundred bytes behind that are not ours to free.
    list(APPEND properties ENVIRONMENT ASAN_OPTIONS=detect_leaks=0)
  endif()
  string(REPLACE "/" "." prefix "${path}")
  gtest_discover_tests(${program} TEST_PREFIX "${prefix}." DISCOVERY_TIMEOUT 60
                       PROPERTIES ${properties})
endfunction()

# nanocarbon_benchmark(<name> SOURCES <files...> LINKS <libraries...>): a Google Benchmark program, never a test.
function(nanocarbon_benchmark name)
  cmake_parse_arguments(BENCH "" "" "SOURCES;LINKS" ${ARGN})
  if(NOT NANOCARBON_BENCHMARKS)
    return()
  endif()
  find_package(benchmark REQUIRED)
  add_executable(benchmark_${name} ${BENCH_SOURCES})
  target_include_directories(benchmark_${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
  target_link_libraries(benchmark_${name} PRIVATE ${BENCH_LINKS} nanocarbon_settings benchmark::benchmark_main)
endfunction()
