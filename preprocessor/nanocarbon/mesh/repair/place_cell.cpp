// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/repair/place_cell.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "nanocarbon/core/neighbours_within.h"

namespace nanocarbon::mesh {
namespace {

// From the cell's lower face on, along one of its edges, of the distance between its faces.
struct Extent {
  double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
  void add(double at) {
    lowest = std::min(lowest, at);
    highest = std::max(highest, at);
  }
};

class Placing {
 public:
  Placing(TriangleMesh& mesh, Cell& cell, double tolerance)
      : mesh_(mesh), cell_(cell), tolerance_(tolerance), to_fractional_(cell.vectors.inverse()) {}

  std::size_t run(double near) {
    std::size_t copies = 0;
    for (int d = 0; d < 3; ++d)
      if (cell_.periodic[static_cast<std::size_t>(d)]) copies += place(d, near / face_distances(cell_)[d]);
    return copies;
  }

 private:
  std::size_t place(int d, double near) {
    const double tolerance = tolerance_ / face_distances(cell_)[d];
    Extent all;
    for (const Triangle& t : mesh_.triangles)
      for (const VertexIndex v : t) all.add(fractional(v, d));
    if (all.lowest > -tolerance && all.highest - 1 < tolerance) return 0;
    const double middle = 0.5 * (all.lowest + all.highest - 1);
    if (std::abs(all.highest - all.lowest - 1) < near) {
      if (std::abs(middle) > near) move_cell(d, middle);
      return 0;
    }
    for (const double from : {0.0, all.lowest, all.highest - 1}) {
      const std::size_t dropped = drop_copies(d, from, tolerance);
      if (dropped == 0) continue;
      move_cell(d, from);
      return dropped;
    }
    return 0;
  }

  double fractional(VertexIndex v, int d) const {
    return (to_fractional_ * (mesh_.points[v] - cell_.origin))[d];
  }
  void move_cell(int d, double by) { cell_.origin += by * cell_.vectors.col(d); }

  // Faces outside the cell if it began there along an edge of its; none, if one of them is no image of a
  // face inside. Corners do not tell: of a mesh that holds every face once, those beyond have theirs inside, too.
  std::size_t drop_copies(int d, double from, double tolerance) {
    std::vector<bool> beyond(mesh_.triangles.size(), false);
    std::vector<Vec3> centres;
    std::size_t copies = 0;
    for (std::size_t t = 0; t < beyond.size(); ++t) {
      Extent face;
      Vec3 centre = Vec3::Zero();
      for (const VertexIndex v : mesh_.triangles[t]) {
        face.add(fractional(v, d) - from);
        centre += mesh_.points[v] / 3;
      }
      const bool above = face.lowest > 1 - tolerance && face.highest > 1 + tolerance,
                 below = face.highest < tolerance && face.lowest < -tolerance;
      beyond[t] = above || below;
      copies += beyond[t];
      centres.push_back(centre);
    }
    if (copies == 0) return 0;
    const NeighbourList same = neighbours_within(centres, &cell_, tolerance_);
    for (std::size_t t = 0; t < beyond.size(); ++t) {
      const auto images = same.of(t);
      if (beyond[t] &&
          std::all_of(images.begin(), images.end(), [&](const Neighbour& n) { return bool(beyond[n.atom]); }))
        return 0;
    }
    std::size_t next = 0;
    std::erase_if(mesh_.triangles, [&](const Triangle&) { return beyond[next++]; });
    return copies;
  }

  TriangleMesh& mesh_;
  Cell& cell_;
  const double tolerance_;
  const Mat3 to_fractional_;
};

}  // namespace

std::size_t place_cell(TriangleMesh& mesh, Cell& cell, double tolerance, double near) {
  return Placing(mesh, cell, tolerance).run(near);
}

}  // namespace nanocarbon::mesh
