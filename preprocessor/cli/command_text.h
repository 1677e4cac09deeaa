#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace nanocarbon {

//! The command as parsed, to be kept in what it made: the program, its subcommands, their arguments and
//! options.
std::string command_text(const CLI::App& subcommand);

}  // namespace nanocarbon
