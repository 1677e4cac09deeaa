// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <CLI/CLI.hpp>

namespace nanocarbon::cli {

//! `nanocarbon energy FILE`: REBO2 energy and forces of a structure.
void add_energy(CLI::App& app);

}  // namespace nanocarbon::cli
