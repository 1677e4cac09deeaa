// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <optional>

#include "nanocarbon/remeshing/features/feature_size.h"

namespace nanocarbon::features {

struct AtomsForFeatures {
  std::optional<std::size_t> atoms;  //!< none where no number that was looked at would do
  double most = 0;                   //!< the largest number that would have been taken
};

//! \brief The next number of atoms that a shape with features that are too small may be asked to hold.
//!
//! A number of two digits that check_features() itself has nothing against. It follows from the thinnest places
//! as they were seen, and is checked; where that takes fewer than 300,000 triangles in all, smaller numbers are
//! tried, too, and the result is the smallest, within what was searched. For normals are smoothed over a length
//! that does not grow with the shape, so that the places look different at another size. For the same reason a
//! still larger number may be refused again, where a groove that had been smoothed over shows as a gap.
//! \param surface in Angstrom, with problems at this size
//! \param atoms that it has room for, not rounded
//! \param report what check_features() said of it
//! \return none where no number up to 300,000, or four times those, was found, as for a long wedge sharper
//! than 30 degrees
AtomsForFeatures atoms_for_features(const TriangleMesh& surface, double atoms, const FeatureReport& report,
                                    const FeatureLimits& limits = {}, unsigned threads = 1);

}  // namespace nanocarbon::features
