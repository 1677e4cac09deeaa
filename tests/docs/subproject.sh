#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# Configures a project that has this one as a part: the library alone comes along, nothing is installed or tested with it,
# and the other project's choices stay.
#
#   subproject.sh SOURCE_FOLDER WORK_FOLDER
set -euo pipefail
source=$1 work=$2
rm -rf "$work"
mkdir -p "$work/source"
cat >"$work/source/CMakeLists.txt" <<END
cmake_minimum_required(VERSION 3.24)
project(other LANGUAGES CXX)
enable_testing()
add_subdirectory("$source" nanocarbon EXCLUDE_FROM_ALL)
add_executable(other main.cpp)
target_link_libraries(other PRIVATE nanocarbon::building nanocarbon::structures)
add_test(NAME others_own COMMAND other)
install(TARGETS other)
END
echo 'int main() {}' >"$work/source/main.cpp"
cmake -G Ninja -S "$work/source" -B "$work/build"
grep -q '^CMAKE_BUILD_TYPE:STRING=$' "$work/build/CMakeCache.txt"
ctest --test-dir "$work/build" -N | grep -q '^Total Tests: 1$'
# Targets of the program, the plugin and the tests, and those that CTest and CPack make.
if cmake --build "$work/build" --target help | grep -E 'lmp-nanocarbon|nanocarbonplugin|test_|Experimental|doxygen|^package:'; then
  echo "these targets are not the other project's to have"
  exit 1
fi
# Only what the other project installs itself, whatever the folders are called.
! find "$work/build/nanocarbon" -name cmake_install.cmake -exec grep -l 'file(INSTALL' {} + | grep .
