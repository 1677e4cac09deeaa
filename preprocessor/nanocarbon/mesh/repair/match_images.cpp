// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/repair/match_images.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <compare>
#include <map>
#include <set>

#include "nanocarbon/core/neighbours_within.h"

namespace nanocarbon::mesh {
namespace {

using Image = std::array<std::int32_t, 3>;

// Two vertices, and how far one is from an image of the other.
struct NearlySame {
  double distance;
  VertexIndex one, other;
  auto operator<=>(const NearlySame&) const = default;
};

class Matching {
 public:
  Matching(const TriangleMesh& mesh, const Cell& cell, std::span<const VertexIndex> boundary, double exactly,
           double reach)
      : mesh_(mesh), cell_(cell), boundary_(boundary), exactly_(exactly), reach_(reach) {
    for (const VertexIndex v : boundary) points_.push_back(mesh.points[v]);
    near_ = neighbours_within(points_, &cell, reach);
    result_.partners.resize(mesh.points.size());
  }

  ImageMatches run() {
    for_pairs([&](std::uint32_t i, const Neighbour& n, double distance) {
      if (distance <= exactly_) make_partners(boundary_[i], boundary_[n.atom]);
    });
    const std::array<bool, 3> inexact = inexact_directions();
    std::vector<NearlySame> pairs;
    for_pairs([&](std::uint32_t i, const Neighbour& n, double distance) {
      bool wanted = false;
      for (std::size_t d = 0; d < 3; ++d) wanted |= n.image[d] != 0 && inexact[d];
      if (wanted && distance > exactly_ && is_nearest(i, n, distance))
        pairs.push_back({distance, boundary_[i], boundary_[n.atom]});
    });
    if (!pairs.empty()) join(std::move(pairs));
    return std::move(result_);
  }

 private:
  using Partners = std::vector<std::vector<VertexIndex>>;

  template <class Visit>
  void for_pairs(const Visit& visit) const {
    for (std::uint32_t i = 0; i < points_.size(); ++i)
      for (const Neighbour& n : near_.of(i))
        if (n.image != Image{0, 0, 0} && n.atom != i) visit(i, n, distance(i, n));
  }
  double distance(std::uint32_t i, const Neighbour& n) const {
    return (points_[n.atom] + image_shift(cell_, n.image) - points_[i]).norm();
  }
  // Of all near by through the same image.
  bool is_nearest(std::uint32_t i, const Neighbour& n, double so_far) const {
    const auto row = near_.of(i);
    return std::none_of(row.begin(), row.end(), [&](const Neighbour& other) {
      return other.image == n.image && distance(i, other) < so_far;
    });
  }

  void make_partners(VertexIndex one, VertexIndex other) {
    result_.partners[one].push_back(other);
    result_.partners[other].push_back(one);
  }
  // A vertex and all that it is one with.
  std::vector<VertexIndex> all_of(VertexIndex v) const {
    std::vector<VertexIndex> all = {v};
    for (std::size_t k = 0; k < all.size(); ++k)
      for (const VertexIndex next : result_.partners[all[k]])
        if (std::find(all.begin(), all.end(), next) == all.end()) all.push_back(next);
    return all;
  }

  // Those in whose faces a boundary vertex lies on no image.
  std::array<bool, 3> inexact_directions() const {
    std::array<bool, 3> inexact = {false, false, false};
    const Mat3 to_fractional = cell_.vectors.inverse();
    const Vec3 heights = face_distances(cell_);
    for (const VertexIndex v : boundary_) {
      if (!result_.partners[v].empty()) continue;
      const Vec3 at = to_fractional * (mesh_.points[v] - cell_.origin);
      for (int d = 0; d < 3; ++d)
        inexact[static_cast<std::size_t>(d)] |=
            std::min(std::abs(at[d]), std::abs(at[d] - 1)) * heights[d] < reach_;
    }
    return inexact;
  }

  void join(std::vector<NearlySame> pairs) {
    std::sort(pairs.begin(), pairs.end());
    std::map<VertexIndex, std::set<VertexIndex>> neighbours;  // of every vertex that a pair may join
    for (const NearlySame& pair : pairs)
      for (const VertexIndex v : {pair.one, pair.other})
        for (const VertexIndex member : all_of(v)) neighbours.try_emplace(member);
    for (const Triangle& t : mesh_.triangles)
      for (std::size_t k = 0; k < 3; ++k)
        if (const auto found = neighbours.find(t[k]); found != neighbours.end())
          found->second.insert({t[(k + 1) % 3], t[(k + 2) % 3]});
    for (const NearlySame& pair : pairs) {
      const std::vector<VertexIndex> ours = all_of(pair.one), theirs = all_of(pair.other);
      if (std::find(ours.begin(), ours.end(), pair.other) != ours.end()) continue;
      const bool adjacent = std::any_of(ours.begin(), ours.end(), [&](VertexIndex v) {
        const std::set<VertexIndex>& beside = neighbours.at(v);
        return std::any_of(theirs.begin(), theirs.end(), [&](VertexIndex u) { return beside.count(u) > 0; });
      });
      if (adjacent) continue;
      make_partners(pair.one, pair.other);
      ++result_.nearly;
      result_.farthest = std::max(result_.farthest, pair.distance);
    }
  }

  const TriangleMesh& mesh_;
  const Cell& cell_;
  std::span<const VertexIndex> boundary_;
  const double exactly_, reach_;
  std::vector<Vec3> points_;
  NeighbourList near_;
  ImageMatches result_;
};

}  // namespace

ImageMatches match_images(const TriangleMesh& mesh, const Cell& cell, std::span<const VertexIndex> boundary,
                          double exactly, double reach) {
  return Matching(mesh, cell, boundary, exactly, reach).run();
}

}  // namespace nanocarbon::mesh
