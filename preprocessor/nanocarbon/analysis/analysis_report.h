// SPDX-License-Identifier: GPL-2.0-or-later
// What an analysis has found, as JSON and as a table.
#pragma once

#include <string>

#include "nanocarbon/analysis/analyse.h"
#include "nanocarbon/analysis/json_writer.h"

namespace nanocarbon::analysis {

//! A frame as the tables of frames show it.
struct FrameSummary {
  std::string file;
  std::size_t frame = 0;             //!< within the file, from 1
  std::optional<std::int64_t> step;  //!< where the file says
  std::size_t atoms = 0, bonds = 0, components = 0;
  FrameChange change;                        //!< since the first frame of all
  FrameStep since_before;                    //!< since the frame before
  std::vector<std::uint64_t> ring_counts;    //!< by size
  std::array<double, 3> hybridisation = {};  //!< shares of sp, sp2, sp3
  double bond_mean = 0.0;                    //!< of carbon with carbon, Angstrom
  std::size_t defects = 0;
  std::optional<double> energy;  //!< eV
};

FrameSummary summarise(const Molecule& molecule, const Analysis& analysis);

//! \brief An analysis as members of the JSON object that was begun: keys are documented in
//! preprocessor/doc/analysis.md.
//! \param ids of the atoms: lists of atoms are lists of these
void write_analysis_json(JsonWriter& json, const Molecule& molecule, std::span<const std::int64_t> ids,
                         const Analysis& analysis);

//! An item of the list `frames`.
void write_frame_json(JsonWriter& json, const FrameSummary& frame);

//! The gist for a terminal, a fact a line.
std::string analysis_table(const Molecule& molecule, std::span<const std::int64_t> ids,
                           const Analysis& analysis);

//! The header and the lines of a CSV file with one line a frame.
std::string frames_csv(std::span<const FrameSummary> frames);

}  // namespace nanocarbon::analysis
