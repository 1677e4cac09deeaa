// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "nanocarbon/analysis/analyse.h"

namespace nanocarbon::test {

//! The molecule with its bonds by distance, as `analyse` finds them.
Molecule bonded(Molecule molecule);

//! 1, 2, 3, ...
std::vector<std::int64_t> numbered(const Molecule& molecule);

//! Of a molecule with bonds.
analysis::Analysis analysed(const Molecule& molecule, const analysis::ComponentOptions& options = {});

//! A periodic sheet with the bond of its middle turned by a right angle, as by Stone and Wales.
Molecule graphene_with_turned_bond(int cells_x, int cells_y);

//! The atom that is nearest to a point.
AtomIndex nearest_atom(const Molecule& molecule, const Vec3& point);

//! Without some of its atoms; bonds and rings are not kept.
Molecule without(const Molecule& molecule, const std::vector<AtomIndex>& removed);

}  // namespace nanocarbon::test
