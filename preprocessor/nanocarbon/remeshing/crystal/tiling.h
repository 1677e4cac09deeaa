// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "nanocarbon/core/thread_team.h"
#include "nanocarbon/remeshing/crystal/corner_table.h"
#include "nanocarbon/remeshing/crystal/surface_guide.h"

namespace nanocarbon::crystal {

inline constexpr VertexIndex free_vertex = std::numeric_limits<VertexIndex>::max();

//! A triangulation whose vertices are tied to a surface: the state that crystallisation works on.
struct Tiling {
  const SurfaceGuide* guide = nullptr;  //!< the surface; outlives the tiling
  CornerTable table;
  std::vector<Vec3> points;   //!< on the surface
  std::vector<Vec3> normals;  //!< of the surface at the points, smoothed
  //! Where on the guide a point is: a triangle for inner vertices, a boundary half-edge for boundary
  //! vertices.
  std::vector<std::uint32_t> places;
  //! Of a part of a tiling, the whole's numbers of vertices that stay as they are, with their valence;
  //! free_vertex for others. Empty: none is held.
  std::vector<VertexIndex> held = {};
  ThreadTeam* team = nullptr;  //!< that works on it; may be null

  bool is_held(VertexIndex v) const { return !held.empty() && held[v] != free_vertex; }
  const Space& space() const { return guide->space(); }
  //! What leads from one vertex to another.
  Vec3 between(VertexIndex from, VertexIndex to) const {
    return space().displacement(points[from], points[to]);
  }
};

//! The guide's own mesh as a tiling. The guide is referred to, not copied.
Tiling tiling_of(const SurfaceGuide& guide);
//! Moves a vertex to the surface (a boundary vertex to the boundary) near p.
void place_vertex(Tiling& tiling, VertexIndex v, const Vec3& p);
//! Moves every vertex to the nearest point of the surface that faces the same way; takes the guide's normals
//! anew.
void settle_on_surface(Tiling& tiling);
//! Drops the holes that collapses left.
void compact(Tiling& tiling);
//! \brief Renumbers vertices and triangles so that what follows each other is near each other on the surface.
//! \details Breadth first (Cuthill and McKee 1969): long arrays are then read nearly in a row.
//! \pre compact; no vertex is held
void put_in_order(Tiling& tiling);
TriangleMesh to_mesh(const Tiling& tiling);

double mean_edge_length(const Tiling& tiling);

}  // namespace nanocarbon::crystal
