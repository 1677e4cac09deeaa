// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <filesystem>

#include "nanocarbon/potential/rebo2/parameters.h"

namespace nanocarbon::rebo2 {

//! \brief Reads REBO2 parameters from a file in the format of LAMMPS's CH.rebo.
//! \details The two-body parameters, the switches and the angular splines are read. The tables over coordination
//! numbers that follow them are ignored in favour of rebo2_tables(), as in LAMMPS, and so are the Lennard-Jones and
//! torsion parameters of AIREBO, which have no meaning here.
//! \throw UserError (unreadable, malformed) naming the file, the line and what was expected there
Rebo2Parameters read_rebo2_parameters(const std::filesystem::path& path);

}  // namespace nanocarbon::rebo2
