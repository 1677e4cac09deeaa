// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/triangle_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace nanocarbon::mesh {
namespace {

constexpr std::size_t bins = 16;
constexpr std::uint32_t leaf_size = 4;
constexpr std::size_t deepest_heuristic_split = 60;  // further down by halves: at most 32 levels more

double half_area(const BoundingBox& box) {
  const Vec3 e = box.extent();
  return e.x() * e.y() + e.y() * e.z() + e.z() * e.x();
}

void include(BoundingBox& box, const BoundingBox& other) {
  box.low = box.low.cwiseMin(other.low);
  box.high = box.high.cwiseMax(other.high);
}

class Builder {
 public:
  explicit Builder(const TriangleMesh& mesh)
      : boxes_(mesh.triangles.size()), centres_(mesh.triangles.size()) {
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      for (const Vec3& corner : corners_in_cell(mesh, mesh.triangles[t])) boxes_[t].include(corner);
      centres_[t] = 0.5 * (boxes_[t].low + boxes_[t].high);
    }
    tree_.triangles.resize(mesh.triangles.size());
    std::iota(tree_.triangles.begin(), tree_.triangles.end(), 0u);
  }

  TriangleTree build() {
    if (tree_.triangles.empty()) return std::move(tree_);
    struct Task {
      std::uint32_t node, begin, end;
      std::size_t depth;
    };
    tree_.nodes.reserve(tree_.triangles.size());
    tree_.nodes.push_back({});
    std::vector<Task> tasks = {{0, 0, static_cast<std::uint32_t>(tree_.triangles.size()), 0}};
    while (!tasks.empty()) {
      const auto [node, begin, end, depth] = tasks.back();
      tasks.pop_back();
      tree_.nodes[node].box = box_of(begin, end);
      if (end - begin <= leaf_size) {
        tree_.nodes[node].first = begin;
        tree_.nodes[node].count = end - begin;
        continue;
      }
      const std::uint32_t middle = split(begin, end, depth);
      const auto child = static_cast<std::uint32_t>(tree_.nodes.size());
      tree_.nodes[node].first = child;
      tree_.nodes[node].count = 0;
      tree_.nodes.resize(tree_.nodes.size() + 2);
      tasks.push_back({child + 1, middle, end, depth + 1});
      tasks.push_back({child, begin, middle, depth + 1});
    }
    return std::move(tree_);
  }

 private:
  BoundingBox box_of(std::uint32_t begin, std::uint32_t end) const {
    BoundingBox box;
    for (std::uint32_t i = begin; i < end; ++i) include(box, boxes_[tree_.triangles[i]]);
    return box;
  }

  // Reorders [begin, end) and returns where its second half begins; neither half is empty.
  std::uint32_t split(std::uint32_t begin, std::uint32_t end, std::size_t depth) {
    BoundingBox centres;
    for (std::uint32_t i = begin; i < end; ++i) centres.include(centres_[tree_.triangles[i]]);
    int axis = 0;
    const double extent = centres.extent().maxCoeff(&axis);
    if (depth < deepest_heuristic_split && extent > 0.0) {
      const std::uint32_t middle = split_by_area(begin, end, axis, centres.low[axis], extent);
      if (middle > begin && middle < end) return middle;
    }
    const std::uint32_t middle = begin + (end - begin) / 2;
    const auto first = tree_.triangles.begin();
    std::nth_element(first + begin, first + middle, first + end, [&](std::uint32_t a, std::uint32_t b) {
      return centres_[a][axis] != centres_[b][axis] ? centres_[a][axis] < centres_[b][axis] : a < b;
    });
    return middle;
  }

  std::uint32_t split_by_area(std::uint32_t begin, std::uint32_t end, int axis, double low, double extent) {
    const double scale = static_cast<double>(bins) / extent;
    const auto bin_of = [&](std::uint32_t triangle) {
      const double bin = (centres_[triangle][axis] - low) * scale;
      return bin < static_cast<double>(bins - 1) ? static_cast<std::size_t>(bin) : bins - 1;
    };
    std::array<BoundingBox, bins> box;
    std::array<std::uint32_t, bins> count{};
    for (std::uint32_t i = begin; i < end; ++i) {
      const std::size_t bin = bin_of(tree_.triangles[i]);
      include(box[bin], boxes_[tree_.triangles[i]]);
      ++count[bin];
    }
    std::array<double, bins> right_cost{};  // of everything from a bin on
    BoundingBox right;
    std::uint32_t right_count = 0;
    for (std::size_t bin = bins - 1; bin > 0; --bin) {
      include(right, box[bin]);
      right_count += count[bin];
      right_cost[bin] = half_area(right) * right_count;
    }
    BoundingBox left;
    std::uint32_t left_count = 0;
    double best = std::numeric_limits<double>::infinity();
    std::size_t best_bin = 0;
    for (std::size_t bin = 0; bin + 1 < bins; ++bin) {
      include(left, box[bin]);
      left_count += count[bin];
      const double cost = half_area(left) * left_count + right_cost[bin + 1];
      if (left_count > 0 && left_count < end - begin && cost < best) {
        best = cost;
        best_bin = bin;
      }
    }
    const auto first = tree_.triangles.begin();
    const auto middle =
        std::partition(first + begin, first + end, [&](std::uint32_t t) { return bin_of(t) <= best_bin; });
    return static_cast<std::uint32_t>(middle - first);
  }

  std::vector<BoundingBox> boxes_;
  std::vector<Vec3> centres_;
  TriangleTree tree_;
};

}  // namespace

TriangleTree triangle_tree(const TriangleMesh& mesh) { return Builder(mesh).build(); }

}  // namespace nanocarbon::mesh
