// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/building/failed_molecule.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "nanocarbon/core/bond_cutoffs.h"
#include "nanocarbon/core/neighbours_within.h"
#include "nanocarbon/minimisation/apart_from.h"

namespace nanocarbon::building {
namespace {

struct Fault {
  std::string what;
  Vec3 where = Vec3::Zero();
  double excess = 0;  // Angstrom beyond the cut-off
};

Fault worst_fault(const Molecule& molecule) {
  Fault worst{"atoms that are not where their bonds need them", Vec3::Zero(), 0};
  const Space space(molecule.cell);
  const auto between = [&](AtomIndex a, AtomIndex b) {
    return space.displacement(molecule.positions[a], molecule.positions[b]);
  };
  const auto look = [&](AtomIndex a, AtomIndex b, double excess, const char* what) {
    const Vec3 apart = between(a, b);
    if (excess <= worst.excess) return;
    worst = {fmt::format("{} {:.2f} A", what, apart.norm()), molecule.positions[a] + 0.5 * apart, excess};
  };
  std::vector<Bond> bonds = molecule.bonds;
  std::sort(bonds.begin(), bonds.end());
  const auto cutoff = [&](AtomIndex a, AtomIndex b) {
    return rebo_bond_cutoffs.of(molecule.elements[a], molecule.elements[b]);
  };
  const auto apart = [&](AtomIndex a, AtomIndex b) {
    return minimisation::apart_from(rebo_bond_cutoffs, molecule.elements[a], molecule.elements[b]);
  };
  for (const Bond& bond : bonds)
    look(bond.first, bond.second,
         between(bond.first, bond.second).norm() - cutoff(bond.first, bond.second).begin,
         "a bond stretched to");
  const NeighbourList near =
      neighbours_within(molecule.positions, space.cell(), rebo_bond_cutoffs.carbon_carbon.end);
  for (AtomIndex a = 0; a < molecule.size(); ++a)
    for (const Neighbour& n : near.of(a))
      if (a < n.atom && !std::binary_search(bonds.begin(), bonds.end(), Bond{a, n.atom}))
        look(a, n.atom, apart(a, n.atom) - between(a, n.atom).norm(), "two unbonded atoms pressed to within");
  return worst;
}

}  // namespace

std::string describe_failure(const Molecule& molecule, const SizedSurface& surface) {
  const Fault fault = worst_fault(molecule);
  const Vec3 where = fault.where / surface.scale;
  return fmt::format("no molecule was found that holds: {} near ({:.4g}, {:.4g}, {:.4g}) in the mesh",
                     fault.what, where.x(), where.y(), where.z());
}

}  // namespace nanocarbon::building
