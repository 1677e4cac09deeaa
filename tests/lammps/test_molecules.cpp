// SPDX-License-Identifier: GPL-2.0-or-later
#include "lammps/test_molecules.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "nanocarbon/structures/graphene.h"
#include "nanocarbon/structures/tube.h"
#include "nanocarbon/topology/bond_graph.h"

namespace nanocarbon::test {

using std::numbers::pi;

void bond_by_distance(Molecule& molecule) {
  const Cell* const cell = molecule.cell ? &*molecule.cell : nullptr;
  molecule.bonds = topology::bonds_within(molecule.positions, molecule.elements, cell);
  molecule.rings = {};
}

Molecule torus_molecule(int n, int periods) {
  Molecule molecule = structures::periodic_tube(n, n, periods);
  const Cell cell = *molecule.cell;
  molecule.cell.reset();
  const Vec3 middle(cell.origin[0] + cell.vectors(0, 0) / 2, cell.origin[1] + cell.vectors(1, 1) / 2, 0.0);
  const double length = cell.vectors(2, 2);
  for (Vec3& place : molecule.positions) {
    const Vec3 in_tube = place - middle;
    const double turn = 2 * pi * in_tube[2] / length;
    const double radius = length / (2 * pi) + in_tube[0];
    place = {radius * std::cos(turn), radius * std::sin(turn), in_tube[1]};
  }
  bond_by_distance(molecule);
  return molecule;
}

Molecule moebius_band(int chains, int hexagons) {
  constexpr double bond = 1.42;
  const double column = bond * std::sqrt(3.0) / 2;
  const int columns = 2 * hexagons;
  const double radius = columns * column / (2 * pi);
  Molecule molecule;
  for (int chain = 0; chain < chains; ++chain)
    for (int i = 0; i < columns; ++i) {
      const double across =
          (chain - (chains - 1) / 2.0) * 1.5 * bond + ((i + chain) % 2 == 0 ? 0.25 : -0.25) * bond;
      const double turn = 2 * pi * i / columns;
      const double out = radius + across * std::cos(turn / 2);
      molecule.positions.emplace_back(out * std::cos(turn), out * std::sin(turn),
                                      across * std::sin(turn / 2));
    }
  molecule.elements.assign(molecule.size(), Element::carbon);
  bond_by_distance(molecule);
  return molecule;
}

Molecule flake_with_two_holes() {
  const Molecule flake = structures::graphene_flake(16.0);
  Vec3 middle = Vec3::Zero();
  for (const Vec3& place : flake.positions) middle += place / static_cast<double>(flake.size());
  Molecule result;
  for (std::size_t a = 0; a < flake.size(); ++a) {
    // Centres of rings lie three lattice constants from the middle one, along x; a coronene's atoms are
    // within 3.8.
    const Vec3 from_middle = flake.positions[a] - middle;
    const double hole = std::abs(std::abs(from_middle[0]) - 3 * 2.46);
    if (std::hypot(hole, from_middle[1]) < 3.0) continue;
    result.positions.push_back(flake.positions[a]);
    result.elements.push_back(Element::carbon);
  }
  bond_by_distance(result);
  return result;
}

Molecule doubled(const Molecule& flake) {
  std::vector<int> bonds(flake.size(), 0);
  for (const Bond& bond : flake.bonds) {
    ++bonds[bond.first];
    ++bonds[bond.second];
  }
  // Far enough apart to bond at the edges only, and bonds there not too long.
  constexpr double half_bond = 0.71;
  constexpr double bulge = 0.8;
  Molecule result;
  for (const double side : {1.0, -1.0})
    for (std::size_t a = 0; a < flake.size(); ++a)
      result.positions.push_back(flake.positions[a] +
                                 Vec3(0, 0, side * (half_bond + (bonds[a] == 2 ? 0.0 : bulge))));
  result.elements.assign(result.size(), Element::carbon);
  bond_by_distance(result);
  return result;
}

Molecule together(const Molecule& first, const Molecule& second, const Vec3& move) {
  Molecule result;
  result.positions = first.positions;
  for (const Vec3& place : second.positions) result.positions.push_back(place + move);
  result.elements.assign(result.size(), Element::carbon);
  bond_by_distance(result);
  return result;
}

std::array<Vec3, 2> turned(const Vec3& first, const Vec3& second, const Vec3& axis) {
  const Vec3 middle = (first + second) / 2;
  const Eigen::AngleAxisd turn(pi / 2, axis.normalized());
  return {middle + turn * (first - middle), middle + turn * (second - middle)};
}

}  // namespace nanocarbon::test
