// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/minimisation/hessian_spectrum.h"

#include <Spectra/SymEigsSolver.h>

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>

namespace nanocarbon::minimisation {

namespace {

using Matrix = Eigen::SparseMatrix<double>;
using Vector = Eigen::VectorXd;

// Where the spectrum is inverted, eV/Angstrom^2: off zero, where rigid motions lie, and off likely
// eigenvalues.
constexpr double spectral_shift = -1.234e-4;

// L D L^T of a Hessian minus a shift, with fill-reducing order.
class Factorisation {
 public:
  Factorisation(const Matrix& hessian, double shift) {
    Matrix shifted = hessian;
    shifted.diagonal().array() -= shift;
    solver_.compute(shifted);
  }
  bool good() const { return solver_.info() == Eigen::Success; }
  Vector solve(const Vector& right) const { return solver_.solve(right); }
  // Eigenvalues below the shift: as many as D has negative entries (Sylvester).
  Eigen::Index below() const { return (solver_.vectorD().array() < 0).count(); }

 private:
  Eigen::SimplicialLDLT<Matrix> solver_;
};

// What Spectra multiplies with: the inverse on all displacements but rigid ones, which come out as zero.
class Inverse {
 public:
  using Scalar = double;
  Inverse(const Factorisation& factors, const RigidMotions& rigid, Eigen::Index size)
      : factors_(factors), rigid_(rigid), size_(size) {}
  Eigen::Index rows() const { return size_; }
  Eigen::Index cols() const { return size_; }
  void perform_op(const double* in, double* out) const {
    Vector x = Eigen::Map<const Vector>(in, size_);
    rigid_.project_out(x);
    Vector y = factors_.solve(x);
    rigid_.project_out(y);
    Eigen::Map<Vector>(out, size_) = y;
  }

 private:
  const Factorisation& factors_;
  const RigidMotions& rigid_;
  Eigen::Index size_;
};

}  // namespace

HessianSpectrum smallest_eigenvalues(const Matrix& hessian, const RigidMotions& rigid, int count) {
  HessianSpectrum spectrum;
  const Eigen::Index size = hessian.rows(), deformations = size - rigid.count();
  const Eigen::Index wanted = std::min<Eigen::Index>(count, deformations - 1);
  const Factorisation factors(hessian, spectral_shift);
  if (wanted < 1 || !factors.good()) return spectrum;
  Inverse inverse(factors, rigid, size);
  Spectra::SymEigsSolver<Inverse> solver(inverse, wanted,
                                         std::min<Eigen::Index>(deformations, 8 * wanted + 12));
  solver.init();
  solver.compute(Spectra::SortRule::LargestMagn, 300, 1e-9);
  if (solver.info() != Spectra::CompInfo::Successful) return spectrum;

  const Vector inverted = solver.eigenvalues();
  const Eigen::MatrixXd modes = solver.eigenvectors();
  double lowest = std::numeric_limits<double>::infinity();
  for (Eigen::Index k = 0; k < inverted.size(); ++k) {
    const Vector mode = modes.col(k);
    const double value = spectral_shift + 1 / inverted[k];
    spectrum.smallest.push_back(value);
    spectrum.uncertainty = std::max(spectrum.uncertainty, (hessian * mode - value * mode).norm());
    if (value < lowest) {
      lowest = value;
      spectrum.mode = mode;
    }
  }
  std::sort(spectrum.smallest.begin(), spectrum.smallest.end());
  rigid.visit([&](const Vector& motion) {
    spectrum.uncertainty = std::max(spectrum.uncertainty, (hessian * motion).norm());
  });
  // Between zero and the first eigenvalue there must be the rigid motions and nothing else.
  const double bound = lowest > 0 ? 0.5 * lowest : 1.001 * lowest - spectrum.uncertainty;
  const Factorisation count_below(hessian, bound);
  spectrum.complete = count_below.good() && count_below.below() == (lowest > 0 ? rigid.count() : 0);
  return spectrum;
}

}  // namespace nanocarbon::minimisation
