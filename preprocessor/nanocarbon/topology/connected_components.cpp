// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/topology/connected_components.h"

namespace nanocarbon::topology {

Components connected_components(std::size_t atoms, std::span<const Bond> bonds) {
  DisjointSets sets(atoms);
  for (const Bond& bond : bonds) sets.join(bond.first, bond.second);
  return numbered_components(atoms, sets);
}

Components numbered_components(std::size_t atoms, DisjointSets& sets) {
  Components components;
  components.of_atom.resize(atoms);
  for (std::uint32_t a = 0; a < atoms; ++a) {
    const std::uint32_t root = sets.find(a);  // the lowest atom, so its component has its number
    components.of_atom[a] = root == a ? components.count++ : components.of_atom[root];
  }
  return components;
}

}  // namespace nanocarbon::topology
