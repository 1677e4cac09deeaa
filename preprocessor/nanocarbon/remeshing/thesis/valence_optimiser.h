// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>

#include "nanocarbon/remeshing/crystal/valence_repair.h"
#include "nanocarbon/remeshing/thesis/stellar_operations.h"
#include "nanocarbon/remeshing/thesis/triangulation.h"

namespace nanocarbon::thesis {

//! How a vertex's deviation from its ideal valence counts.
enum class ValenceError {
  linear,     //!< |vl - 6|, Eq. 4.2 (Surazhsky and Gotsman 2003)
  quadratic,  //!< (vl - 6)^2, Eq. 4.3
};

struct ValenceOptions {
  ValenceError error = ValenceError::quadratic;
  bool repeat = true;  //!< until no flip improves anything; false for one pass over the edges
  StellarLimits limits;
};

struct ValenceTotals {
  std::size_t passes = 0;
  std::size_t flips = 0;
};

//! \brief Flips edges while that brings the valences of their four vertices nearer to the ideal (Algorithm
//! 4).
//! \details As printed the algorithm keeps a flip when the error stays equal, and then sets `improved`: it
//! would flip such an edge to and fro for ever. A flip is kept here only when the error falls, as the text of
//! section 4.2 says ("if the value is reduced, the operation is maintained"); the total error then falls by
//! at least one with each flip, so it ends. The error after is computed without flipping. Ideal is 6, and 4
//! on boundaries (Surazhsky and Gotsman; the thesis does not say).
ValenceTotals optimise_valences(Triangulation& mesh, const ValenceOptions& options);

//! Brings valences into 5 to 7 (valence_repair.h) in a compact triangulation: its own smoothed normals tell
//! which flips would fold it. No vertex moves.
crystal::ValenceRepair repair_valences(Triangulation& mesh);

}  // namespace nanocarbon::thesis
