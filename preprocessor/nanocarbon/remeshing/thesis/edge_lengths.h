// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>
#include <cstddef>

#include "nanocarbon/remeshing/thesis/length_interval.h"
#include "nanocarbon/remeshing/thesis/triangulation.h"

namespace nanocarbon::thesis {

//! How many edges lie outside an interval.
struct EdgeCounts {
  std::size_t edges = 0;
  std::size_t too_short = 0;
  std::size_t too_long = 0;

  std::size_t outside() const { return too_short + too_long; }
  //! CalcEdgesPercent() of Algorithm 1.
  double percent_outside() const {
    return edges ? 100.0 * static_cast<double>(outside()) / static_cast<double>(edges) : 0.0;
  }
};

EdgeCounts count_edges(const Triangulation& mesh, const LengthInterval& interval);

//! m_i, Angstrom; 0 for a mesh without edges.
double mean_edge_length(const Triangulation& mesh);

//! Vertices by valence. Of boundary vertices valence says little about rings, so they are counted apart.
struct ValenceCounts {
  std::array<std::size_t, 16> inner{};  //!< by valence; the last one holds 15 and more
  std::size_t boundary = 0;

  //! Inner vertices whose valence, and so the ring of the dual, is outside 5 to 7.
  std::size_t outside_5_to_7() const;
};

ValenceCounts count_valences(const Triangulation& mesh);

}  // namespace nanocarbon::thesis
