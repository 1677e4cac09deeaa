# SPDX-License-Identifier: GPL-2.0-or-later
# The programs that run.sh runs, by libFuzzer: clang's.

# nanocarbon_fuzzer(<name> SOURCES <files...> [READERS <readers...>] LINKS <libraries...>): with readers it is called by
# <name>_<reader> for each of them, and tells by that what to read.
function(nanocarbon_fuzzer name)
  cmake_parse_arguments(FUZZER "" "" "SOURCES;READERS;LINKS" ${ARGN})
  add_executable(fuzz_${name} ${FUZZER_SOURCES})
  target_include_directories(fuzz_${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
  target_link_options(fuzz_${name} PRIVATE -fsanitize=fuzzer)
  target_link_libraries(fuzz_${name} PRIVATE nanocarbon_settings ${FUZZER_LINKS})
  foreach(reader ${FUZZER_READERS})
    add_custom_command(TARGET fuzz_${name} POST_BUILD
                       COMMAND ${CMAKE_COMMAND} -E create_symlink fuzz_${name} fuzz_${name}_${reader})
  endforeach()
  add_dependencies(fuzzers fuzz_${name})
endfunction()

find_package(ZLIB REQUIRED)
add_custom_target(fuzzers)
nanocarbon_fuzzer(mesh SOURCES mesh_fuzzer.cpp check_mesh.cpp
                  READERS off obj ply stl glb gltf 3mf vtk vtp vtu vti msh cube mrc
                  LINKS nanocarbon::mesh_formats)
nanocarbon_fuzzer(molecule SOURCES molecule_fuzzer.cpp check_molecule.cpp READERS data dump yaml xyz cif poscar
                  LINKS nanocarbon::molecule_formats)
nanocarbon_fuzzer(molecule_packed SOURCES packed_fuzzer.cpp check_molecule.cpp LINKS nanocarbon::molecule_formats ZLIB::ZLIB)
nanocarbon_fuzzer(types SOURCES types_fuzzer.cpp LINKS nanocarbon::molecule_formats)
nanocarbon_fuzzer(potential SOURCES potential_fuzzer.cpp READERS rebo airebo airebo_m
                  LINKS nanocarbon::rebo2 nanocarbon::airebo)

add_executable(write_seeds write_seeds.cpp mesh_seeds.cpp molecule_seeds.cpp ../support/grid_files.cpp
               ../support/scene_files.cpp)
target_include_directories(write_seeds PRIVATE ${PROJECT_SOURCE_DIR}/tests)
target_link_libraries(write_seeds PRIVATE nanocarbon_settings nanocarbon::mesh_formats fmt::fmt)
add_dependencies(fuzzers write_seeds)
