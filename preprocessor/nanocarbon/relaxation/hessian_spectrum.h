#pragma once

#include <span>
#include <vector>

#include "nanocarbon/relaxation/lbfgs.h"

namespace nanocarbon {

struct SpectrumOptions {
  int count = 3;            //!< eigenvalues wanted
  double step = 1e-4;       //!< of the force differences, Angstrom
  double tolerance = 1e-5;  //!< on the eigenvalues, relative to the largest of the Hessian
  int max_restarts = 200;
};

struct HessianSpectrum {
  std::vector<double> smallest;  //!< ascending, eV/Angstrom^2; upper bounds where not converged
  bool converged = false;
  int evaluations = 0;  //!< of the energy
};

//! \brief Smallest eigenvalues of the Hessian of an energy, rigid motions set aside.
//! \details Lanczos with restarts (Spectra) on differences of forces, without ever forming the matrix: a few
//! hundred evaluations, whatever the size. Translations and rotations are moved to the upper end of the
//! spectrum. \pre positions at a stationary point, at least three of them and not on one line
HessianSpectrum smallest_hessian_eigenvalues(std::span<const Vec3> positions, const EnergyFunction& energy,
                                             const SpectrumOptions& options = {});

}  // namespace nanocarbon
