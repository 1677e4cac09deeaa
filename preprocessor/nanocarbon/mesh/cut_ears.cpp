// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/cut_ears.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <queue>

#include "nanocarbon/mesh/measures.h"

namespace nanocarbon::mesh {
namespace {

using Vec2 = Eigen::Vector2d;

double twice_area(const Vec2& a, const Vec2& b, const Vec2& c) {
  return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
}

// 1 for an equilateral triangle, 0 for one without area, negative for a turned one.
double shape(const Vec2& a, const Vec2& b, const Vec2& c) {
  const double sides = (b - a).squaredNorm() + (c - b).squaredNorm() + (a - c).squaredNorm();
  return sides > 0.0 ? 3.4641016151377544 * twice_area(a, b, c) / sides : 0.0;
}

bool holds(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& p) {
  return twice_area(a, b, p) >= 0.0 && twice_area(b, c, p) >= 0.0 && twice_area(c, a, p) >= 0.0;
}

std::vector<Vec2> project(std::span<const Vec3> points, std::span<const VertexIndex> corners) {
  const Vec3 origin = points[corners[0]];
  Vec3 normal = newell_normal(points, corners);
  if (normal.squaredNorm() == 0.0) normal = Vec3::UnitZ();
  const Vec3 x = normal.unitOrthogonal();
  const Vec3 y = normal.normalized().cross(x);
  std::vector<Vec2> flat;
  flat.reserve(corners.size());
  for (const VertexIndex v : corners) flat.emplace_back(x.dot(points[v] - origin), y.dot(points[v] - origin));
  return flat;
}

class EarCutter {
 public:
  EarCutter(std::vector<Vec2> flat, std::span<const VertexIndex> corners, std::vector<Triangle>& triangles)
      : flat_(std::move(flat)), corners_(corners), triangles_(triangles), stamp_(corners.size(), 0) {
    const std::size_t n = corners.size();
    for (std::size_t i = 0; i < n; ++i) {
      previous_.push_back((i + n - 1) % n);
      next_.push_back((i + 1) % n);
    }
    for (std::size_t i = 0; i < n; ++i)
      if (turn(i) <= 0.0) not_convex_.push_back(i);
  }

  void cut() {
    for (std::size_t i = 0; i < corners_.size(); ++i) consider(i);
    std::size_t left = corners_.size();
    std::size_t at = 0;
    while (left > 3 && !ears_.empty()) {
      const Ear ear = ears_.top();
      ears_.pop();
      if (ear.stamp != stamp_[ear.corner]) continue;
      at = previous_[ear.corner];
      remove(ear.corner);
      --left;
      consider(at);
      consider(next_[at]);
    }
    // What has no ears left (only a polygon that crosses itself, or has no area) becomes a fan.
    for (; left >= 3; --left) remove(next_[at]);
  }

 private:
  struct Ear {
    double shape;
    std::size_t corner;
    std::uint32_t stamp;
    bool operator<(const Ear& other) const {
      return shape != other.shape ? shape < other.shape : corner > other.corner;
    }
  };

  double turn(std::size_t i) const { return twice_area(flat_[previous_[i]], flat_[i], flat_[next_[i]]); }

  void consider(std::size_t i) {
    ++stamp_[i];
    if (turn(i) <= 0.0) return;
    // A corner that has become convex blocks no ear any more.
    if (const auto at = std::lower_bound(not_convex_.begin(), not_convex_.end(), i);
        at != not_convex_.end() && *at == i)
      not_convex_.erase(at);
    const Vec2 &a = flat_[previous_[i]], &b = flat_[i], &c = flat_[next_[i]];
    const Vec2 low = a.cwiseMin(b).cwiseMin(c), high = a.cwiseMax(b).cwiseMax(c);
    for (const std::size_t j : not_convex_) {
      const Vec2& p = flat_[j];
      if (p.x() < low.x() || p.x() > high.x() || p.y() < low.y() || p.y() > high.y()) continue;
      if (p != a && p != b && p != c && holds(a, b, c, p)) return;
    }
    ears_.push({shape(a, b, c), i, stamp_[i]});
  }

  void remove(std::size_t i) {
    triangles_.push_back({corners_[previous_[i]], corners_[i], corners_[next_[i]]});
    next_[previous_[i]] = next_[i];
    previous_[next_[i]] = previous_[i];
    ++stamp_[i];
  }

  std::vector<Vec2> flat_;
  std::span<const VertexIndex> corners_;
  std::vector<Triangle>& triangles_;
  std::vector<std::size_t> previous_, next_;
  std::vector<std::size_t> not_convex_;  // sorted; cut off as ears are only convex corners
  std::vector<std::uint32_t> stamp_;
  std::priority_queue<Ear> ears_;
};

}  // namespace

void cut_ears(std::span<const Vec3> points, std::span<const VertexIndex> corners,
              std::vector<Triangle>& triangles) {
  if (corners.size() == 3) {
    triangles.push_back({corners[0], corners[1], corners[2]});
    return;
  }
  std::vector<Vec2> flat = project(points, corners);
  if (corners.size() == 4) {
    const auto worst = [&](std::size_t i, std::size_t j, std::size_t k, std::size_t l) {
      return std::min(shape(flat[i], flat[j], flat[k]), shape(flat[k], flat[l], flat[i]));
    };
    const std::size_t first = worst(0, 1, 2, 3) >= worst(1, 2, 3, 0) ? 0 : 1;
    triangles.push_back({corners[first], corners[first + 1], corners[first + 2]});
    triangles.push_back({corners[first + 2], corners[(first + 3) % 4], corners[first]});
    return;
  }
  EarCutter(std::move(flat), corners, triangles).cut();
}

}  // namespace nanocarbon::mesh
