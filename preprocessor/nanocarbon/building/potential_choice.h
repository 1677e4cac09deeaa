// SPDX-License-Identifier: GPL-2.0-or-later
// Which potential a molecule is minimised, checked and certified with.
#pragma once

#include <filesystem>
#include <memory>
#include <string_view>

#include "nanocarbon/potential/potential.h"

namespace nanocarbon::building {

enum class PotentialChoice {
  rebo2,    //!< Brenner et al. 2002: bonds only; sheets do not interact beyond 2 Angstrom
  airebo,   //!< Stuart et al. 2000: with Lennard-Jones and torsion terms
  airebo_m  //!< O'Connor et al. 2015: with Morse instead of Lennard-Jones terms
};

//! The potential's name on the command line and in reports.
std::string_view name(PotentialChoice choice);

//! A potential with its published parameters.
std::unique_ptr<potential::Potential> make_potential(PotentialChoice choice);

//! \brief A potential with parameters from a file in the format of LAMMPS's CH.rebo, CH.airebo or CH.airebo-m.
//! \throw UserError (unreadable, malformed), also if the file belongs to another potential
std::unique_ptr<potential::Potential> make_potential(PotentialChoice choice,
                                                     const std::filesystem::path& parameters);

}  // namespace nanocarbon::building
