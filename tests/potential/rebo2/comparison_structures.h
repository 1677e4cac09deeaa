// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "nanocarbon/molecule/molecule.h"

namespace nanocarbon::test {

//! A structure on which evaluations of REBO2 are compared.
struct ComparisonStructure {
  std::string name;
  Molecule molecule;
};

//! \brief Known structures, each as it is and with every atom moved by up to 0.05 and 0.15 Angstrom, and
//! clusters.
//! \details Graphene, diamond, C60, tubes, schwarzites, small hydrocarbons and radicals; 200 clusters of
//! random carbon and hydrogen atoms, dense enough that most coordinations are fractional. Coordinates have 4
//! decimals.
std::vector<ComparisonStructure> comparison_structures();

//! Moves every atom by up to the given distance along each axis (Angstrom), the same way for the same seed.
void rattle(Molecule& molecule, double distance, unsigned seed);

//! \brief Carbon and hydrogen atoms at random in a ball, no two closer than 0.9 Angstrom.
//! \param seed decides everything
Molecule random_cluster(unsigned seed);

//! The largest difference from LAMMPS that rounding explains, eV/Angstrom (and eV for an atom's energy).
//! Larger where a bond is in its cut-off window: LAMMPS's splines lose digits at fractional coordination.
double force_tolerance(const Molecule& molecule);

}  // namespace nanocarbon::test
