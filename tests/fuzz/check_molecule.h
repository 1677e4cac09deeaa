// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "nanocarbon/molecule/formats/molecule_frame.h"

namespace nanocarbon::test {

//! \brief Reads frames of a file as a user's would be, whatever the bytes, and looks for close atoms in them.
//! \return "" where it was refused as the user's error or came out as promised; else what promise was broken.
//! Anything but a UserError passes through.
std::string broken_promise(std::string_view contents, const std::string& file,
                           const molecule::MoleculeReadOptions& options);

//! The atoms of all frames of a file.
std::size_t atoms_read(std::string_view contents, const std::string& file,
                       const molecule::MoleculeReadOptions& options);

//! What a frame breaks of what read_molecule.h promises, or "".
std::string broken_by(const molecule::MoleculeFrame& frame);

}  // namespace nanocarbon::test
