// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string_view>

namespace nanocarbon::molecule {

//! LAMMPS's atom styles that data files are written in and read from. Columns of the Atoms section:
//! atomic "id type x y z", charge "id type q x y z", bond, angle and molecular "id molecule type x y z",
//! full "id molecule type q x y z"; three image flags may follow.
enum class AtomStyle { atomic, charge, bond, angle, molecular, full };

std::string_view name(AtomStyle style);

//! The style of a LAMMPS name, or nothing for any other text.
std::optional<AtomStyle> atom_style_from_name(std::string_view name);

inline bool has_molecule_id(AtomStyle style) {
  return style != AtomStyle::atomic && style != AtomStyle::charge;
}
inline bool has_charge(AtomStyle style) { return style == AtomStyle::charge || style == AtomStyle::full; }
//! The styles with molecule-IDs are those whose atoms have bonds.
inline bool has_bonds(AtomStyle style) { return has_molecule_id(style); }

}  // namespace nanocarbon::molecule
