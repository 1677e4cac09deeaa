// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/potential/airebo/neighbours.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "nanocarbon/core/neighbours_within.h"

namespace nanocarbon::airebo {

using potential::NearPairs;

namespace {

using Image = std::array<std::int32_t, 3>;

//! Points sorted into boxes along the axes.
class Boxes {
 public:
  Boxes(const std::vector<double>& coordinates, double edge) : edge_(edge) {
    const std::size_t count = coordinates.size() / 3;
    Vec3 high = Vec3::Zero();
    low_ = count > 0 ? Vec3(Eigen::Map<const Vec3>(coordinates.data())) : Vec3::Zero();
    high = low_;
    for (std::size_t i = 0; i < count; ++i) {
      const Eigen::Map<const Vec3> p(coordinates.data() + 3 * i);
      low_ = low_.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    // Wide boxes where a few atoms are far away from the others.
    const double most = 4.0 * static_cast<double>(count) + 64.0;
    for (;; edge_ *= 1.5) {
      const Vec3 number = ((high - low_) / edge_).array().floor() + 1.0;
      if (number.prod() > most) continue;
      for (int d = 0; d < 3; ++d) number_[d] = static_cast<std::int64_t>(number[d]);
      break;
    }
    start_.assign(number_[0] * number_[1] * number_[2] + 1, 0);
    const auto flat = [&](std::size_t i) {
      const Image b = box(coordinates.data() + 3 * i);
      return index(b[0], b[1], b[2]);
    };
    for (std::size_t i = 0; i < count; ++i) ++start_[flat(i) + 1];
    for (std::size_t b = 1; b < start_.size(); ++b) start_[b] += start_[b - 1];
    members_.resize(count);
    std::vector<std::uint32_t> fill(start_.begin(), start_.end() - 1);
    for (std::size_t i = 0; i < count; ++i) members_[fill[flat(i)]++] = static_cast<std::uint32_t>(i);
  }

  //! Every point in the boxes around that of the given one.
  template <class Visit>
  void for_each_around(const double* point, Visit&& visit) const {
    const Image b = box(point);
    std::array<std::int64_t, 3> first, last;
    for (int d = 0; d < 3; ++d) {
      first[d] = std::max<std::int64_t>(0, b[d] - 1);
      last[d] = std::min<std::int64_t>(number_[d] - 1, b[d] + 1);
    }
    for (std::int64_t x = first[0]; x <= last[0]; ++x)
      for (std::int64_t y = first[1]; y <= last[1]; ++y)
        for (std::uint32_t m = start_[index(x, y, first[2])]; m < start_[index(x, y, last[2]) + 1]; ++m)
          visit(members_[m]);
  }

 private:
  Image box(const double* point) const {
    Image b;
    for (int d = 0; d < 3; ++d) b[d] = static_cast<std::int32_t>((point[d] - low_[d]) / edge_);
    return b;
  }
  std::size_t index(std::int64_t x, std::int64_t y, std::int64_t z) const {
    return static_cast<std::size_t>((x * number_[1] + y) * number_[2] + z);
  }

  double edge_;
  Vec3 low_;
  std::array<std::int64_t, 3> number_ = {1, 1, 1};
  std::vector<std::uint32_t> start_;
  std::vector<std::uint32_t> members_;
};

}  // namespace

Sites find_sites(std::span<const Vec3> positions, const Cell* cell, double reach) {
  Sites found;
  found.own = static_cast<std::uint32_t>(positions.size());
  for (std::uint32_t i = 0; i < found.own; ++i) found.sites.push_back({i, {0, 0, 0}});
  if (!cell) return found;
  const Mat3 to_fractional = cell->vectors.inverse();
  const Vec3 margin = reach * face_distances(*cell).cwiseInverse();
  for (std::uint32_t i = 0; i < found.own; ++i) {
    const Vec3 fraction = to_fractional * (positions[i] - cell->origin);
    Image first = {0, 0, 0}, last = {0, 0, 0}, home = {0, 0, 0};
    for (int d = 0; d < 3; ++d) {
      if (!cell->periodic[d]) continue;
      home[d] = -static_cast<std::int32_t>(std::floor(fraction[d]));
      first[d] = static_cast<std::int32_t>(std::ceil(-margin[d] - fraction[d]));
      last[d] = static_cast<std::int32_t>(std::floor(1.0 + margin[d] - fraction[d]));
    }
    found.sites[i].image = home;
    Image image;
    for (image[0] = first[0]; image[0] <= last[0]; ++image[0])
      for (image[1] = first[1]; image[1] <= last[1]; ++image[1])
        for (image[2] = first[2]; image[2] <= last[2]; ++image[2])
          if (image != home) found.sites.push_back({i, image});
  }
  return found;
}

void place_sites(std::span<const Vec3> positions, const Cell* cell, const Sites& sites,
                 std::vector<double>& coordinates) {
  coordinates.resize(3 * sites.sites.size());
  double* to = coordinates.data();
  for (const potential::PeriodicCopy& site : sites.sites) {
    Vec3 position = positions[site.of];
    if (cell) position += image_shift(*cell, site.image);
    to = std::copy(position.begin(), position.end(), to);
  }
}

NearPairs find_near_pairs(const std::vector<double>& coordinates, double cutoff) {
  const auto* points = reinterpret_cast<const Vec3*>(coordinates.data());
  const NeighbourList list = neighbours_within({points, coordinates.size() / 3}, nullptr, cutoff);
  NearPairs near;
  near.offsets.assign(list.offsets.begin(), list.offsets.end());
  near.atoms.reserve(list.neighbours.size());
  for (const Neighbour& n : list.neighbours) near.atoms.push_back(n.atom);
  return near;
}

NearPairs find_half_pairs(const std::vector<double>& coordinates, const Sites& sites, double cutoff) {
  const Boxes boxes(coordinates, cutoff);
  const double squared = cutoff * cutoff;
  NearPairs pairs;
  for (std::uint32_t i = 0; i < sites.own; ++i) {
    const Eigen::Map<const Vec3> from(coordinates.data() + 3 * std::size_t{i});
    boxes.for_each_around(from.data(), [&](std::uint32_t j) {
      if (sites.is_copy(j)) {
        // Seen from the other end, this pair crosses the cell's faces the other way round.
        const Image& home = sites.sites[sites.sites[j].of].image;
        if (sites.sites[j].image < home) return;
      } else if (j <= i) {
        return;
      }
      const Eigen::Map<const Vec3> to(coordinates.data() + 3 * std::size_t{j});
      if ((to - from).squaredNorm() < squared) pairs.atoms.push_back(j);
    });
    pairs.offsets.push_back(static_cast<std::uint32_t>(pairs.atoms.size()));
  }
  return pairs;
}

}  // namespace nanocarbon::airebo
