// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "nanocarbon/mesh/triangle_mesh.h"

namespace nanocarbon::shapes {

// Surfaces that go on for ever, as meshes in a periodic cell. Lengths in mesh units; UserError (usage) as in
// shapes.h.

//! A triply periodic minimal surface by its nodal approximation (von Schnering and Nesper 1991), or a parallel
//! of it.
struct MinimalSurface {
  enum class Kind { gyroid, schwarz_p, schwarz_d, iwp, neovius, frd, fischer_koch_s, lidinoid };
  Kind kind = Kind::gyroid;
  double period = 1.0;                   //!< edge of the cubic cell
  std::array<int, 3> cells = {1, 1, 1};  //!< along each edge of the cell
  bool primitive = false;                //!< the least cell in place of the cube, where that is centred
  double level = 0.0;                    //!< value of the nodal function on the surface; 0: the minimal one
  double edge = 0.04;                    //!< about the edges of the triangles
};
std::string_view name(MinimalSurface::Kind kind);
//! \throw UserError (usage) also where one cell has no two sides of its own, as the primitive cell of P's
//! lattice would
TriangleMesh make_minimal_surface(const MinimalSurface& surface);

//! \brief A random porous surface: where a Gaussian random field of one wave length has a given value (random_field.h).
//! \details Pieces that do not go through the cell are left out.
struct Foam {
  double size = 1.0;   //!< edge of the cubic cell
  double waves = 2.0;  //!< wave lengths along the edge, from 1
  double level = 0.0;  //!< in standard deviations of the field; 0: both sides take half of the space
  std::uint64_t seed = 1;
  std::optional<double> edge =
      {};  //!< about the edges of the triangles; 0.06 wave lengths where it is not given
  //! Of necks and walls, at least; a fifth of a wave length where it is not given; 0 for those of the field as it is.
  std::optional<double> thickness = {};
};
TriangleMesh make_foam(const Foam& foam);

}  // namespace nanocarbon::shapes
