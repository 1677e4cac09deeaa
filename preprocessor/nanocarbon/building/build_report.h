// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "nanocarbon/building/build_molecule.h"

namespace nanocarbon::building {

//! What the report says about the origin of a molecule.
struct ReportContext {
  std::string command;               //!< the command line
  std::string input;                 //!< the mesh file
  std::vector<std::string> repairs;  //!< what was repaired in it
};

//! \brief Everything worth knowing about a molecule and how it was made, as JSON.
//! \details Lengths in Angstrom, angles in degrees, times in seconds. Keys are documented in
//! preprocessor/doc/report.md. Apart from the times and the number of threads it depends only on input, options
//! and seed.
nlohmann::ordered_json build_report(const BuildResult& result, const BuildOptions& options,
                                    const ReportContext& context);

//! Time by stage as the report has it.
nlohmann::ordered_json stages_json(const StageClock& clock);

//! A summary of a report for a terminal, one fact per line.
std::string report_table(const nlohmann::ordered_json& report);

}  // namespace nanocarbon::building
