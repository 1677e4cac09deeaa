// SPDX-License-Identifier: GPL-2.0-or-later
// Two molecules of benzene, pressed together in one pair of atoms.
#pragma once

#include <Eigen/Geometry>

#include "nanocarbon/structures/hydrocarbons.h"

namespace nanocarbon::test {

// A bond to hydrogen of a molecule that lies in the xy plane.
struct Tip {
  Vec3 carbon, hydrogen;
  Vec3 direction() const { return (hydrogen - carbon).normalized(); }
};

inline Tip first_tip(const Molecule& benzene) {
  for (const Bond& bond : benzene.bonds)
    if (benzene.elements[bond.second] == Element::hydrogen)
      return {benzene.positions[bond.first], benzene.positions[bond.second]};
  return {};
}

template <class Place>
Molecule beside_itself(const Molecule& one, const Place& place) {
  Molecule both = one;
  const auto first = static_cast<AtomIndex>(one.size());
  for (AtomIndex a = 0; a < first; ++a) {
    both.positions.push_back(place(one.positions[a]));
    both.elements.push_back(one.elements[a]);
  }
  for (const Bond& bond : one.bonds)
    both.bonds.push_back({bond.first + first, bond.second + first, bond.image});
  return both;
}

// In one plane, two hydrogens at this distance in line with their bonds.
inline Molecule hydrogen_to_hydrogen(double distance) {
  const Molecule benzene = structures::benzene();
  const Tip tip = first_tip(benzene);
  const Vec3 middle = tip.hydrogen + 0.5 * distance * tip.direction();
  return beside_itself(benzene, [&](const Vec3& p) { return Vec3(2 * middle - p); });
}

// The second across the first: its carbon this far in front of the first one's hydrogen.
inline Molecule hydrogen_to_carbon(double distance) {
  const Molecule benzene = structures::benzene();
  const Tip tip = first_tip(benzene);
  const Vec3 forward = tip.direction(), up = Vec3::UnitZ(), side = up.cross(forward);
  return beside_itself(benzene, [&](const Vec3& p) {
    const Vec3 q = p - tip.carbon;
    return Vec3(tip.hydrogen + distance * forward + q.x() * side + q.y() * up);
  });
}

}  // namespace nanocarbon::test
