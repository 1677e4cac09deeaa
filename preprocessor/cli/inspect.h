// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <CLI/CLI.hpp>

namespace nanocarbon::cli {

//! `nanocarbon inspect MESH`: what a mesh is, and every reason why it could not be used.
void add_inspect(CLI::App& app);

}  // namespace nanocarbon::cli
