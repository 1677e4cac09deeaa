// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "nanocarbon/remeshing/thesis/edge_energy.h"
#include "nanocarbon/remeshing/thesis/length_interval.h"
#include "nanocarbon/remeshing/thesis/vertex_stars.h"

namespace nanocarbon::thesis {

struct LocalOptions {
  LengthInterval interval;    //!< [l_min, l_max], Angstrom; its mean is m
  unsigned rings = 4;         //!< the fourth star of the edge
  bool tangent_plane = true;  //!< Eq. 4.7; false for Eq. 4.4, points free to leave the surface
  MinimiserOptions minimiser;
};

struct LocalTotals {
  std::size_t candidates = 0;  //!< edges in the priority list
  std::size_t minimised = 0;   //!< regions minimised
  std::size_t iterations = 0;  //!< conjugate-gradient iterations over all regions
};

struct StarEdge {
  VertexIndex a;
  VertexIndex b;
};

//! \brief The edges outside the interval, those with most short and long edges around first (list L_p^o,
//! section 4.4).
//! \details The neighbourhood of an edge is every edge that ends at a vertex at most `rings` rings away from
//! either of its ends. Equal counts stay in the order of the vertices.
std::vector<StarEdge> local_priority_list(const VertexStars& stars, const LengthInterval& interval,
                                          unsigned rings);

//! \brief Minimises Eq. 4.7 (or 4.4) around one edge after the other, in the order of the priority list.
//! \details Vertices of the star move, save those on boundaries; those beyond stay ("both alpha and beta are
//! set zero when the index does not exist"). An edge that an earlier region's minimisation brought into the
//! interval is passed over, as Algorithm 3 asks for an edge's length at its turn.
LocalTotals optimise_locally(VertexStars& stars, const LocalOptions& options);

//! The energy of the region around an edge. `moving_vertices` receives the vertex of each moving point.
void region_energy(const VertexStars& stars, RingSearch& search, StarEdge edge, const LocalOptions& options,
                   EdgeEnergy& energy, std::vector<VertexIndex>& moving_vertices);

}  // namespace nanocarbon::thesis
