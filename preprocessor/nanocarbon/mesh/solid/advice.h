// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string>

#include "nanocarbon/mesh/polygon_soup.h"

namespace nanocarbon::mesh {

//! What makes a mesh usable that is not, or keeps it from crossing itself.
struct MeshAdvice {
  std::string options;  //!< of the command line, such as "--wrap 0.5"
  std::string outcome;  //!< what the mesh is with them, a sentence
};

//! \brief The options that make a mesh usable, tried before they are advised: a union where solids overlap, with
//! their holes closed if these are small; else a wrap, of a size that keeps the most of the shape without getting
//! in by what is missing, or, around sheets, a shell that is thick enough to see. Of a mesh that is usable but crosses
//! itself, whether it can be untangled.
//! \return nothing for a mesh that is usable and does not cross itself, for one that nothing helps, and where this was built without CGAL
std::optional<MeshAdvice> advise(const PolygonSoup& soup);

}  // namespace nanocarbon::mesh
