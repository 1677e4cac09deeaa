// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <filesystem>

#include "nanocarbon/potential/airebo/parameters.h"

namespace nanocarbon::airebo {

//! \brief Reads parameters from a file in the format of LAMMPS's CH.airebo or CH.airebo-m.
//! \details The second line says which of the two it is. As in LAMMPS, airebo_tables() is used instead of the tables over
//! coordination numbers in the file.
//! \param form of the potential that the file must have
//! \throw UserError (unreadable, malformed) naming the file, the line and what was expected there
AireboParameters read_airebo_parameters(const std::filesystem::path& path, LjForm form);

}  // namespace nanocarbon::airebo
