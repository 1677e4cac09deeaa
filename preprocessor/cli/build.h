#pragma once

#include <CLI/CLI.hpp>

namespace nanocarbon {

//! `nanocarbon build MESH -o OUT.data`: from a mesh to a LAMMPS data file of carbon atoms.
void add_build(CLI::App& app);

}  // namespace nanocarbon
