// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "nanocarbon/building/potential_choice.h"

namespace nanocarbon::cli {

//! Adds --potential, which takes rebo2, airebo or airebo-m.
//! \param choice must outlive the app; empty stays what was not given
void add_potential_option(CLI::App& app, building::PotentialChoice& choice, const std::string& help);
void add_potential_option(CLI::App& app, std::optional<building::PotentialChoice>& choice,
                          const std::string& help);

}  // namespace nanocarbon::cli
