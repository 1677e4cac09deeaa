// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <CLI/CLI.hpp>

namespace nanocarbon::cli {

//! `nanocarbon build MESH -o OUT.data`: from a mesh to a LAMMPS data file of carbon atoms.
void add_build(CLI::App& app);

}  // namespace nanocarbon::cli
