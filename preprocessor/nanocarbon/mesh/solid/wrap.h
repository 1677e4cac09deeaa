// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <string>

#include "nanocarbon/mesh/polygon_soup.h"
#include "nanocarbon/mesh/triangle_mesh.h"

namespace nanocarbon::mesh {

//! How closely a wrap follows a mesh. Mesh units.
struct WrapSize {
  static constexpr double sizes_in_offset = 30.0;  //!< where none is given

  double size = 0.0;    //!< radius of the ball that is rolled over the mesh: it does not enter narrower gaps
  double offset = 0.0;  //!< of the wrap from the mesh, outward
};

//! The size with its usual offset.
inline WrapSize wrap_size(double size) { return {size, size / WrapSize::sizes_in_offset}; }

//! A closed surface around a mesh.
struct Wrapped {
  TriangleMesh mesh;           //!< a closed 2-manifold that does not cross itself, wound outward
  std::size_t components = 0;  //!< of it
  std::size_t hairs = 0;     //!< faces of the mesh that were left out, since spikes would have become of them
  double to_original = 0.0;  //!< largest distance from the wrap to the mesh, mesh units
  double from_original = 0.0;  //!< from the mesh to the wrap: large where parts of the mesh are inside
};

//! \brief Puts a closed surface around anything: separate triangles, faces that are missing, parts that cross,
//! sheets without thickness.
//! \details A ball of radius `size` is rolled over the outside and cannot get in where gaps are narrower than
//! that; what lies within (cavities, inner components) has no surface in the wrap. It lies `offset` outside of the
//! mesh; where the mesh is a sheet, on both sides. Hairs are left out: faces narrower than a tenth of the offset with no
//! long side in common with another, where all of them together are less than a thousandth of the area.
//! \throw UserError (unsuitable) for a mesh without faces that have an area, (usage) for a size that would take
//! millions of faces or that is far from its offset, and as alpha_wrap()
Wrapped wrap(const PolygonSoup& soup, const WrapSize& size);

//! One sentence for people, beginning with "wrapped".
std::string describe(const Wrapped& wrapped, const WrapSize& size);

}  // namespace nanocarbon::mesh
