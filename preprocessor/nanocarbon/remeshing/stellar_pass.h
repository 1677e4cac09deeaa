#pragma once

#include <cstddef>
#include <vector>

#include "nanocarbon/remeshing/length_interval.h"
#include "nanocarbon/remeshing/stellar_operations.h"
#include "nanocarbon/remeshing/triangulation.h"

namespace nanocarbon {

//! Where a collapse or a split puts its vertex.
enum class StellarPosition {
  midpoint,     //!< the middle of the edge (Pecanha et al. 2013)
  least_error,  //!< where Eq. 4.1 is least on the edge (Hauck et al. 2014)
};

struct StellarOptions {
  LengthInterval interval;     //!< l_i, Angstrom
  double target_length = 0.0;  //!< m of Eq. 4.1, Angstrom
  StellarPosition position = StellarPosition::least_error;
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
//! deviations stay in the order of the edges. \param mean_length m_i, the mean edge of the mesh
std::vector<EdgeHandle> stellar_priority_list(const Triangulation& mesh, const LengthInterval& interval,
                                              double mean_length);

//! \brief One traversal of the list: short edges are collapsed, long ones split (Algorithm 3).
//! \details Lengths are those at the edge's turn. Edges whose ends have both been touched in this pass are
//! left. The vertex that a split makes counts as touched too, like the ends of its edge. A collapse towards a
//! border keeps the border vertex where it is. Leaves the triangulation compact.
StellarTotals stellar_pass(Triangulation& mesh, const StellarOptions& options);

}  // namespace nanocarbon
