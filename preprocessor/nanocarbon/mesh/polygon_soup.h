// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "nanocarbon/core/cell.h"
#include "nanocarbon/core/vec3.h"
#include "nanocarbon/mesh/triangle_mesh.h"

namespace nanocarbon::mesh {

using FaceIndex = std::uint32_t;

//! What a mesh file holds, before anything is known about it: points, and faces as cycles of three or more of
//! them. Points are finite and corners are in range; nothing else is promised. Numbers count from 0 in file
//! order.
struct PolygonSoup {
  std::vector<Vec3> points;  //!< mesh units
  std::vector<std::uint32_t> offsets = {
      0};  //!< size faces + 1; face i has corners [offsets[i], offsets[i + 1])
  std::vector<VertexIndex> corners;
  std::vector<std::string> notes;  //!< what the reader passed over or joined, for the user
  std::optional<Cell> cell = {};   //!< that the file says the mesh repeats itself in
  bool is_isosurface = false;      //!< of a scalar field in the file, which has no mesh
  std::string unit = {};           //!< of lengths, where the file has one, as it calls it: "metre"

  std::size_t faces() const { return offsets.size() - 1; }
  std::span<const VertexIndex> face(std::size_t i) const {
    return {corners.data() + offsets[i], corners.data() + offsets[i + 1]};
  }
  //! Ends the face made of the corners that were appended since the last face.
  void close_face() { offsets.push_back(static_cast<std::uint32_t>(corners.size())); }
};

//! The same mesh as a soup.
PolygonSoup soup_of(const TriangleMesh& mesh);

}  // namespace nanocarbon::mesh
