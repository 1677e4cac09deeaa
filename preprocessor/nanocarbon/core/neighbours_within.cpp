// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/core/neighbours_within.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "nanocarbon/core/chunks.h"
#include "nanocarbon/core/point_buckets.h"

namespace nanocarbon {
namespace {

using Bin = PointBuckets::Bin;

struct Grid {
  Mat3 to_fractional;                 // Cartesian to bins of unit size along the lattice directions
  Vec3 origin;                        // Angstrom
  Bin bins;                           // number along a periodic direction, 0 where not periodic
  std::array<std::int64_t, 3> reach;  // how many bins away a neighbour can be
};

Grid make_grid(const Cell* cell, double cutoff) {
  const Cell no_cell{Mat3::Identity(), Vec3::Zero(), {false, false, false}};
  const Cell& c = cell ? *cell : no_cell;
  const Vec3 heights = face_distances(c);
  Grid grid{c.vectors.inverse(), c.origin, {0, 0, 0}, {1, 1, 1}};
  for (int d = 0; d < 3; ++d) {
    double bins_per_vector = heights[d] / cutoff;
    if (c.periodic[d]) {
      bins_per_vector = std::max(1.0, std::floor(bins_per_vector));
      grid.bins[d] = static_cast<std::int64_t>(bins_per_vector);
      grid.reach[d] = static_cast<std::int64_t>(std::ceil(cutoff * bins_per_vector / heights[d]));
    }
    grid.to_fractional.row(d) *= bins_per_vector;
  }
  return grid;
}

std::int64_t floor_div(std::int64_t a, std::int64_t b) {
  return a / b - ((a % b != 0) && ((a < 0) != (b < 0)));
}

}  // namespace

NeighbourList neighbours_within(std::span<const Vec3> positions, const Cell* cell, double cutoff,
                                ThreadTeam* team) {
  const Grid grid = make_grid(cell, cutoff);
  const std::size_t n = positions.size();

  // Bin of every atom as given, and the image that brings it into the cell.
  std::vector<Bin> bin(n), home(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3 f = grid.to_fractional * (positions[i] - grid.origin);
    for (int d = 0; d < 3; ++d) {
      const auto b = static_cast<std::int64_t>(std::floor(f[d]));
      home[i][d] = grid.bins[d] ? floor_div(b, grid.bins[d]) : 0;
      bin[i][d] = b - home[i][d] * grid.bins[d];
    }
  }

  const PointBuckets buckets(positions, [&](std::size_t i) { return bin[i]; });
  const double cutoff_squared = cutoff * cutoff;
  const auto add_neighbours = [&](std::size_t i, std::vector<Neighbour>& found) {
    for (std::int64_t dx = -grid.reach[0]; dx <= grid.reach[0]; ++dx)
      for (std::int64_t dy = -grid.reach[1]; dy <= grid.reach[1]; ++dy)
        for (std::int64_t dz = -grid.reach[2]; dz <= grid.reach[2]; ++dz) {
          Bin target = {bin[i][0] + dx, bin[i][1] + dy, bin[i][2] + dz};
          Bin crossed = {0, 0, 0};
          for (int d = 0; d < 3; ++d)
            if (grid.bins[d]) {
              crossed[d] = floor_div(target[d], grid.bins[d]);
              target[d] -= crossed[d] * grid.bins[d];
            }
          buckets.for_each_in(target, [&](const PointBuckets::Entry& other) {
            const std::uint32_t j = other.point;
            std::array<std::int32_t, 3> image;
            for (int d = 0; d < 3; ++d)
              image[d] = static_cast<std::int32_t>(crossed[d] - home[j][d] + home[i][d]);
            if (j == i && image == std::array<std::int32_t, 3>{0, 0, 0}) return;
            Vec3 delta = other.position - positions[i];
            if (cell) delta += image_shift(*cell, image);
            if (delta.squaredNorm() < cutoff_squared) found.push_back({j, image});
          });
        }
  };

  // Rows of each chunk of atoms by themselves, then all in a row.
  std::vector<std::vector<Neighbour>> rows(chunks_of(n));
  NeighbourList list;
  list.offsets.assign(n + 1, 0);
  for_chunks(team, n, [&](std::size_t begin, std::size_t end) {
    std::vector<Neighbour>& found = rows[begin / chunk_size];
    for (std::size_t i = begin; i < end; ++i) {
      const std::size_t row = found.size();
      add_neighbours(i, found);
      std::sort(found.begin() + static_cast<std::ptrdiff_t>(row), found.end());
      list.offsets[i + 1] = found.size() - row;
    }
  });
  for (std::size_t i = 0; i < n; ++i) list.offsets[i + 1] += list.offsets[i];
  list.neighbours.reserve(list.offsets[n]);
  for (std::vector<Neighbour>& found : rows) {
    list.neighbours.insert(list.neighbours.end(), found.begin(), found.end());
    found = {};
  }
  return list;
}

}  // namespace nanocarbon
