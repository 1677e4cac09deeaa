// SPDX-License-Identifier: GPL-2.0-or-later
#include "bonded.h"

#include <algorithm>
#include <numeric>

#include "nanocarbon/structures/graphene.h"

namespace nanocarbon::test {

Molecule bonded(Molecule molecule) {
  molecule.bonds = topology::bonds_within(molecule.positions, molecule.elements,
                                          molecule.cell ? &*molecule.cell : nullptr);
  molecule.rings = {};
  return molecule;
}

std::vector<std::int64_t> numbered(const Molecule& molecule) {
  std::vector<std::int64_t> ids(molecule.size());
  std::iota(ids.begin(), ids.end(), 1);
  return ids;
}

analysis::Analysis analysed(const Molecule& molecule, const analysis::ComponentOptions& options) {
  return analysis::analyse(molecule, numbered(molecule), {options, nullptr});
}

Molecule graphene_with_turned_bond(int cells_x, int cells_y) {
  Molecule sheet = bonded(structures::graphene(cells_x, cells_y));
  const Vec3 middle = sheet.cell->vectors.rowwise().sum() / 2.0;
  const AtomIndex a = nearest_atom(sheet, middle);
  for (const Bond& bond : sheet.bonds) {
    if ((bond.first != a && bond.second != a) || bond.image != std::array<std::int32_t, 3>{0, 0, 0}) continue;
    Vec3 &p = sheet.positions[bond.first], &q = sheet.positions[bond.second];
    const Vec3 centre = (p + q) / 2.0, half = (q - p) / 2.0, turned(-half.y(), half.x(), 0.0);
    p = centre - turned;
    q = centre + turned;
    break;
  }
  return bonded(sheet);
}

AtomIndex nearest_atom(const Molecule& molecule, const Vec3& point) {
  AtomIndex nearest = 0;
  for (AtomIndex a = 0; a < molecule.size(); ++a)
    if ((molecule.positions[a] - point).norm() < (molecule.positions[nearest] - point).norm()) nearest = a;
  return nearest;
}

Molecule without(const Molecule& molecule, const std::vector<AtomIndex>& removed) {
  Molecule result;
  result.cell = molecule.cell;
  for (AtomIndex a = 0; a < molecule.size(); ++a) {
    if (std::find(removed.begin(), removed.end(), a) != removed.end()) continue;
    result.positions.push_back(molecule.positions[a]);
    result.elements.push_back(molecule.elements[a]);
  }
  return result;
}

}  // namespace nanocarbon::test
