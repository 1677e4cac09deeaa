// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "nanocarbon/mesh/triangle_mesh.h"
#include "nanocarbon/remeshing/thesis/triangulation.h"

namespace nanocarbon::thesis {

//! \brief The first stars (one-rings) of all vertices in compressed rows, and the points, side by side in
//! memory.
//! \details What the steps that move points work on: a snapshot of the connectivity of a compacted
//! triangulation.
struct VertexStars {
  std::vector<std::uint32_t> offsets;  //!< vertices + 1
  std::vector<VertexIndex>
      neighbours;  //!< counter-clockwise; at a boundary vertex from one boundary edge to the other
  std::vector<std::uint8_t> on_boundary;  //!< 1 for boundary vertices
  std::vector<Vec3> points;               //!< Angstrom

  std::size_t vertices() const { return points.size(); }
  std::span<const VertexIndex> of(std::size_t v) const {
    return {neighbours.data() + offsets[v], neighbours.data() + offsets[v + 1]};
  }
};

//! Below this many points threads cost more than they save.
constexpr std::ptrdiff_t least_points_for_threads = 20000;

//! \pre the triangulation is compact
VertexStars vertex_stars(const Triangulation& mesh);

//! Puts the points back.
//! \pre the triangulation has the connectivity it had when the stars were taken
void set_points(Triangulation& mesh, const VertexStars& stars);

//! The unit normal of a vertex, by the areas of its faces; zero where they cancel.
Vec3 vertex_normal(const VertexStars& stars, std::size_t vertex);

//! \brief The vertices around a start, ring by ring: breadth-first with stamps, no allocation once grown.
class RingSearch {
 public:
  explicit RingSearch(const VertexStars& stars) : stars_(stars), stamp_(stars.vertices(), 0) {}

  //! \brief All vertices up to the k-th ring around the start vertices, which are ring 0 and come first.
  //! \return valid until the next search; rings() tells where each ring begins
  std::span<const VertexIndex> search(std::span<const VertexIndex> start, unsigned rings);

  //! Ring r of the last search is [ring_begin(r), ring_begin(r + 1)) of what it returned.
  std::size_t ring_begin(unsigned ring) const { return begin_[ring]; }

  //! The place of a vertex in the last search's result, or -1.
  std::int32_t place(VertexIndex v) const {
    return stamp_[v] > base_ ? static_cast<std::int32_t>(stamp_[v] - base_ - 1) : -1;
  }

 private:
  const VertexStars& stars_;
  std::vector<std::uint64_t> stamp_;  // base_ + 1 + place for vertices found by the last search
  std::uint64_t base_ = 0;
  std::vector<VertexIndex> found_;
  std::vector<std::size_t> begin_;
};

}  // namespace nanocarbon::thesis
