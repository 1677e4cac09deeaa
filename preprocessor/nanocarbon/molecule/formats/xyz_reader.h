// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>

#include "nanocarbon/molecule/formats/read_settings.h"

namespace nanocarbon::molecule {

//! \brief The next frame of an XYZ file, plain or extended (xyz_comment.h); nothing at the end.
//! \details Species are names (species.h), or atomic numbers where Properties call them Z or numbers. IDs are
//! those of a property `id`, else 1, 2, ... What follows a frame must be the next one's number of atoms.
//! \throw UserError (malformed; unsuitable)
std::optional<MoleculeFrame> read_xyz_frame(TextInput& input, ReadSettings& settings);

}  // namespace nanocarbon::molecule
