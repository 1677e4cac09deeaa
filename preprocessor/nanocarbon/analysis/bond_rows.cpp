// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/analysis/bond_rows.h"

namespace nanocarbon::analysis {
namespace {

template <typename Wanted>
BondRows rows_of(const Molecule& molecule, const Wanted& wanted) {
  BondRows rows;
  rows.offsets.assign(molecule.size() + 1, 0);
  for (const Bond& bond : molecule.bonds)
    if (wanted(bond)) ++rows.offsets[bond.first + 1], ++rows.offsets[bond.second + 1];
  for (std::size_t a = 0; a < molecule.size(); ++a) rows.offsets[a + 1] += rows.offsets[a];
  rows.ends.resize(rows.offsets.back());
  std::vector<std::uint32_t> next(rows.offsets.begin(), rows.offsets.end() - 1);
  for (const Bond& bond : molecule.bonds) {
    if (!wanted(bond)) continue;
    const auto& [i, j, k] = bond.image;
    rows.ends[next[bond.first]++] = {bond.second, bond.image};
    rows.ends[next[bond.second]++] = {bond.first, {-i, -j, -k}};
  }
  return rows;
}

}  // namespace

BondRows bond_rows(const Molecule& molecule) {
  return rows_of(molecule, [](const Bond&) { return true; });
}

BondRows carbon_bond_rows(const Molecule& molecule) {
  return rows_of(molecule, [&](const Bond& bond) {
    return molecule.elements[bond.first] == Element::carbon &&
           molecule.elements[bond.second] == Element::carbon;
  });
}

Vec3 bond_vector(const Molecule& molecule, AtomIndex atom, const BondRowEnd& end) {
  Vec3 vector = molecule.positions[end.atom] - molecule.positions[atom];
  if (molecule.cell) vector += image_shift(*molecule.cell, end.image);
  return vector;
}

}  // namespace nanocarbon::analysis
