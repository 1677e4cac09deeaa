#pragma once

#include <vector>

#include "nanocarbon/molecule/molecule.h"

namespace nanocarbon {

struct CertificateOptions {
  double force_tolerance = 1e-6;  //!< eV/Angstrom; the molecule is minimised down to it first
  int eigenvalues = 3;
};

//! What is known of a molecule as a point of the REBO2 energy.
struct Certificate {
  double energy = 0;                //!< eV
  double max_force = 0;             //!< eV/Angstrom
  std::vector<double> eigenvalues;  //!< the smallest of the Hessian, rigid motions set aside, eV/Angstrom^2
  bool converged = false;           //!< the eigenvalues, to about 1e-3 eV/Angstrom^2
  bool intact = false;              //!< REBO2 sees exactly the molecule's bonds

  //! A minimum: at rest, and every deformation costs energy.
  bool minimum(double force_tolerance = 1e-6) const {
    return converged && max_force < force_tolerance && !eigenvalues.empty() && eigenvalues.front() > 0;
  }
};

//! Minimises a molecule in free space to the tolerance and looks at the Hessian there.
Certificate certify(Molecule& molecule, const CertificateOptions& options = {});

}  // namespace nanocarbon
