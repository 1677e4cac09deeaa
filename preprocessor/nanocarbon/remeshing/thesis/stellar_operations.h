// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <limits>

#include "nanocarbon/remeshing/thesis/triangulation.h"

namespace nanocarbon::thesis {

//! What a stellar operation may not do. Valences already outside the bounds may stay, but not get worse.
struct StellarLimits {
  unsigned min_valence = 3;        //!< edges at a vertex; 3 is the least that a closed manifold can have
  unsigned max_valence = 12;       //!< edges at a vertex that a collapse or a flip adds to
  double min_normal_cosine = 0.2;  //!< least cosine between a face's normal before and after
  double max_edge =
      std::numeric_limits<double>::infinity();  //!< Angstrom; no edge may be made longer than this
};

//! Why an operation was not done; the mesh is then as it was.
enum class Refusal { none, deleted, boundary, link_condition, valence, fold_over, edge_too_long };

struct StellarOutcome {
  Refusal refusal = Refusal::none;
  VertexHandle vertex;  //!< the vertex that a collapse left or that a split made
  explicit operator bool() const { return refusal == Refusal::none; }
};

//! \name Stellar operations (thesis, section 3.5)
//! The only way connectivity is changed. Each keeps the surface a manifold of the same topology: same
//! components, genus and boundary loops, or refuses. Cost: the valences of the vertices touched.
//! @{

//! \brief Removes an edge; its ends become one vertex at the given position.
//! \details Asks for the link condition, which also forbids collapsing a tetrahedron, an edge across the
//! surface between two boundaries and a boundary of three edges. Where one end is on a boundary, that vertex
//! is the one that stays.
StellarOutcome collapse_edge(Triangulation& mesh, EdgeHandle edge, const Vec3& position,
                             const StellarLimits& limits);

//! Puts a new vertex at the given position, on or near the edge, joined to the vertices opposite. Never
//! folds.
StellarOutcome split_edge(Triangulation& mesh, EdgeHandle edge, const Vec3& position);

//! Replaces an inner edge by the one between the vertices opposite.
StellarOutcome flip_edge(Triangulation& mesh, EdgeHandle edge, const StellarLimits& limits);

//! @}

//! The position-free part of collapse_edge()'s checks: deleted, boundary, link condition, valences.
Refusal collapse_refusal(const Triangulation& mesh, EdgeHandle edge, const StellarLimits& limits);

//! All of flip_edge()'s checks.
Refusal flip_refusal(const Triangulation& mesh, EdgeHandle edge, const StellarLimits& limits);

}  // namespace nanocarbon::thesis
