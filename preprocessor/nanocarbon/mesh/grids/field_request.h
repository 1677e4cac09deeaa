// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>

namespace nanocarbon::mesh {

//! How an isosurface ends at the edges of its field, where that is not periodic.
enum class FieldEdge {
  closed,  //!< around what is above the level, half a step outside of the outermost values; where all of these are
           //!< above, around what is below
  above,  //!< around what is above, whatever the outermost values are
  below,  //!< the same around what is below
  open    //!< with a boundary
};

//! What is asked of a file that holds a scalar field instead of a mesh.
struct FieldRequest {
  std::optional<double> level = {};  //!< value of the field on the surface
  std::string array = {};            //!< which of several in the file; empty: the only one
  FieldEdge edge = FieldEdge::closed;
  std::array<bool, 3> periodic = {false, false, false};  //!< along the edges of the file's cell
};

}  // namespace nanocarbon::mesh
