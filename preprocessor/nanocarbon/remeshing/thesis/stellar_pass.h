// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "nanocarbon/remeshing/thesis/length_interval.h"
#include "nanocarbon/remeshing/thesis/stellar_operations.h"
#include "nanocarbon/remeshing/thesis/triangulation.h"

namespace nanocarbon::thesis {

//! Where a collapse or a split puts its vertex.
enum class StellarPosition {
  midpoint,     //!< the middle of the edge (Pecanha et al. 2013)
  least_error,  //!< where Eq. 4.1 is least on the edge (Hauck et al. 2014)
};

//! Which marks make a pass leave an edge alone.
enum class VisitedMarks {
  //! Where either end was touched: a vertex is moved at most once in a pass. With this the thesis's findings
  //! come out, on its own example: (p, s) of (0, 2) and (10, 2) do not converge, (0, 5), (10, 5) and (25, 5)
  //! do.
  either_end,
  //! Where both ends were touched, as Algorithm 3 prints it. Splits and collapses then feed each other: about
  //! 15% of the edges stay outside the interval for ever, and s = 5 is never reached.
  both_ends,
};

struct StellarOptions {
  LengthInterval interval;     //!< l_i, Angstrom
  double target_length = 0.0;  //!< m of Eq. 4.1, Angstrom
  StellarPosition position = StellarPosition::least_error;
  VisitedMarks marks = VisitedMarks::either_end;
  StellarLimits limits;
};

//! What a pass did.
struct StellarTotals {
  std::size_t candidates = 0;  //!< edges in the priority list
  std::size_t collapses = 0;
  std::size_t splits = 0;
  std::size_t refused = 0;  //!< collapses that would have broken or folded the surface
};

//! \brief The edges outside the interval, largest deviation from m_i first (Algorithm 2).
//! \details Sorted once at the end: the listing has SortDescent inside its loop, to the same effect. Equal
//! deviations stay in the order of the edges.
//! \param mean_length m_i, the mean edge of the mesh
std::vector<EdgeHandle> stellar_priority_list(const Triangulation& mesh, const LengthInterval& interval,
                                              double mean_length);

//! \brief One traversal of the list: short edges are collapsed, long ones split (Algorithm 3).
//! \details Lengths are those at the edge's turn. Both ends of an edge dealt with are marked, and the vertex
//! that a split makes; see VisitedMarks for what marks do. A collapse towards a boundary keeps the boundary
//! vertex where it is. Leaves the triangulation compact.
StellarTotals stellar_pass(Triangulation& mesh, const StellarOptions& options);

}  // namespace nanocarbon::thesis
