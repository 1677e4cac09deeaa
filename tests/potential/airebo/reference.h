// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "nanocarbon/molecule/molecule.h"
#include "nanocarbon/potential/airebo/parameters.h"

namespace nanocarbon::test {

//! What LAMMPS says of a structure under one pair style, metal units.
struct AireboReference {
  std::string style;  //!< with its arguments, such as "airebo/morse 2.5 1 1 2.0"
  double rebo;
  double long_range;
  double torsion;
  Mat3 virial;               //!< pressure times volume, eV
  std::vector<Vec3> forces;  //!< of some structures
  double total() const { return rebo + long_range + torsion; }
};

//! A structure of the table.
struct AireboReferenceStructure {
  std::string name;
  Molecule molecule;
  std::vector<AireboReference> references;
};

//! \brief reference.json: 28 structures as LAMMPS's airebo and airebo/morse evaluate them.
//! \details Made by LAMMPS of 29 Sep 2021 with its CH.airebo and CH.airebo-m: minimised structures, and some
//! with bonds, bond orders and pairs within every switch.
std::vector<AireboReferenceStructure> airebo_reference();

//! The parameters and terms that a style with its arguments stands for.
struct AireboStyle {
  const airebo::AireboParameters* parameters;
  airebo::AireboTerms terms;
};
AireboStyle airebo_style(const std::string& style);

//! Whether some bond or bond order may lie within a switch, where LAMMPS's splines lose digits.
bool is_in_switches(const std::string& name);

}  // namespace nanocarbon::test
