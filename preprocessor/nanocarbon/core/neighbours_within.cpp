// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/core/neighbours_within.h"

#include <Eigen/LU>
#include <algorithm>
#include <bit>
#include <cmath>

namespace nanocarbon {
namespace {

using Bin = std::array<std::int64_t, 3>;

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

std::uint64_t hash(const Bin& bin) {
  std::uint64_t h = 0x9e3779b97f4a7c15ull;
  for (const std::int64_t b : bin) {
    h ^= static_cast<std::uint64_t>(b);
    h *= 0xff51afd7ed558ccdull;
    h ^= h >> 32;
  }
  return h;
}

std::int64_t floor_div(std::int64_t a, std::int64_t b) {
  return a / b - ((a % b != 0) && ((a < 0) != (b < 0)));
}

}  // namespace

NeighbourList neighbours_within(std::span<const Vec3> positions, const Cell* cell, double cutoff) {
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

  // Atoms sorted by the hash bucket of their bin.
  const std::size_t buckets = std::bit_ceil(std::max<std::size_t>(16, 2 * n));
  const auto bucket_of = [&](const Bin& b) { return static_cast<std::size_t>(hash(b)) & (buckets - 1); };
  std::vector<std::uint32_t> start(buckets + 1, 0), atoms(n);
  for (std::size_t i = 0; i < n; ++i) ++start[bucket_of(bin[i]) + 1];
  for (std::size_t b = 0; b < buckets; ++b) start[b + 1] += start[b];
  std::vector<std::uint32_t> fill(start.begin(), start.end() - 1);
  for (std::size_t i = 0; i < n; ++i) atoms[fill[bucket_of(bin[i])]++] = static_cast<std::uint32_t>(i);

  NeighbourList list;
  list.offsets.reserve(n + 1);
  list.offsets.push_back(0);
  const double cutoff_squared = cutoff * cutoff;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t row = list.neighbours.size();
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
          const std::size_t bucket = bucket_of(target);
          for (std::uint32_t slot = start[bucket]; slot < start[bucket + 1]; ++slot) {
            const std::uint32_t j = atoms[slot];
            if (bin[j] != target) continue;
            std::array<std::int32_t, 3> image;
            for (int d = 0; d < 3; ++d)
              image[d] = static_cast<std::int32_t>(crossed[d] - home[j][d] + home[i][d]);
            if (j == i && image == std::array<std::int32_t, 3>{0, 0, 0}) continue;
            Vec3 delta = positions[j] - positions[i];
            if (cell) delta += image_shift(*cell, image);
            if (delta.squaredNorm() < cutoff_squared) list.neighbours.push_back({j, image});
          }
        }
    std::sort(list.neighbours.begin() + static_cast<std::ptrdiff_t>(row), list.neighbours.end());
    list.offsets.push_back(list.neighbours.size());
  }
  return list;
}

}  // namespace nanocarbon
