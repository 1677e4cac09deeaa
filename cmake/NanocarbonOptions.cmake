# What a builder may choose, and the settings every target shares.
option(NANOCARBON_PREPROCESSOR "Build the program and all of its library; OFF: the LAMMPS plugin and what it needs alone" ON)
option(NANOCARBON_PLUGIN "Build the LAMMPS plugin (needs LAMMPS headers or source, and MPI)" ON)
option(NANOCARBON_BENCHMARKS "Build the benchmark programs (needs Google Benchmark)" ON)
option(NANOCARBON_WARNINGS_AS_ERRORS "Treat compiler warnings as errors" OFF)
option(NANOCARBON_SANITIZE "Build with the address and undefined-behaviour sanitizers" OFF)

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Kind of build" FORCE)
endif()

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
if(NANOCARBON_WARNINGS_AS_ERRORS)
  target_compile_options(nanocarbon_settings INTERFACE -Werror)
endif()
if(NANOCARBON_SANITIZE)
  target_compile_options(nanocarbon_settings INTERFACE -fsanitize=address,undefined -fno-sanitize-recover=all
                         -fno-omit-frame-pointer)
  target_link_options(nanocarbon_settings INTERFACE -fsanitize=address,undefined)
endif()
