// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "nanocarbon/mesh/polygon_soup.h"

namespace nanocarbon::mesh {

//! A face with the same vertices in the same cyclic order, or that order reversed, as an earlier one.
struct SameFace {
  FaceIndex face;
  FaceIndex earlier;
  bool same_winding;
};

//! All such faces, sorted by face. O(n log n).
std::vector<SameFace> same_faces(const PolygonSoup& soup);

}  // namespace nanocarbon::mesh
