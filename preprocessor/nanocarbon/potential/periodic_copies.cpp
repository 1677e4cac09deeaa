// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/potential/periodic_copies.h"

#include <algorithm>
#include <unordered_map>

#include "nanocarbon/core/neighbours_within.h"

namespace nanocarbon::potential {

namespace {

struct NeighbourHash {
  std::size_t operator()(const Neighbour& n) const {
    std::size_t hash = n.atom;
    for (const std::int32_t i : n.image) hash = hash * 0x9e3779b97f4a7c15u + static_cast<std::uint32_t>(i);
    return hash ^ (hash >> 29);
  }
};

//! Numbers copies in the order in which they are first asked for.
class Copies {
 public:
  explicit Copies(NearAtoms& near) : near_(near) {}

  std::uint32_t atom(const Neighbour& n) {
    if (n.image == std::array<std::int32_t, 3>{0, 0, 0}) return n.atom;
    const auto next = static_cast<std::uint32_t>(near_.own + near_.copies.size());
    const auto [place, is_new] = numbers_.try_emplace(n, next);
    if (is_new) near_.copies.push_back({n.atom, n.image});
    return place->second;
  }

 private:
  NearAtoms& near_;
  std::unordered_map<Neighbour, std::uint32_t, NeighbourHash> numbers_;
};

}  // namespace

NearAtoms find_near_atoms(std::span<const Vec3> positions, const Cell* cell, double cutoff) {
  const NeighbourList list = neighbours_within(positions, cell, cutoff);
  NearAtoms near;
  near.own = static_cast<std::uint32_t>(positions.size());
  near.pairs.atoms.reserve(list.neighbours.size());
  near.pairs.offsets.reserve(list.offsets.size());
  Copies copies(near);
  const auto close_row = [&] {
    near.pairs.offsets.push_back(static_cast<std::uint32_t>(near.pairs.atoms.size()));
  };
  for (std::uint32_t i = 0; i < near.own; ++i) {
    for (const Neighbour& n : list.of(i)) near.pairs.atoms.push_back(copies.atom(n));
    close_row();
  }
  // Rows of the copies that own atoms see, then of those that these see; the third shell has none.
  std::size_t done = 0;
  for (int shell = 0; shell < 2; ++shell)
    for (const std::size_t end = near.copies.size(); done < end; ++done) {
      const PeriodicCopy copy = near.copies[done];
      for (Neighbour n : list.of(copy.of)) {
        for (int d = 0; d < 3; ++d) n.image[d] += copy.image[d];
        near.pairs.atoms.push_back(copies.atom(n));
      }
      close_row();
    }
  near.pairs.offsets.resize(near.own + near.copies.size() + 1, near.pairs.offsets.back());
  return near;
}

void place_atoms(std::span<const Vec3> positions, const Cell* cell, const NearAtoms& near,
                 std::vector<double>& coordinates) {
  coordinates.resize(3 * (near.own + near.copies.size()));
  const double* own = positions.empty() ? nullptr : positions.front().data();
  std::copy(own, own + 3 * std::size_t{near.own}, coordinates.begin());
  double* to = coordinates.data() + 3 * std::size_t{near.own};
  for (const PeriodicCopy& copy : near.copies) {
    const Vec3 position = positions[copy.of] + image_shift(*cell, copy.image);
    to = std::copy(position.begin(), position.end(), to);
  }
}

}  // namespace nanocarbon::potential
