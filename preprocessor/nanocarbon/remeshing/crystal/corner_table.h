// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "nanocarbon/mesh/triangle_mesh.h"

namespace nanocarbon::crystal {

//! Half-edge 3t + i runs from corner i of triangle t to the next corner, counter-clockwise.
using HalfEdgeIndex = std::uint32_t;
inline constexpr HalfEdgeIndex no_half_edge = std::numeric_limits<HalfEdgeIndex>::max();

//! \brief Connectivity of an oriented 2-manifold triangle mesh as flat arrays, with the three local
//! operations.
//! \details A corner table (Rossignac, Safonova, Szymczak 2001). It knows no positions; who moves, merges or
//! adds vertices keeps those beside it. Triangles and vertices that a collapse removed stay as holes until
//! compact().
class CornerTable {
 public:
  CornerTable() = default;
  //! \pre oriented 2-manifold, with or without boundary (as load_surface() returns it)
  explicit CornerTable(const TriangleMesh& mesh);

  std::size_t vertices() const { return outgoing_.size(); }  //!< with holes
  std::size_t half_edges() const { return origin_.size(); }  //!< with holes
  std::size_t live_vertices() const { return live_vertices_; }
  std::size_t live_triangles() const { return live_triangles_; }
  bool alive(HalfEdgeIndex h) const { return origin_[h] != dead; }
  bool vertex_alive(VertexIndex v) const { return outgoing_[v] != no_half_edge; }

  static HalfEdgeIndex next(HalfEdgeIndex h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static HalfEdgeIndex previous(HalfEdgeIndex h) { return h % 3 == 0 ? h + 2 : h - 1; }
  HalfEdgeIndex twin(HalfEdgeIndex h) const { return twin_[h]; }  //!< no_half_edge at the boundary
  VertexIndex origin(HalfEdgeIndex h) const { return origin_[h]; }
  VertexIndex target(HalfEdgeIndex h) const { return origin_[next(h)]; }
  VertexIndex apex(HalfEdgeIndex h) const {
    return origin_[previous(h)];
  }  //!< the corner opposite to the edge
  //! A half-edge that starts at v: at a boundary vertex the one without twin, so that turning
  //! counter-clockwise from it meets every triangle at v.
  HalfEdgeIndex outgoing(VertexIndex v) const { return outgoing_[v]; }
  bool on_boundary(VertexIndex v) const { return twin_[outgoing_[v]] == no_half_edge; }
  int valence(VertexIndex v) const { return valence_[v]; }  //!< number of neighbours
  bool adjacent(VertexIndex a, VertexIndex b) const;
  //! True once for every edge, over all half-edges.
  bool is_edge(HalfEdgeIndex h) const { return alive(h) && (twin_[h] == no_half_edge || h < twin_[h]); }

  //! Calls f(h) for every live half-edge that starts at v, counter-clockwise.
  template <class F>
  void for_outgoing(VertexIndex v, F&& f) const {
    const HalfEdgeIndex first = outgoing_[v];
    HalfEdgeIndex h = first;
    do {
      const HalfEdgeIndex following = twin_[previous(h)];
      f(h);
      h = following;
    } while (h != first && h != no_half_edge);
  }
  //! Calls f(u) for every neighbour u of v, counter-clockwise.
  template <class F>
  void for_neighbours(VertexIndex v, F&& f) const {
    for_outgoing(v, [&](HalfEdgeIndex h) {
      f(target(h));
      if (twin_[previous(h)] == no_half_edge) f(apex(h));
    });
  }

  //! Inner edge whose flip would make no double edge.
  bool can_flip(HalfEdgeIndex h) const;
  void flip(HalfEdgeIndex h);
  //! Link condition: merging the ends of the edge keeps the surface a manifold of the same topology.
  bool can_collapse(HalfEdgeIndex h) const;
  //! Merges origin(h) into target(h).
  void collapse(HalfEdgeIndex h);
  //! Puts a new vertex on the edge and returns it.
  VertexIndex split(HalfEdgeIndex h);
  //! Drops the holes. Returns for every vertex that is left its former index, in rising order.
  std::vector<VertexIndex> compact();
  std::vector<Triangle> triangles() const;

 private:
  static constexpr VertexIndex dead = std::numeric_limits<VertexIndex>::max();
  void link(HalfEdgeIndex a, HalfEdgeIndex b);
  void settle_outgoing(VertexIndex v, HalfEdgeIndex h);
  HalfEdgeIndex add_triangle(VertexIndex a, VertexIndex b, VertexIndex c);
  void remove_triangle(HalfEdgeIndex h);

  std::vector<VertexIndex> origin_;
  std::vector<HalfEdgeIndex> twin_;
  std::vector<HalfEdgeIndex> outgoing_;
  std::vector<int> valence_;
  std::size_t live_vertices_ = 0;
  std::size_t live_triangles_ = 0;
};

}  // namespace nanocarbon::crystal
