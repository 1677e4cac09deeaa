// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>

#include "nanocarbon/molecule/formats/read_settings.h"

namespace nanocarbon::molecule {

//! \brief The next frame of a text dump of LAMMPS (dump atom, custom and their kin); nothing at the end.
//! \details Positions: xu yu zu, x y z, xsu ysu zsu or xs ys zs, the first of these that is there; image flags
//! ix iy iz unwrap x and xs. Elements: --types by type, else the columns element (or typelabel), else mass.
//! Boxes: orthogonal, triclinic with bounds around the tilted box, and "abc origin". A box without boundary
//! letters is taken as periodic, with a warning.
//! \throw UserError (malformed; unsuitable, also where no column says what the atoms are)
std::optional<MoleculeFrame> read_lammps_dump_frame(TextInput& input, ReadSettings& settings);

//! \brief The same of a dump in YAML (dump yaml).
//! \details A document each frame, as LAMMPS lays it out: a key each line, each bound and each atom a list in
//! brackets on a line of its own.
std::optional<MoleculeFrame> read_lammps_yaml_frame(TextInput& input, ReadSettings& settings);

}  // namespace nanocarbon::molecule
