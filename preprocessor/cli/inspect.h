#pragma once

#include <CLI/CLI.hpp>

namespace nanocarbon {

//! `nanocarbon inspect MESH`: what a mesh is, and every reason why it could not be used.
void add_inspect(CLI::App& app);

}  // namespace nanocarbon
