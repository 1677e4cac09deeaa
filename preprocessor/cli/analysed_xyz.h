// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <ostream>

#include "nanocarbon/analysis/analyse.h"

namespace nanocarbon::cli {

//! \brief Appends a frame as extended XYZ with a column for each thing known of an atom.
//! \details Besides species, position and ID: bonds (coordination), smallest ring, ring sizes as "5-6-6" (or "-"), the
//! piece (from 1), state (0 unchanged, 1 rebonded, 2 repelled), the defect (its place in the list from 1, or 0),
//! pyramidalisation (degrees), mean and Gaussian curvature (1/Angstrom, 1/Angstrom^2) and energy (eV), "nan" where
//! they are not defined.
void write_analysed_xyz(std::ostream& out, const Molecule& molecule, std::span<const std::int64_t> ids,
                        const analysis::Analysis& analysis, std::span<const analysis::AtomFate> fates,
                        const std::string& generator);

}  // namespace nanocarbon::cli
