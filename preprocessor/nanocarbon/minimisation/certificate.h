// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "nanocarbon/molecule/molecule.h"
#include "nanocarbon/potential/potential.h"

namespace nanocarbon::minimisation {

//! Largest force that a certificate leaves, eV/Angstrom.
inline constexpr double certified_force = 1e-6;

struct CertificateOptions {
  double force_tolerance = certified_force;  //!< eV/Angstrom; the molecule is minimised down to it first
  int eigenvalues = 3;
  int pushes = 5;  //!< off a saddle, at most
};

//! What is known of a molecule as a point of a potential's energy.
struct Certificate {
  double energy = 0;                //!< eV
  double max_force = 0;             //!< eV/Angstrom
  std::vector<double> eigenvalues;  //!< the smallest of the Hessian, rigid motions set aside, eV/Angstrom^2
  double uncertainty = 0;           //!< of the eigenvalues, eV/Angstrom^2
  bool complete = false;            //!< no eigenvalue was missed (hessian_spectrum.h)
  bool intact = false;              //!< the potential sees exactly the molecule's bonds
  int pushes = 0;                   //!< saddles that minimisation had ended at and that were left

  //! A minimum: at rest, and every deformation costs energy.
  bool minimum(double force_tolerance = certified_force) const {
    return complete && max_force < force_tolerance && !eigenvalues.empty() &&
           eigenvalues.front() > uncertainty;
  }
};

//! \brief Minimises a molecule in free space to the tolerance and looks at the Hessian there.
//! \details Where the Hessian has a negative eigenvalue the molecule is pushed along that mode, either way,
//! and minimised again. Each component of the molecule may move on its own, unless the potential acts between
//! them. Long reaches fill the Hessian: with AIREBO 2,000 atoms take about a minute, and more than linearly.
//! \pre no two bonded atoms of a component further apart than the potential's cut-off
Certificate certify(Molecule& molecule, potential::Potential& potential,
                    const CertificateOptions& options = {});

}  // namespace nanocarbon::minimisation
