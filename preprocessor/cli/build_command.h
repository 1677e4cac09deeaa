// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

#include "cell_options.h"
#include "common_options.h"
#include "nanocarbon/building/build_molecule.h"
#include "nanocarbon/molecule/formats/atom_style.h"
#include "surface_input.h"

namespace nanocarbon::cli {

//! The command line of `nanocarbon build`.
struct BuildCommand {
  std::string mesh;
  std::filesystem::path data;
  std::optional<std::filesystem::path> xyz, triangulation, report, page;
  std::string atoms;  //!< a number, "fit", or empty
  std::optional<double> length, scale;
  std::optional<double> min_bond, max_bond, local_threshold;
  std::optional<unsigned> iterations, rings, projection_interval;
  std::optional<thesis::VisitedMarks> visited;
  molecule::AtomStyle atom_style = molecule::AtomStyle::molecular;
  double margin = 10.0;
  bool no_repair = false;
  SurfaceOptions surface;
  building::BuildOptions build;
  CellOptions cell;
  CommonOptions common;
  std::string command_line;
};

//! Adds what is not in common_options.h. \p command must outlive the app.
void add_build_options(CLI::App& subcommand, BuildCommand& command);

//! \throw UserError (usage) where an option was given that the recipe has no use for: whoever asks for a
//! certificate must not take silence for one
void require_options_of_recipe(const CLI::App& subcommand, building::Recipe recipe);

//! \brief The parameters of the thesis that a command line asks for: the recipe's own, then those given.
//! \throw UserError (usage) for an interval that is none
thesis::ThesisOptions thesis_options(const BuildCommand& command);

}  // namespace nanocarbon::cli
