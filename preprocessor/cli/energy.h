#pragma once

#include <CLI/CLI.hpp>

namespace nanocarbon {

//! `nanocarbon energy FILE`: REBO2 energy and forces of a structure.
void add_energy(CLI::App& app);

}  // namespace nanocarbon
