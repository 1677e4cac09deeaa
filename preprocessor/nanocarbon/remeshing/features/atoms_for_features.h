// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <optional>

#include "nanocarbon/remeshing/features/feature_size.h"

namespace nanocarbon::features {

//! \brief The next number of atoms that a shape with features that are too small may be asked to hold.
//!
//! The smallest number of two digits, within what was searched, that check_features() itself has nothing
//! against. An enlargement computed from a problem alone is wrong either way, for normals are smoothed over a
//! length that does not grow with the shape. For the same reason a still larger number may be refused again,
//! where a groove that had been smoothed over shows as a gap.
//! \param surface in Angstrom, with problems at this size
//! \param atoms that it has room for, not rounded
//! \return none where no number up to 300,000, or four times those, would do, as for a long wedge sharper
//! than 30 degrees
std::optional<std::size_t> atoms_for_features(const TriangleMesh& surface, double atoms,
                                              const FeatureLimits& limits = {}, unsigned threads = 1);

}  // namespace nanocarbon::features
