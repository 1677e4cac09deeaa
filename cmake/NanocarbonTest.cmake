# nanocarbon_test(<room>/<unit> [SOURCES <files...>] LINKS <libraries...> [LABEL <label>] [TIMEOUT <seconds>])
#
# One GoogleTest program for tests/<room>/<unit>_test.cpp; every TEST in it becomes a ctest test. Labels in use:
# "slow" (left out under the sanitizers), "lammps" (needs a LAMMPS library), "lammps-slow" (both).
find_package(GTest REQUIRED)
include(GoogleTest)

function(nanocarbon_test path)
  cmake_parse_arguments(TEST "" "TIMEOUT;LABEL" "SOURCES;LINKS" ${ARGN})
  string(REPLACE "/" "_" program "${path}")
  set(program test_${program})
  add_executable(${program} ${PROJECT_SOURCE_DIR}/tests/${path}_test.cpp ${TEST_SOURCES})
  target_include_directories(${program} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
  target_link_libraries(${program} PRIVATE ${TEST_LINKS} nanocarbon_settings GTest::gmock GTest::gtest_main)
  if(NOT TEST_TIMEOUT)
    set(TEST_TIMEOUT 300)
  endif()
  set(labels "")
  if(TEST_LABEL)
    set(labels LABELS ${TEST_LABEL})
  endif()
  string(REPLACE "/" "." prefix "${path}")
  gtest_discover_tests(${program} TEST_PREFIX "${prefix}." DISCOVERY_TIMEOUT 60
                       PROPERTIES TIMEOUT ${TEST_TIMEOUT} ${labels})
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
