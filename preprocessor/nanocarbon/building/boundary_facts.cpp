// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/building/boundary_facts.h"

#include <algorithm>

#include "nanocarbon/molecule/hydrogens.h"

namespace nanocarbon::building {
namespace {

constexpr int reach = 2;  // bonds from an open atom: what its missing neighbour changes in energy ends there

// Open carbon atoms and what is within the reach of them, hydrogen too.
std::vector<bool> near_boundary(const Molecule& molecule) {
  std::vector<unsigned> carbons(molecule.size(), 0);
  const auto is_carbon = [&](AtomIndex a) { return molecule.elements[a] == Element::carbon; };
  for (const Bond& bond : molecule.bonds)
    if (is_carbon(bond.first) && is_carbon(bond.second)) ++carbons[bond.first], ++carbons[bond.second];
  std::vector<bool> near(molecule.size());
  for (AtomIndex a = 0; a < molecule.size(); ++a) near[a] = is_carbon(a) && carbons[a] < 3;
  for (int step = 0; step < reach; ++step) {
    std::vector<bool> wider = near;
    for (const Bond& bond : molecule.bonds)
      if (near[bond.first] || near[bond.second]) wider[bond.first] = wider[bond.second] = true;
    near = std::move(wider);
  }
  return near;
}

}  // namespace

std::string_view name(Boundary boundary) { return boundary == Boundary::hydrogen ? "hydrogen" : "bare"; }

BoundaryFacts boundary_facts(const Molecule& molecule, potential::Potential& potential) {
  BoundaryFacts facts;
  facts.units = molecule::boundary_units(molecule);
  facts.hydrogens = molecule::hydrogen_count(molecule);
  if (facts.units.loops == 0) return facts;
  const potential::Evaluation& energies =
      potential.evaluate(molecule.positions, molecule.elements, molecule.cell ? &*molecule.cell : nullptr,
                         {.atom_energies = true});
  const std::vector<bool> near = near_boundary(molecule);
  for (AtomIndex a = 0; a < molecule.size(); ++a)
    if (near[a]) {
      const bool carbon = molecule.elements[a] == Element::carbon;
      facts.energy += potential.above_graphene(energies.atom_energies[a], carbon ? 1 : 0, carbon ? 0 : 1);
    }
  return facts;
}

}  // namespace nanocarbon::building
