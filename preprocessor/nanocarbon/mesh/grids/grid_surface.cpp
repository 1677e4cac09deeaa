// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/grids/grid_surface.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

#include "nanocarbon/mesh/join_points.h"

namespace nanocarbon::mesh {
namespace {

constexpr unsigned none = std::numeric_limits<unsigned>::max();
using Face = std::array<unsigned, 4>;

// Seen from outside counter-clockwise, by VTK's numbers of corners.
std::span<const Face> faces_of(VolumeCell cell) {
  static constexpr std::array<Face, 4> tetrahedron = {
      {{0, 1, 3, none}, {1, 2, 3, none}, {2, 0, 3, none}, {0, 2, 1, none}}};
  static constexpr std::array<Face, 6> hexahedron = {
      {{0, 4, 7, 3}, {1, 2, 6, 5}, {0, 1, 5, 4}, {3, 7, 6, 2}, {0, 3, 2, 1}, {4, 5, 6, 7}}};
  static constexpr std::array<Face, 5> wedge = {
      {{0, 2, 1, none}, {3, 4, 5, none}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}}};
  static constexpr std::array<Face, 5> pyramid = {
      {{0, 3, 2, 1}, {0, 1, 4, none}, {1, 2, 4, none}, {2, 3, 4, none}, {3, 0, 4, none}}};
  switch (cell) {
    case VolumeCell::tetrahedron:
      return tetrahedron;
    case VolumeCell::hexahedron:
      return hexahedron;
    case VolumeCell::wedge:
      return wedge;
    case VolumeCell::pyramid:
      break;
  }
  return pyramid;
}

}  // namespace

std::size_t corners_of(VolumeCell cell) {
  switch (cell) {
    case VolumeCell::tetrahedron:
      return 4;
    case VolumeCell::hexahedron:
      return 8;
    case VolumeCell::wedge:
      return 6;
    case VolumeCell::pyramid:
      break;
  }
  return 5;
}

void GridSurface::add_face(std::span<const VertexIndex> corners) {
  if (corners.size() < 3) return skip_point_or_line();
  soup_.corners.insert(soup_.corners.end(), corners.begin(), corners.end());
  soup_.close_face();
}

void GridSurface::add_volume(VolumeCell cell, std::span<const VertexIndex> corners) {
  ++volumes_;
  for (const Face& face : faces_of(cell)) {
    CellFace& added = cell_faces_.emplace_back();
    added.corners = face[3] == none ? 3 : 4;
    added.corner.fill(std::numeric_limits<VertexIndex>::max());
    for (unsigned k = 0; k < added.corners; ++k) added.corner[k] = corners[face[k]];
  }
}

// A face that two cells share is within.
void GridSurface::take_boundary() {
  std::vector<std::array<VertexIndex, 4>> keys;
  keys.reserve(cell_faces_.size());
  for (const CellFace& face : cell_faces_) {
    keys.push_back(face.corner);
    std::sort(keys.back().begin(), keys.back().end());
  }
  std::vector<std::size_t> order(keys.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return keys[a] < keys[b]; });
  std::vector<bool> outside(keys.size(), false);
  for (std::size_t i = 0, end = 0; i < order.size(); i = end) {
    while (end < order.size() && keys[order[end]] == keys[order[i]]) ++end;
    if (end == i + 1) outside[order[i]] = true;
  }
  for (std::size_t i = 0; i < cell_faces_.size(); ++i)
    if (outside[i]) add_face({cell_faces_[i].corner.data(), cell_faces_[i].corners});
}

PolygonSoup GridSurface::on(std::vector<Vec3> points) && {
  soup_.points = std::move(points);
  if (soup_.faces() > 0 && volumes_ > 0)
    soup_.notes.push_back(
        fmt::format("skipped {} cells that fill space: the file has faces as well", volumes_));
  if (soup_.faces() == 0 && volumes_ > 0) {
    take_boundary();
    drop_unused_points(soup_);
    soup_.notes.push_back(fmt::format("took the boundary of {} cells that fill space", volumes_));
  }
  if (skipped_ > 0) soup_.notes.push_back(fmt::format("skipped {} points and lines", skipped_));
  if (flattened_ > 0)
    soup_.notes.push_back(fmt::format(
        "took the corners alone of {} cells that have points on their edges as well", flattened_));
  return std::move(soup_);
}

}  // namespace nanocarbon::mesh
