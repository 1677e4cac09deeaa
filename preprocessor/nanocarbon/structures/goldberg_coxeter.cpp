#include "nanocarbon/structures/goldberg_coxeter.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <set>

namespace nanocarbon {
namespace {

//! A point of the flat surface: its barycentric weights, times h^2 + h k + k^2, at the corners of a base
//! triangle.
struct FlatPoint {
  std::array<VertexIndex, 3> corner;
  std::array<std::int64_t, 3> weight;
};

//! The corner of the triangle on the other side of each directed edge.
using Opposite = std::map<std::pair<VertexIndex, VertexIndex>, VertexIndex>;

Opposite corners_opposite_edges(const TriangleMesh& base) {
  Opposite opposite;
  for (const Triangle& t : base.triangles)
    for (int c = 0; c < 3; ++c) opposite[{t[(c + 1) % 3], t[c]}] = t[(c + 2) % 3];
  return opposite;
}

//! Moves a point that lies across an edge of its triangle to the triangle there: with D the corner across the
//! edge A B, flattened out, C = A + B - D.
void fold_into_its_triangle(FlatPoint& p, const Opposite& opposite) {
  for (;;) {
    const auto lowest = std::min_element(p.weight.begin(), p.weight.end()) - p.weight.begin();
    const std::int64_t outside = p.weight[lowest];
    if (outside >= 0) return;
    const auto a = (lowest + 1) % 3, b = (lowest + 2) % 3;
    // The edge runs a -> b in this triangle, so b -> a in the other, whose corners are then (b, a, D).
    const VertexIndex across = opposite.at({p.corner[a], p.corner[b]});
    p = {{p.corner[b], p.corner[a], across}, {p.weight[b] + outside, p.weight[a] + outside, -outside}};
  }
}

//! What names a point in the same way from whichever triangle it is seen: its corners of non-zero weight,
//! sorted.
using Name = std::array<std::int64_t, 6>;

Name name_of(const FlatPoint& p) {
  std::array<std::pair<std::int64_t, std::int64_t>, 3> parts;
  for (std::size_t c = 0; c < 3; ++c)
    parts[c] = p.weight[c] ? std::pair<std::int64_t, std::int64_t>(p.corner[c], p.weight[c])
                           : std::pair<std::int64_t, std::int64_t>(-1, 0);
  std::sort(parts.begin(), parts.end());
  return {parts[0].first, parts[0].second, parts[1].first, parts[1].second, parts[2].first, parts[2].second};
}

class Subdivision {
 public:
  Subdivision(const TriangleMesh& base, int h, int k)
      : base_(base),
        opposite_(corners_opposite_edges(base)),
        h_(h),
        k_(k),
        total_(h_ * h_ + h_ * k_ + k_ * k_) {
    mesh_.points = base.points;
    for (VertexIndex v = 0; v < base.points.size(); ++v) index_[name_of({{v, v, v}, {total_, 0, 0}})] = v;
  }

  TriangleMesh run() {
    for (const Triangle& corners : base_.triangles) subdivide(corners);
    return std::move(mesh_);
  }

 private:
  //! Weights of the lattice point x + y w, w = exp(i pi / 3): (x + y w) / (h + k w) = (b + c w) / total.
  FlatPoint lattice_point(const Triangle& corners, std::int64_t x, std::int64_t y) const {
    const std::int64_t b = x * (h_ + k_) + y * k_, c = y * h_ - x * k_;
    return {corners, {total_ - b - c, b, c}};
  }

  VertexIndex vertex(FlatPoint p) {
    fold_into_its_triangle(p, opposite_);
    const auto [entry, added] = index_.try_emplace(name_of(p), static_cast<VertexIndex>(mesh_.points.size()));
    if (added) {
      Vec3 point = Vec3::Zero();
      for (std::size_t c = 0; c < 3; ++c)
        point += static_cast<double>(p.weight[c]) / static_cast<double>(total_) * base_.points[p.corner[c]];
      mesh_.points.push_back(point);
    }
    return entry->second;
  }

  void add(const std::array<FlatPoint, 3>& small) {
    // The base triangle that holds the centroid owns it; one centred on an edge is met from both sides.
    std::array<std::int64_t, 3> centroid{};
    for (const FlatPoint& p : small)
      for (std::size_t c = 0; c < 3; ++c) centroid[c] += p.weight[c];
    const std::int64_t lowest = *std::min_element(centroid.begin(), centroid.end());
    if (lowest < 0) return;
    Triangle triangle = {vertex(small[0]), vertex(small[1]), vertex(small[2])};
    if (lowest == 0) {
      Triangle turned = triangle;
      std::rotate(turned.begin(), std::min_element(turned.begin(), turned.end()), turned.end());
      if (!on_edges_.insert(turned).second) return;
    }
    mesh_.triangles.push_back(triangle);
  }

  void subdivide(const Triangle& corners) {
    // The corners of the base triangle in the lattice are 0, h + k w and (h + k w) w = -k + (h + k) w.
    for (std::int64_t y = -1; y <= h_ + k_; ++y)
      for (std::int64_t x = -k_ - 1; x <= h_; ++x) {
        add({lattice_point(corners, x, y), lattice_point(corners, x + 1, y),
             lattice_point(corners, x, y + 1)});
        add({lattice_point(corners, x + 1, y), lattice_point(corners, x + 1, y + 1),
             lattice_point(corners, x, y + 1)});
      }
  }

  const TriangleMesh& base_;
  Opposite opposite_;
  std::int64_t h_, k_, total_;
  TriangleMesh mesh_;
  std::map<Name, VertexIndex> index_;
  std::set<Triangle> on_edges_;
};

}  // namespace

TriangleMesh goldberg_coxeter(const TriangleMesh& base, int h, int k) {
  return Subdivision(base, h, k).run();
}

}  // namespace nanocarbon
