// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/shapes/lattice_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace nanocarbon::shapes {
namespace {

using Weights = std::array<std::int64_t, 3>;

//! Times the piece's size; each is negative beyond the edge opposite its corner.
Weights weights(const LatticePiece& piece, Eisenstein at) {
  const auto& a = piece.at;
  return {cross(a[1] - at, a[2] - at), cross(a[2] - at, a[0] - at), cross(a[0] - at, a[1] - at)};
}

//! A piece's lattice carried over one of its edges: z becomes turn * z + shift there.
struct Crossing {
  std::size_t piece;
  Eisenstein turn, shift;
  Eisenstein operator()(Eisenstein z) const { return turn * z + shift; }
};

class Gluing {
 public:
  explicit Gluing(std::span<const LatticePiece> pieces) : pieces_(pieces), across_(pieces.size()) {
    std::map<std::pair<VertexIndex, VertexIndex>, std::pair<std::size_t, int>> sides;
    for (std::size_t p = 0; p < pieces.size(); ++p)
      for (int c = 0; c < 3; ++c) {
        const auto& corner = pieces[p].corner;
        sides[{corner[(c + 1) % 3], corner[(c + 2) % 3]}] = {p, c};
        surface_.vertices.resize(std::max<std::size_t>(surface_.vertices.size(), corner[c] + 1));
        surface_.vertices[corner[c]] = {p, pieces[p].at[c]};
      }
    for (const auto& [edge, side] : sides) {
      const auto& [p, c] = side;
      const auto& [q, d] = sides.at({edge.second, edge.first});
      const Eisenstein from = pieces[p].at[(c + 1) % 3], to = pieces[p].at[(c + 2) % 3];
      const Eisenstein from_there = pieces[q].at[(d + 2) % 3], to_there = pieces[q].at[(d + 1) % 3];
      const Eisenstein ratio = (to_there - from_there) * conjugate(to - from);
      const Eisenstein turn = {ratio.x / norm(to - from), ratio.y / norm(to - from)};
      across_[p][c] = {q, turn, from_there - turn * from};
    }
  }

  LatticeSurface run() {
    for (std::size_t p = 0; p < pieces_.size(); ++p) collect(p);
    return std::move(surface_);
  }

 private:
  //! The small triangles whose middle is in the piece, row by row.
  void collect(std::size_t p) {
    const auto& a = pieces_[p].at;
    const auto [low, high] = std::minmax({a[0].y, a[1].y, a[2].y});
    for (std::int64_t y = low - 1; y <= high; ++y)
      for (const int down : {0, 1}) {
        const double row = static_cast<double>(y) + (1 + down) / 3.0;
        const auto [first, last] = row_of(a, row);
        for (std::int64_t x = first; x <= last; ++x) {
          if (down)
            add(p, {Eisenstein{x + 1, y}, {x + 1, y + 1}, {x, y + 1}});
          else
            add(p, {Eisenstein{x, y}, {x + 1, y}, {x, y + 1}});
        }
      }
  }

  //! Where the line y = row is inside the triangle, rounded outward; add() tests exactly.
  static std::pair<std::int64_t, std::int64_t> row_of(const std::array<Eisenstein, 3>& a, double row) {
    double first = std::numeric_limits<double>::infinity(), last = -first;
    for (int c = 0; c < 3; ++c) {
      const Eisenstein p = a[c], q = a[(c + 1) % 3];
      if (p.y == q.y) continue;
      const double part = (row - static_cast<double>(p.y)) / static_cast<double>(q.y - p.y);
      if (part < 0.0 || part > 1.0) continue;
      const double x = static_cast<double>(p.x) + part * static_cast<double>(q.x - p.x);
      first = std::min(first, x), last = std::max(last, x);
    }
    if (first > last) return {0, -1};
    return {static_cast<std::int64_t>(std::floor(first)) - 1, static_cast<std::int64_t>(std::ceil(last))};
  }

  void add(std::size_t p, const std::array<Eisenstein, 3>& small) {
    // In thirds, so that the middle is a lattice point too.
    const Eisenstein middle = small[0] + small[1] + small[2];
    const auto& a = pieces_[p].at;
    const LatticePiece in_thirds = {
        pieces_[p].corner, {a[0] * Eisenstein{3, 0}, a[1] * Eisenstein{3, 0}, a[2] * Eisenstein{3, 0}}};
    const Weights w = weights(in_thirds, middle);
    const std::int64_t lowest = *std::min_element(w.begin(), w.end());
    if (lowest < 0) return;
    const Triangle triangle = {vertex(p, middle, small[0]), vertex(p, middle, small[1]),
                               vertex(p, middle, small[2])};
    if (lowest == 0) {  // it is met from the other side of the edge again
      Triangle turned = triangle;
      std::rotate(turned.begin(), std::min_element(turned.begin(), turned.end()), turned.end());
      if (!on_edges_.insert(turned).second) return;
    }
    surface_.triangles.push_back(triangle);
  }

  //! Follows the straight line from the middle of a small triangle (in thirds) to its corner, over edges as
  //! they come.
  VertexIndex vertex(std::size_t p, Eisenstein middle, Eisenstein at) {
    for (;;) {
      const auto& a = pieces_[p].at;
      const LatticePiece in_thirds = {
          pieces_[p].corner, {a[0] * Eisenstein{3, 0}, a[1] * Eisenstein{3, 0}, a[2] * Eisenstein{3, 0}}};
      const Weights start = weights(in_thirds, middle), end = weights(in_thirds, at * Eisenstein{3, 0});
      int exit = -1;  // the edge crossed first: with the least start / (start - end)
      for (int c = 0; c < 3; ++c)
        if (end[c] < 0 &&
            (exit < 0 || start[c] * (start[exit] - end[exit]) < start[exit] * (start[c] - end[c])))
          exit = c;
      if (exit < 0) return named(p, at);
      const Crossing& crossing = across_[p][exit];
      middle = crossing.turn * middle + crossing.shift * Eisenstein{3, 0};
      at = crossing(at);
      p = crossing.piece;
    }
  }

  //! The vertex at a lattice point in or on a piece. On an edge the piece of the lower number names
  //! it.
  VertexIndex named(std::size_t p, Eisenstein at) {
    const Weights w = weights(pieces_[p], at);
    for (int c = 0; c < 3; ++c)
      if (w[(c + 1) % 3] == 0 && w[(c + 2) % 3] == 0) return pieces_[p].corner[c];
    for (int c = 0; c < 3; ++c)
      if (w[c] == 0 && across_[p][c].piece < p) {
        at = across_[p][c](at);
        p = across_[p][c].piece;
        break;
      }
    const auto next = static_cast<VertexIndex>(surface_.vertices.size());
    const auto [entry, added] = index_.try_emplace({p, at}, next);
    if (added) surface_.vertices.push_back({p, at});
    return entry->second;
  }

  std::span<const LatticePiece> pieces_;
  std::vector<std::array<Crossing, 3>> across_;
  LatticeSurface surface_;
  std::map<std::pair<std::size_t, Eisenstein>, VertexIndex> index_;
  std::set<Triangle> on_edges_;
};

}  // namespace

LatticeSurface glue(std::span<const LatticePiece> pieces) { return Gluing(pieces).run(); }

std::array<double, 3> barycentric(const LatticePiece& piece, Eisenstein at) {
  const Weights w = weights(piece, at);
  const auto size = static_cast<double>(w[0] + w[1] + w[2]);
  return {static_cast<double>(w[0]) / size, static_cast<double>(w[1]) / size,
          static_cast<double>(w[2]) / size};
}

}  // namespace nanocarbon::shapes
