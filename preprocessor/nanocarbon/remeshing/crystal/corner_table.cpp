// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/remeshing/crystal/corner_table.h"

#include <algorithm>

#include "nanocarbon/mesh/edge_table.h"

namespace nanocarbon::crystal {

CornerTable::CornerTable(const TriangleMesh& mesh)
    : outgoing_(mesh.points.size(), no_half_edge), valence_(mesh.points.size(), 0) {
  origin_.reserve(3 * mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) origin_.insert(origin_.end(), t.begin(), t.end());
  twin_.assign(origin_.size(), no_half_edge);
  const mesh::EdgeTable edges = mesh::edge_table(mesh::soup_of(mesh));
  for (std::size_t e = 0; e < edges.size(); ++e)
    if (const auto uses = edges.uses_of(e); uses.size() > 1) link(uses[0].corner, uses[1].corner);
  live_triangles_ = mesh.triangles.size();
  for (HalfEdgeIndex h = 0; h < origin_.size(); ++h) {
    HalfEdgeIndex& out = outgoing_[origin_[h]];
    if (out == no_half_edge || twin_[h] == no_half_edge) out = h;
    ++valence_[origin_[h]];
    if (twin_[h] == no_half_edge) ++valence_[target(h)];
  }
  live_vertices_ = vertices() - std::count(outgoing_.begin(), outgoing_.end(), no_half_edge);
}

bool CornerTable::adjacent(VertexIndex a, VertexIndex b) const {
  bool found = false;
  for_neighbours(a, [&](VertexIndex u) { found = found || u == b; });
  return found;
}

void CornerTable::link(HalfEdgeIndex a, HalfEdgeIndex b) {
  if (a != no_half_edge) twin_[a] = b;
  if (b != no_half_edge) twin_[b] = a;
}

//! Turns clockwise from h, which starts at v, to the boundary or all the way round.
void CornerTable::settle_outgoing(VertexIndex v, HalfEdgeIndex h) {
  const HalfEdgeIndex first = h;
  while (twin_[h] != no_half_edge) {
    h = next(twin_[h]);
    if (h == first) break;
  }
  outgoing_[v] = h;
}

bool CornerTable::can_flip(HalfEdgeIndex h) const {
  const HalfEdgeIndex o = twin_[h];
  if (o == no_half_edge) return false;
  const VertexIndex c = apex(h);
  const VertexIndex d = apex(o);
  return c != d && !adjacent(c, d);
}

void CornerTable::flip(HalfEdgeIndex h) {
  // Triangles (a, b, c) and (b, a, d) become (a, d, c) and (b, c, d).
  const HalfEdgeIndex o = twin_[h];
  const HalfEdgeIndex h_next = next(h), o_next = next(o);
  const VertexIndex a = origin_[h], b = origin_[o], c = apex(h), d = apex(o);
  const HalfEdgeIndex outside_ad = twin_[o_next];
  const HalfEdgeIndex outside_bc = twin_[h_next];
  origin_[h_next] = d;
  origin_[o_next] = c;
  link(h, outside_ad);
  link(o, outside_bc);
  link(h_next, o_next);
  if (outgoing_[a] == o_next) outgoing_[a] = h;
  if (outgoing_[b] == h_next) outgoing_[b] = o;
  --valence_[a];
  --valence_[b];
  ++valence_[c];
  ++valence_[d];
}

bool CornerTable::can_collapse(HalfEdgeIndex h) const {
  const HalfEdgeIndex o = twin_[h];
  const VertexIndex a = origin_[h], b = target(h);
  if (live_vertices_ <= 4) return false;
  if (o != no_half_edge && on_boundary(a) && on_boundary(b)) return false;
  // No triangle at the edge may lose both its other sides to the boundary, and no inner apex may end with
  // valence 2.
  for (const HalfEdgeIndex side : {h, o}) {
    if (side == no_half_edge) continue;
    if (twin_[next(side)] == no_half_edge && twin_[previous(side)] == no_half_edge) return false;
    if (valence_[apex(side)] <= (on_boundary(apex(side)) ? 2 : 3)) return false;
  }
  int common = 0;
  for_neighbours(a, [&](VertexIndex u) { common += adjacent(u, b) ? 1 : 0; });
  return common == (o == no_half_edge ? 1 : 2);
}

void CornerTable::collapse(HalfEdgeIndex h) {
  const HalfEdgeIndex o = twin_[h];
  const VertexIndex a = origin_[h], b = target(h);
  const int common = o == no_half_edge ? 1 : 2;
  HalfEdgeIndex k = outgoing_[a];
  const HalfEdgeIndex first = k;
  do {
    const HalfEdgeIndex following = twin_[previous(k)];
    origin_[k] = b;
    k = following;
  } while (k != first && k != no_half_edge);
  HalfEdgeIndex leaves_b = no_half_edge;
  for (const HalfEdgeIndex side : {h, o}) {
    if (side == no_half_edge) continue;
    const VertexIndex c = apex(side);
    const HalfEdgeIndex leaves_c = twin_[next(side)];  // from c to b; its other side is gone
    const HalfEdgeIndex reaches_c = twin_[previous(side)];
    link(leaves_c, reaches_c);
    --valence_[c];
    remove_triangle(side);
    settle_outgoing(c, leaves_c != no_half_edge ? leaves_c : next(reaches_c));
    leaves_b = reaches_c != no_half_edge ? reaches_c : next(leaves_c);
  }
  valence_[b] += valence_[a] - 2 - common;
  outgoing_[a] = no_half_edge;
  --live_vertices_;
  settle_outgoing(b, leaves_b);
}

void CornerTable::remove_triangle(HalfEdgeIndex h) {
  const HalfEdgeIndex first = h - h % 3;
  for (HalfEdgeIndex k = first; k < first + 3; ++k) {
    origin_[k] = dead;
    twin_[k] = no_half_edge;
  }
  --live_triangles_;
}

HalfEdgeIndex CornerTable::add_triangle(VertexIndex a, VertexIndex b, VertexIndex c) {
  const HalfEdgeIndex h = static_cast<HalfEdgeIndex>(origin_.size());
  origin_.insert(origin_.end(), {a, b, c});
  twin_.insert(twin_.end(), 3, no_half_edge);
  ++live_triangles_;
  return h;
}

VertexIndex CornerTable::split(HalfEdgeIndex h) {
  // Triangle (a, b, c) becomes (a, m, c) and (m, b, c); the same with a and b exchanged on the other side.
  const HalfEdgeIndex o = twin_[h];
  const VertexIndex b = target(h), c = apex(h);
  const VertexIndex m = static_cast<VertexIndex>(outgoing_.size());
  const HalfEdgeIndex outside_bc = twin_[next(h)];
  const HalfEdgeIndex fresh = add_triangle(m, b, c);
  origin_[next(h)] = m;
  link(fresh + 1, outside_bc);
  link(fresh + 2, next(h));
  outgoing_.push_back(fresh);
  valence_.push_back(o == no_half_edge ? 3 : 4);
  ++live_vertices_;
  ++valence_[c];
  if (outgoing_[b] == next(h)) outgoing_[b] = fresh + 1;
  if (o != no_half_edge) {
    // (b, a, d) becomes (m, a, d), kept at o, and (b, m, d).
    const VertexIndex d = apex(o);
    const HalfEdgeIndex outside_db = twin_[previous(o)];
    const HalfEdgeIndex other = add_triangle(b, m, d);
    origin_[o] = m;
    link(other + 2, outside_db);
    link(other + 1, previous(o));
    link(h, o);
    link(fresh, other);
    ++valence_[d];
    if (outgoing_[b] == o) outgoing_[b] = other;
    if (outgoing_[d] == previous(o)) outgoing_[d] = other + 2;
  }
  return m;
}

std::vector<VertexIndex> CornerTable::compact() {
  std::vector<VertexIndex> former, place(vertices(), dead);
  for (VertexIndex v = 0; v < vertices(); ++v)
    if (vertex_alive(v)) {
      place[v] = static_cast<VertexIndex>(former.size());
      former.push_back(v);
    }
  std::vector<HalfEdgeIndex> moved(origin_.size(), no_half_edge);
  HalfEdgeIndex free = 0;
  for (HalfEdgeIndex h = 0; h < origin_.size(); ++h)
    if (alive(h)) moved[h] = free++;
  for (HalfEdgeIndex h = 0; h < moved.size(); ++h) {
    if (moved[h] == no_half_edge) continue;
    origin_[moved[h]] = place[origin_[h]];
    twin_[moved[h]] = twin_[h] == no_half_edge ? no_half_edge : moved[twin_[h]];
  }
  origin_.resize(free);
  twin_.resize(free);
  for (std::size_t k = 0; k < former.size(); ++k) {
    outgoing_[k] = moved[outgoing_[former[k]]];
    valence_[k] = valence_[former[k]];
  }
  outgoing_.resize(former.size());
  valence_.resize(former.size());
  return former;
}

std::vector<Triangle> CornerTable::triangles() const {
  std::vector<Triangle> result;
  result.reserve(live_triangles_);
  for (HalfEdgeIndex h = 0; h < origin_.size(); h += 3)
    if (alive(h)) result.push_back({origin_[h], origin_[h + 1], origin_[h + 2]});
  return result;
}

}  // namespace nanocarbon::crystal
