// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace nanocarbon::cli {

//! The command as parsed, to be kept in what it made: the program, its subcommands, their arguments and
//! options.
std::string command_text(const CLI::App& subcommand);

}  // namespace nanocarbon::cli
