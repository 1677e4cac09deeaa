// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "nanocarbon/building/build_molecule.h"

namespace nanocarbon::building {

//! What the report says about where a molecule came from.
struct ReportContext {
  std::string command;               //!< the command line
  std::string input;                 //!< the mesh file
  std::vector<std::string> repairs;  //!< what was mended in it
};

//! \brief Everything worth knowing about a molecule and its making, as JSON.
//! \details Lengths in Angstrom, angles in degrees, times in seconds. Keys are documented in
//! preprocessor/doc/report.md. Nothing but the times and thread count depends on anything but input, options
//! and seed.
nlohmann::ordered_json build_report(const BuildResult& result, const BuildOptions& options,
                                    const ReportContext& context);

//! The gist of a report as a table for a terminal, a fact a line.
std::string report_table(const nlohmann::ordered_json& report);

}  // namespace nanocarbon::building
