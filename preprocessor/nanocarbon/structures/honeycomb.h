// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <numbers>

namespace nanocarbon::structures {

//! Bond length of graphene under REBO2 at 0 K, Angstrom.
inline constexpr double graphene_bond = 1.4204;

//! Length of the lattice vectors of the honeycomb lattice, sqrt(3) bonds, Angstrom.
inline constexpr double graphene_lattice_constant = std::numbers::sqrt3 * graphene_bond;

}  // namespace nanocarbon::structures
