// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "nanocarbon/mesh/polygon_soup.h"
#include "nanocarbon/mesh/triangle_mesh.h"

namespace nanocarbon::mesh {

//! What may become of a surface where it crosses itself.
enum class Handles {
  keep,       //!< only what leaves its genus as it is
  give_away,  //!< handles may go, and pieces come apart
};

//! \brief A surface with new triangles where it crosses itself: CGAL's remove_self_intersections, which smooths the
//! surface there or cuts it out and fills the hole, with up to seven rings of faces around it.
//! \param examined faces among which crossings are looked for
//! \return nothing where crossings remain, or the attempt failed
//! \throw UserError (usage) where this was built without CGAL
//! \pre manifold, consistently wound, every face has an area
std::optional<TriangleMesh> mend_crossings(const TriangleMesh& mesh, const std::vector<FaceIndex>& examined,
                                           Handles handles);

}  // namespace nanocarbon::mesh
