// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/molecule/formats/close_atoms.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstdint>

namespace nanocarbon::molecule {
namespace {

//! An atom, or an image of one that is near the cell.
struct Point {
  Vec3 position;
  AtomIndex atom;
  bool image;
};

// The atoms wrapped into the cell, and the images of those near its faces that are within the distance of it.
std::vector<Point> points_of(const Molecule& molecule, double distance) {
  std::vector<Point> points;
  points.reserve(molecule.size() + molecule.size() / 8);
  if (!molecule.cell) {
    for (std::size_t i = 0; i < molecule.size(); ++i)
      points.push_back({molecule.positions[i], static_cast<AtomIndex>(i), false});
    return points;
  }
  const Cell& cell = *molecule.cell;
  const Mat3 to_fraction = cell.vectors.inverse();
  const Vec3 faces = face_distances(cell);
  constexpr double most = 4.0;  // images each way, of a cell thinner than the distance
  for (std::size_t i = 0; i < molecule.size(); ++i) {
    Vec3 fraction = to_fraction * (molecule.positions[i] - cell.origin);
    int low[3] = {0, 0, 0}, high[3] = {0, 0, 0};
    for (int d = 0; d < 3; ++d) {
      if (!cell.periodic[static_cast<std::size_t>(d)]) continue;
      fraction[d] -= std::floor(fraction[d]);
      const double reach = distance / faces[d];
      low[d] = -static_cast<int>(std::min(most, std::floor(fraction[d] + reach)));
      high[d] = static_cast<int>(std::min(most, std::floor(1.0 - fraction[d] + reach)));
    }
    for (int a = low[0]; a <= high[0]; ++a)
      for (int b = low[1]; b <= high[1]; ++b)
        for (int c = low[2]; c <= high[2]; ++c)
          points.push_back({cell.origin + cell.vectors * (fraction + Vec3(a, b, c)),
                            static_cast<AtomIndex>(i), a != 0 || b != 0 || c != 0});
  }
  return points;
}

struct Entry {
  std::uint64_t box;
  std::uint32_t point;
};

// Boxes of space and the points whose cube of that edge reaches into them: two points within the distance of each
// other are in one box at least. Different boxes of the same number do no harm.
std::vector<Entry> sorted_into_boxes(const std::vector<Point>& points, double distance) {
  const double width = 8.0 * distance;
  std::vector<Entry> entries;
  entries.reserve(points.size() + points.size() / 2);
  for (std::size_t p = 0; p < points.size(); ++p) {
    std::int64_t low[3], high[3];
    for (int d = 0; d < 3; ++d) {
      low[d] = static_cast<std::int64_t>(std::floor((points[p].position[d] - 0.5 * distance) / width));
      high[d] = static_cast<std::int64_t>(std::floor((points[p].position[d] + 0.5 * distance) / width));
    }
    for (std::int64_t a = low[0]; a <= high[0]; ++a)
      for (std::int64_t b = low[1]; b <= high[1]; ++b)
        for (std::int64_t c = low[2]; c <= high[2]; ++c) {
          std::uint64_t box = static_cast<std::uint64_t>(a) * 0x9e3779b97f4a7c15u;
          box = (box ^ (box >> 29) ^ static_cast<std::uint64_t>(b)) * 0xbf58476d1ce4e5b9u;
          box = (box ^ (box >> 32) ^ static_cast<std::uint64_t>(c)) * 0x94d049bb133111ebu;
          entries.push_back({box, static_cast<std::uint32_t>(p)});
        }
  }
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    return a.box != b.box ? a.box < b.box : a.point < b.point;
  });
  return entries;
}

}  // namespace

CloseAtoms find_close_atoms(const Molecule& molecule, double distance) {
  const std::vector<Point> points = points_of(molecule, distance);
  const std::vector<Entry> entries = sorted_into_boxes(points, distance);
  const std::size_t most = std::max<std::size_t>(8 * molecule.size(), 64);  // a pair can be met in 8 boxes
  CloseAtoms found;
  for (std::size_t begin = 0, end = 0; begin < entries.size() && found.all; begin = end) {
    while (end < entries.size() && entries[end].box == entries[begin].box) ++end;
    for (std::size_t i = begin; i < end && found.all; ++i)
      for (std::size_t j = i + 1; j < end && found.all; ++j) {
        const Point &a = points[entries[i].point], &b = points[entries[j].point];
        const double squared = (a.position - b.position).squaredNorm();
        if (!(squared < distance * distance) || (a.image && b.image)) continue;
        found.pairs.push_back({std::min(a.atom, b.atom), std::max(a.atom, b.atom), std::sqrt(squared)});
        found.all = found.pairs.size() < most;
      }
  }
  const auto same = [](const ClosePair& a, const ClosePair& b) {
    return a.first == b.first && a.second == b.second;
  };
  std::vector<ClosePair>& pairs = found.pairs;
  std::sort(pairs.begin(), pairs.end(), [](const ClosePair& a, const ClosePair& b) {
    return a.first != b.first     ? a.first < b.first
           : a.second != b.second ? a.second < b.second
                                  : a.distance < b.distance;
  });
  pairs.erase(std::unique(pairs.begin(), pairs.end(), same), pairs.end());
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const ClosePair& a, const ClosePair& b) { return a.distance < b.distance; });
  return found;
}

}  // namespace nanocarbon::molecule
