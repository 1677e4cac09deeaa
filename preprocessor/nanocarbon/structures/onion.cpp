// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/structures/onion.h"

#include "nanocarbon/core/error.h"
#include "nanocarbon/structures/fullerene.h"

namespace nanocarbon::structures {

void append(Molecule& molecule, const Molecule& other) {
  const auto atoms = static_cast<AtomIndex>(molecule.size());
  const auto ring_atoms = static_cast<std::uint32_t>(molecule.rings.atoms.size());
  molecule.positions.insert(molecule.positions.end(), other.positions.begin(), other.positions.end());
  molecule.elements.insert(molecule.elements.end(), other.elements.begin(), other.elements.end());
  for (const Bond& b : other.bonds) molecule.bonds.push_back({b.first + atoms, b.second + atoms, b.image});
  for (const AtomIndex atom : other.rings.atoms) molecule.rings.atoms.push_back(atom + atoms);
  for (std::size_t r = 1; r < other.rings.offsets.size(); ++r)
    molecule.rings.offsets.push_back(other.rings.offsets[r] + ring_atoms);
}

Molecule onion(int innermost, int shells) {
  if (innermost < 1 || shells < 1)
    throw UserError(Failure::usage,
                    "an onion needs at least one shell, the innermost being (k, k) with k of 1 or more");
  if (innermost > 400 || shells > 60)
    throw UserError(Failure::usage, "an onion goes up to 60 shells, the innermost up to (400, 400)");
  Molecule result;
  for (int k = innermost; k < innermost + shells; ++k) append(result, fullerene(k, k));
  return result;
}

}  // namespace nanocarbon::structures
