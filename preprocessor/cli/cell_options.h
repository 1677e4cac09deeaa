// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "nanocarbon/mesh/formats/cell_request.h"

namespace nanocarbon::cli {

//! The options that say which periodic cell a mesh is in.
struct CellOptions {
  std::optional<std::string> periodic;
  std::vector<double> cell;
  std::vector<int> cells;
  double match = 1e-3;
  std::string name = "--cell";  //!< of the option that gives the cell
};

//! \p options must outlive the app.
void add_cell_options(CLI::App& subcommand, CellOptions& options);

//! Of those the ones that say in what cell a surface that is made repeats itself: --period, which may also be
//! one number, for the edge of a cube, and --periodic.
void add_period_options(CLI::App& subcommand, CellOptions& options);

//! \throw UserError (usage) for numbers that make no cell
mesh::CellRequest cell_request(const CellOptions& options);

//! Numbers of cells along three edges from one number for all or three.
std::array<int, 3> cells_each_way(const std::vector<int>& cells);

//! Lengths of a cell's edges and the angles between them (alpha of b and c, ...), as text.
std::string describe_cell(const Cell& cell);

}  // namespace nanocarbon::cli
