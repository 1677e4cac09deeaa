// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string_view>

#include "nanocarbon/core/quality.h"
#include "nanocarbon/core/thread_team.h"
#include "nanocarbon/mesh/triangle_mesh.h"

namespace nanocarbon::crystal {

//! What crystallise() is asked for. Nothing else needs a choice.
struct CrystalOptions {
  std::size_t faces = 10000;  //!< triangles wanted, one for each atom
  std::uint64_t seed = 1;
  Quality quality = Quality::good;
  //! Seeds that are tried until one leaves no fold and no wrong valence; the best result is kept. At least 1.
  int attempts = 3;
  ThreadTeam* team = nullptr;  //!< that works on it; may be null
  //! Called now and then with the current stage and the fraction of the work done, 0 to 1.
  std::function<void(std::string_view stage, double share)> progress = {};
};

//! A triangulation of nearly equal edges and few defects, and how it was made.
struct CrystalResult {
  TriangleMesh mesh;   //!< on the surface; same topology, components and boundary
  double spacing = 0;  //!< edge length of the ideal crystal, in the unit of the surface
  //! Refinements after the coarsest level; 0 where the shape allowed no coarser one.
  int levels = 0;
  std::size_t defects = 0;  //!< inner vertices whose valence is not 6
  //! Inner vertices whose valence is outside 5 to 7: none wherever there are enough faces for the shape.
  std::size_t bad_valences = 0;
  std::size_t unsound = 0;  //!< vertices with a triangle turned against the surface or folded over
};

//! \brief The best starting triangulation for a carbon molecule on a surface.
//!
//! Isotropic remeshing, then the vertices are annealed as particles on the surface until they freeze into a
//! crystal. Where the shape allows, this is done with a quarter of the faces (or a quarter of that), and each
//! triangle is split in four: no new defects, and order over longer ranges than one level reaches. Then
//! remaining wrong valences are removed by flips and edge lengths are evened out. If a wrong valence or a
//! fold remains all the same, more seeds are tried, each of which takes as long; in large tilings only around
//! it.
//!
//! Linear in faces; the same for the same seed and any number of threads. Works in any unit.
//!
//! \param surface an oriented 2-manifold (mesh/formats/load_surface.h), closed or with boundary
//! \throw UserError (size) where the surface's topology cannot be kept with so few faces
CrystalResult crystallise(const TriangleMesh& surface, const CrystalOptions& options);

}  // namespace nanocarbon::crystal
