// SPDX-License-Identifier: GPL-2.0-or-later
// The interface of potentials, for everything that needs energies or forces.
#pragma once

#include <cstddef>
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
  bool general_only = false;   //!< do not use the fast evaluation of special cases (for comparison)
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

//! A part of the energy with the name that LAMMPS's compute pair and reports give it.
struct EnergyPart {
  std::string_view name;  //!< static text
  double energy;          //!< eV
};

//! \brief A potential of carbon and hydrogen.
//! \details Made for repeated calls: implementations keep lists and arrays between them. Must not be called from
//! several threads at once.
class Potential {
 public:
  virtual ~Potential() = default;

  //! The name on the command line, such as "rebo2".
  virtual std::string_view name() const = 0;

  //! \param positions Angstrom, finite
  //! \param elements one for each position
  //! \param cell nullptr for a molecule in free space; may hold a single atom
  //! \return valid until the next call
  virtual const Evaluation& evaluate(std::span<const Vec3> positions, std::span<const Element> elements,
                                     const Cell* cell, const EvaluationOptions& options) = 0;

  //! The parts of the last evaluation's energy; their sum is the energy.
  virtual std::vector<EnergyPart> parts() const = 0;

  //! The distances between which bonds fade.
  virtual const BondCutoffs& bond_cutoffs() const = 0;

  //! Energy per atom of a flat, relaxed sheet of graphene, eV: the reference for other energies.
  virtual double graphene_energy() const = 0;

  //! \brief What a hydrogen atom at the edge of a sheet counts for, eV: what benzene has beyond six atoms of
  //! graphene, a sixth of it.
  //! \details Carbon that binds hydrogen as benzene does is then at no cost above graphene.
  virtual double hydrogen_energy() const = 0;

  //! Energy of a structure above as many atoms of graphene, and its hydrogen as in benzene; eV.
  double above_graphene(double energy, std::size_t carbons, std::size_t hydrogens) const {
    return energy - static_cast<double>(carbons) * graphene_energy() -
           static_cast<double>(hydrogens) * hydrogen_energy();
  }

  //! The largest number of bonds over which atoms interact.
  virtual unsigned bonded_reach() const { return 3; }

  //! The largest distance at which unbonded atoms interact, Angstrom; 0 if they do not.
  virtual double unbonded_reach() const { return 0.0; }
};

}  // namespace nanocarbon::potential
