// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <Eigen/SparseCore>
#include <cstddef>
#include <vector>

#include "nanocarbon/minimisation/rigid_motions.h"

namespace nanocarbon::minimisation {

struct HessianSpectrum {
  std::vector<double> smallest;  //!< ascending, rigid motions set aside, eV/Angstrom^2
  Eigen::VectorXd mode;          //!< the unit displacement that belongs to the first of them
  //! eV/Angstrom^2: how far the rigid motions' own eigenvalues are from zero, and how well the modes found
  //! are eigenvectors. Eigenvalues closer to zero than this say nothing.
  double uncertainty = 0;
  //! The eigenvalues were found, and there are no others below half of the first positive one, or below the
  //! first where that is negative: counted, not searched, by Sylvester's law of inertia.
  bool complete = false;
};

//! \brief The smallest eigenvalues of a Hessian apart from rigid motions.
//! \details Lanczos (Spectra) on the shifted and inverted matrix, by a sparse factorisation; a second
//! factorisation counts the eigenvalues below, so that none can have been missed.
//! \param count eigenvalues wanted
HessianSpectrum smallest_eigenvalues(const Eigen::SparseMatrix<double>& hessian, const RigidMotions& rigid,
                                     int count);

}  // namespace nanocarbon::minimisation
