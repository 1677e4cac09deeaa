// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <CLI/CLI.hpp>

namespace nanocarbon::cli {

//! `nanocarbon analyse FILE...`: what structures and trajectories of carbon and hydrogen are made of.
void add_analyse(CLI::App& app);

}  // namespace nanocarbon::cli
