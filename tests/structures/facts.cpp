// SPDX-License-Identifier: GPL-2.0-or-later
#include "structures/facts.h"

#include <algorithm>
#include <limits>
#include <set>
#include <utility>

#include "nanocarbon/core/neighbours_within.h"

namespace nanocarbon::test {

Facts facts(const Molecule& molecule) {
  Facts f;
  f.bonds_sorted = std::is_sorted(molecule.bonds.begin(), molecule.bonds.end()) &&
                   std::adjacent_find(molecule.bonds.begin(), molecule.bonds.end()) == molecule.bonds.end();
  std::vector<std::size_t> degree(molecule.size(), 0);
  std::set<std::pair<AtomIndex, AtomIndex>> bonded;
  f.shortest_bond = std::numeric_limits<double>::infinity();
  for (const Bond& b : molecule.bonds) {
    ++degree[b.first], ++degree[b.second];
    bonded.insert({b.first, b.second});
    bonded.insert({b.second, b.first});
    Vec3 vector = molecule.positions[b.second] - molecule.positions[b.first];
    if (molecule.cell) vector += image_shift(*molecule.cell, b.image);
    f.shortest_bond = std::min(f.shortest_bond, vector.norm());
    f.longest_bond = std::max(f.longest_bond, vector.norm());
  }
  for (const std::size_t d : degree) ++f.coordination[d];

  f.rings_follow_bonds = f.sides_agree = true;
  std::multiset<std::pair<AtomIndex, AtomIndex>> steps;
  for (std::size_t r = 0; r < molecule.rings.size(); ++r) {
    const auto ring = molecule.rings[r];
    ++f.rings[ring.size()];
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const std::pair step(ring[i], ring[(i + 1) % ring.size()]);
      if (!bonded.contains(step)) f.rings_follow_bonds = false;
      if (steps.contains(step)) f.sides_agree = false;
      steps.insert(step);
    }
  }
  f.euler_characteristic = static_cast<long>(molecule.size()) - static_cast<long>(molecule.bonds.size()) +
                           static_cast<long>(molecule.rings.size());

  const Cell* cell = molecule.cell ? &*molecule.cell : nullptr;
  const NeighbourList near = neighbours_within(molecule.positions, cell, 4.0);
  f.nearest_unbonded = 4.0;
  for (AtomIndex i = 0; i < near.atoms(); ++i)
    for (const Neighbour& n : near.of(i)) {
      const Bond bond =
          i < n.atom ? Bond{i, n.atom, n.image} : Bond{n.atom, i, {-n.image[0], -n.image[1], -n.image[2]}};
      const Bond other_way = {bond.first, bond.second, {-bond.image[0], -bond.image[1], -bond.image[2]}};
      const auto has = [&](const Bond& b) {
        return std::binary_search(molecule.bonds.begin(), molecule.bonds.end(), b);
      };
      if (has(bond) || (n.atom == i && has(other_way))) continue;
      Vec3 vector = molecule.positions[n.atom] - molecule.positions[i];
      if (cell) vector += image_shift(*cell, n.image);
      f.nearest_unbonded = std::min(f.nearest_unbonded, vector.norm());
    }
  return f;
}

}  // namespace nanocarbon::test
