// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "potential/rebo2/comparison_structures.h"

namespace nanocarbon::test {

//! \brief Structures on which evaluations of AIREBO are compared.
//! \details Graphite, a bundle of tubes, C60 in C240, a C60 crystal, polyethylene, a benzene dimer, two C60 in
//! contact and hydrocarbon soup at 2500 K, each as it is and with every atom moved by up to 0.05 and 0.15
//! Angstrom; dense random crystals of C and H; and everything that REBO2 is compared on. Coordinates have 4
//! decimals.
std::vector<ComparisonStructure> airebo_structures();

//! Carbon and hydrogen at random in a periodic cube, at most one within 0.95 Angstrom of another.
Molecule random_crystal(unsigned seed, std::size_t atoms, double edge);

//! The largest difference from LAMMPS that rounding explains, relative to the largest force above 100
//! eV/Angstrom.
double airebo_force_tolerance(const Molecule& molecule);

}  // namespace nanocarbon::test
