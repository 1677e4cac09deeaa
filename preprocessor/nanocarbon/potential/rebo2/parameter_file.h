// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <filesystem>

#include "nanocarbon/potential/rebo2/parameters.h"

namespace nanocarbon::rebo2 {

//! \brief Reads REBO2 parameters from a file in the format of LAMMPS's CH.rebo.
//! \details Read are the two-body parameters, the switches and the angular splines. As in LAMMPS, the tables
//! over coordination numbers that follow them are superseded by those of rebo2_tables(), and the
//! Lennard-Jones and torsion parameters of AIREBO have no meaning here; both are passed over.
//! \throw UserError (unreadable, malformed) naming the file, the line and what was expected there
Rebo2Parameters read_rebo2_parameters(const std::filesystem::path& path);

}  // namespace nanocarbon::rebo2
