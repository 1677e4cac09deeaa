#pragma once

#include <cstdint>
#include <vector>

#include "nanocarbon/remeshing/corner_table.h"
#include "nanocarbon/remeshing/surface_guide.h"

namespace nanocarbon {

//! A triangulation whose vertices are tied to a surface: the state that crystallisation works on.
struct Tiling {
  const SurfaceGuide* guide = nullptr;  //!< the surface; outlives the tiling
  CornerTable table;
  std::vector<Vec3> points;   //!< on the surface
  std::vector<Vec3> normals;  //!< of the surface at the points, smoothed
  //! Where on the guide a point is: a triangle for inner vertices, a border half-edge for border vertices.
  std::vector<std::uint32_t> places;
};

//! The guide's own mesh as a tiling. The guide is referred to, not copied.
Tiling tiling_of(const SurfaceGuide& guide);
//! Moves a vertex to the surface (a border vertex to the border) near p.
void place_vertex(Tiling& tiling, VertexIndex v, const Vec3& p);
//! \brief Moves a vertex by this share of the way to the mean of its neighbours (a border vertex: of those on
//! the border), in the tangent plane, unless that would turn or fold triangles. \return whether it moved
bool relax_vertex(Tiling& tiling, VertexIndex v, double share);
//! Moves every vertex to the nearest point of the surface that faces the same way; takes the guide's normals
//! anew.
void settle_on_surface(Tiling& tiling);
//! Splits an edge at its midpoint, moved to the surface, unless that would turn a triangle. \return whether
//! it did
bool split_edge(Tiling& tiling, HalfEdge h);
//! Splits every triangle in four. New inner vertices have valence 6, others keep theirs.
void split_in_four(Tiling& tiling);
//! Drops the holes that collapses left.
void compact(Tiling& tiling);
TriangleMesh to_mesh(const Tiling& tiling);

double mean_edge_length(const Tiling& tiling);

}  // namespace nanocarbon
