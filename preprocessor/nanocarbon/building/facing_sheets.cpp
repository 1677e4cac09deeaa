// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/building/facing_sheets.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "nanocarbon/core/neighbours_within.h"

namespace nanocarbon::building {

namespace {

constexpr int bonds_within_a_sheet = 4;

//! Who is bonded to whom, in compressed rows.
struct Bonded {
  std::vector<std::uint32_t> offsets, atoms;

  explicit Bonded(const Molecule& molecule) : offsets(molecule.size() + 1, 0) {
    for (const Bond& b : molecule.bonds) ++offsets[b.first + 1], ++offsets[b.second + 1];
    for (std::size_t a = 0; a < molecule.size(); ++a) offsets[a + 1] += offsets[a];
    std::vector<std::uint32_t> next(offsets.begin(), offsets.end() - 1);
    atoms.resize(offsets.back());
    for (const Bond& b : molecule.bonds) {
      atoms[next[b.first]++] = b.second;
      atoms[next[b.second]++] = b.first;
    }
  }
};

}  // namespace

double closest_of_facing_sheets(const Molecule& molecule, double reach) {
  const NeighbourList near =
      neighbours_within(molecule.positions, molecule.cell ? &*molecule.cell : nullptr, reach);
  const Bonded bonded(molecule);
  double closest = std::numeric_limits<double>::infinity();
  std::vector<std::uint32_t> around;
  for (AtomIndex a = 0; a < molecule.size(); ++a) {
    if (molecule.elements[a] != Element::carbon) continue;
    around.assign(1, a);
    std::size_t done = 0;
    for (int step = 0; step < bonds_within_a_sheet; ++step)
      for (const std::size_t end = around.size(); done < end; ++done)
        for (std::uint32_t k = bonded.offsets[around[done]]; k < bonded.offsets[around[done] + 1]; ++k)
          if (std::find(around.begin(), around.end(), bonded.atoms[k]) == around.end())
            around.push_back(bonded.atoms[k]);
    for (const Neighbour& n : near.of(a)) {
      if (n.atom < a || molecule.elements[n.atom] != Element::carbon) continue;
      if (std::find(around.begin(), around.end(), n.atom) != around.end()) continue;
      Vec3 to = molecule.positions[n.atom];
      if (molecule.cell) to += image_shift(*molecule.cell, n.image);
      closest = std::min(closest, (to - molecule.positions[a]).norm());
    }
  }
  return closest;
}

}  // namespace nanocarbon::building
