// SPDX-License-Identifier: GPL-2.0-or-later
// What every user of forces sees of a potential.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "nanocarbon/core/bond_cutoffs.h"
#include "nanocarbon/core/cell.h"
#include "nanocarbon/core/element.h"
#include "nanocarbon/core/vec3.h"

namespace nanocarbon::potential {

//! What to compute besides the energy, the forces and the virial.
struct EvaluationOptions {
  bool general_only = false;   //!< never the fast evaluation of special cases (for comparison)
  bool atom_energies = false;  //!< also the energy of each atom
  bool atom_virials = false;   //!< also the virial of each atom; implies general_only
};

//! The energy of a structure and its derivatives.
struct Evaluation {
  double energy = 0.0;       //!< eV
  std::vector<Vec3> forces;  //!< one for each atom, eV/Angstrom
  //! Sum of r (x) f over pairs, eV. Divided by the volume it is the potential part of LAMMPS's pressure
  //! tensor.
  Mat3 virial = Mat3::Zero();
  std::vector<double> atom_energies;  //!< eV; bonds are shared equally by their ends; empty if not asked for
  std::vector<Mat3> atom_virials;     //!< eV; as LAMMPS shares them; minus LAMMPS's stress times volume
};

//! A part of the energy by its name, as compute pair or a report prints it.
struct EnergyPart {
  std::string_view name;  //!< static text
  double energy;          //!< eV
};

//! \brief A potential of carbon and hydrogen.
//! \details Made to be called again and again: implementations keep lists and arrays between calls. Not to be
//! called from several threads at once.
class Potential {
 public:
  virtual ~Potential() = default;

  //! The name on the command line, such as "rebo2".
  virtual std::string_view name() const = 0;

  //! \param positions Angstrom, finite
  //! \param elements one for each position
  //! \param cell nullptr for a molecule in free space; may be as small as one atom
  //! \return valid until the next call
  virtual const Evaluation& evaluate(std::span<const Vec3> positions, std::span<const Element> elements,
                                     const Cell* cell, const EvaluationOptions& options) = 0;

  //! The parts of the last evaluation's energy; their sum is the energy.
  virtual std::vector<EnergyPart> parts() const = 0;

  //! Where bonds end.
  virtual const BondCutoffs& bond_cutoffs() const = 0;

  //! Energy of an atom of a flat, relaxed sheet of graphene: what other energies are measured from, eV.
  virtual double graphene_energy() const = 0;

  //! Bonds apart up to which atoms act on each other through the bonds.
  virtual unsigned bonded_reach() const { return 3; }

  //! Distance up to which atoms act on each other without bonds, Angstrom; 0 where they do not.
  virtual double unbonded_reach() const { return 0.0; }
};

}  // namespace nanocarbon::potential
