// SPDX-License-Identifier: GPL-2.0-or-later
// The file of atoms that a subcommand reads, and what the user can say about it.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "nanocarbon/molecule/formats/read_molecule.h"

namespace nanocarbon::cli {

struct MoleculeInput {
  std::string file;  //!< `-` for standard input
  std::vector<std::string> types;
  std::string atom_style;
  std::string boundary;
  std::string cell;
  std::optional<std::int64_t> frame;
};

//! Adds --types, --atom-style, --boundary and --cell. \p input must outlive the app.
void add_read_options(CLI::App& subcommand, MoleculeInput& input);

//! Adds FILE, --types, --atom-style, --boundary and --cell. \p input must outlive the app.
void add_molecule_input(CLI::App& subcommand, MoleculeInput& input);

//! Adds --frame, for subcommands that take one frame.
void add_frame_option(CLI::App& subcommand, MoleculeInput& input);

//! \brief What the options say about how to read.
//! \throw UserError (usage) for a boundary or a cell that is none
molecule::MoleculeReadOptions read_options(const MoleculeInput& input);

//! Says what a user should know of what was read, on the error stream.
void print_warnings(const MoleculeInput& input, const std::vector<std::string>& warnings);

//! \brief The frame asked for, its warnings said.
//! \throw UserError as molecule::read_molecule
molecule::MoleculeFrame read_molecule(const MoleculeInput& input);

}  // namespace nanocarbon::cli
