// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "nanocarbon/core/vec3.h"
#include "nanocarbon/potential/airebo/lj/lj_constants.h"
#include "nanocarbon/potential/airebo/lj/lj_kernel.h"

namespace nanocarbon::airebo {

//! \brief A fixed part of the rows, with its own clusters for all atoms that occur in them.
//! \details Chunks share no data, so they can be evaluated in parallel, and their sums do not depend on which thread
//! does it. The list holds all pairs that may come within reach for as long as it is kept; the
//! rows that are evaluated are those of it that lie within a small margin, searched anew as atoms move.
struct LjChunk {
  std::vector<LjCluster> clusters;    //!< the last one is in no row
  std::vector<std::uint32_t> atoms;   //!< [4 cluster + lane], the caller's; padding repeats one
  std::vector<std::uint32_t> images;  //!< which translation to add to its position; empty where all are zero
  std::vector<std::uint8_t> real;     //!< [cluster] the lanes that are not padding
  bool mixed = false;                 //!< whether there is hydrogen
  std::vector<LjRow> list_rows;
  std::vector<LjEntry> list;
  std::vector<LjRow> rows;
  std::vector<LjEntry> entries;
  std::vector<LjCluster> searched;  //!< as the clusters were at the last search; empty before the first
  std::vector<LjCluster> listed;    //!< as they were when the list was made
  double strayed = 0.0;             //!< how far an atom had moved from there to the last search, Angstrom
};

//! \brief Fetches positions and sets forces to zero.
//! \param translations Angstrom, what LjChunk::images refers to
//! \return how far an atom has moved since the last search, Angstrom; infinity before the first one
double place_atoms(LjChunk& chunk, const double* positions, std::span<const Vec3> translations);

//! Takes the rows out of the list that are within the margin (Angstrom) of what counts.
void search_rows(LjChunk& chunk, const LjKernel& kernel, const LjParameters& parameters, double margin);

//! Rows and their entries, with room for more.
struct LjRowBuffer {
  std::vector<LjRow> rows;
  std::vector<LjEntry> entries;
};

//! \brief Makes a list of what lies within the margin, and keeps the places for LjChunk::strayed.
//! \param buffer any; may be used again
//! \pre place_atoms() was called
void list_rows(LjChunk& chunk, std::span<const LjRow> rows, std::span<const LjEntry> entries,
               const LjKernel& kernel, const LjParameters& parameters, double margin, LjRowBuffer& buffer);

}  // namespace nanocarbon::airebo
