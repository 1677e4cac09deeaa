// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "nanocarbon/mesh/triangle_mesh.h"

namespace nanocarbon::features {

//! What of a shape a carbon surface cannot follow. Angstrom.
enum class FeatureKind {
  thin_part,   //!< a limb narrower than the narrowest tube
  thin_wall,   //!< two sides of one solid closer than two sheets may be
  narrow_gap,  //!< outer sides, or a component within another, closer than two sheets may be
  small_hole   //!< a boundary loop around which atoms would bond across the hole
};
std::string_view name(FeatureKind kind);

//! How small features may be. Angstrom.
struct FeatureLimits {
  //! Of a limb: the (3,3) tube's, the narrowest that was ever seen to stand free. Measured: tori of
  //! this radius, of 1.7 and 1.4 hold for 5 ps at 600 K, of 1.0 not.
  double tube_radius = 2.0;
  //! Between two sheets, a little under graphite's 3.35. Measured: plates of 2.5 hold
  //! (with_room_for_sheets()), of 2.0 not.
  double sheet_distance = 3.0;
  //! Of a hole with a bare boundary: twice the area that its loop spans over the loop's length. Drafts of
  //! flat rings around holes of 2.5 to 5.0 Angstrom held, of 1.5 and 2.0 not; of 2.46 one failed with more atoms.
  double hole_radius = 3.0;
  //! Square Angstrom. Regions smaller than this are tips and corners, which a molecule rounds: every spike
  //! and every horn has one at any size.
  double least_area = 100.0;
};

//! A connected region of the surface that is too small in one way.
struct FeatureProblem {
  FeatureKind kind;
  Vec3 where;     //!< the place that decides, Angstrom
  double size;    //!< radius of the limb or hole, or distance of the sheets, there
  double needed;  //!< what it would have to be
  double area;    //!< of the region, square Angstrom
};

struct FeatureReport {
  std::vector<FeatureProblem> problems;  //!< the worst first
  //! \brief By how much lengths have to grow, at least, so that the thinnest places as they are seen at this size
  //! are no problem any more; 1 where nothing is.
  //! \details Within a percent. What is seen changes a little with the size, since normals are smoothed over a
  //! length that does not grow with the shape: check again at the larger size.
  double enlargement = 1;
  std::size_t facets = 0;  //!< triangles that were looked at
  bool ok() const { return problems.empty(); }
};

//! \brief Finds where a surface is too small to be held by carbon.
//!
//! From every place of the surface, the nearest place roughly parallel to it is sought along the normal,
//! inwards and outwards; its distance is the local thickness or the local gap. Sharp edges, however sharp up to
//! about 30 degrees, are not thin parts: their sides do not face opposite ways. Normals are smoothed over half
//! a ring, so that roughness below that size does not matter. A thick place counts as a limb where normals
//! all around its axis are met within its width. A boundary loop is a hole where the surface goes away from its
//! middle: the end of a tube and the outer boundary of a sheet are none. Of triangles within 0.6 Angstrom of each other that face the
//! same way one is asked for all.
//!
//! \param surface in Angstrom, scaled to hold the atoms
//! \param threads to use; they do not change the result
FeatureReport check_features(const TriangleMesh& surface, const FeatureLimits& limits = {},
                             unsigned threads = 1);

}  // namespace nanocarbon::features
