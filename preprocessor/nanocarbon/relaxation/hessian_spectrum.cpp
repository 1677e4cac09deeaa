#include "nanocarbon/relaxation/hessian_spectrum.h"

#include <Spectra/SymEigsSolver.h>
#include <Eigen/Geometry>
#include <Eigen/QR>
#include <algorithm>

namespace nanocarbon {

namespace {

using Vector = Eigen::VectorXd;
using Basis = Eigen::Matrix<double, Eigen::Dynamic, 6>;

// Above the stiffest bonds of carbon, eV/Angstrom^2.
constexpr double kRigidShift = 200;

// Orthonormal translations and infinitesimal rotations.
Basis rigid_motions(std::span<const Vec3> positions) {
  Vec3 centre = Vec3::Zero();
  for (const Vec3& p : positions) centre += p / static_cast<double>(positions.size());
  Basis basis(static_cast<Eigen::Index>(3 * positions.size()), 6);
  for (std::size_t a = 0; a < positions.size(); ++a)
    for (int d = 0; d < 3; ++d) {
      basis.block<3, 1>(static_cast<Eigen::Index>(3 * a), d) = Vec3::Unit(d);
      basis.block<3, 1>(static_cast<Eigen::Index>(3 * a), 3 + d) = Vec3::Unit(d).cross(positions[a] - centre);
    }
  const Eigen::HouseholderQR<Basis> qr(basis);
  return qr.householderQ() * Basis::Identity(basis.rows(), 6);
}

// The operator that Spectra multiplies with.
class ShiftedHessian {
 public:
  using Scalar = double;

  ShiftedHessian(std::span<const Vec3> positions, const EnergyFunction& energy, double step)
      : positions_(positions), energy_(energy), step_(step), rigid_(rigid_motions(positions)) {}

  Eigen::Index rows() const { return static_cast<Eigen::Index>(3 * positions_.size()); }
  Eigen::Index cols() const { return rows(); }
  int evaluations() const { return evaluations_; }

  void perform_op(const double* in, double* out) const {
    const Eigen::Map<const Vector> x(in, rows());
    Eigen::Map<Vector> y(out, rows());
    const Eigen::Matrix<double, 6, 1> rigid_part = rigid_.transpose() * x;
    const Vector inner = x - rigid_ * rigid_part;
    const double length = inner.norm();
    if (length == 0) {
      y = kRigidShift * (rigid_ * rigid_part);
      return;
    }
    // The farthest-moving atom moves by the step, wherever the vector is concentrated.
    double farthest = 0;
    for (Eigen::Index a = 0; a < rows(); a += 3) farthest = std::max(farthest, inner.segment<3>(a).norm());
    const double scale = step_ / farthest;
    y = (gradient_at(inner, scale) - gradient_at(inner, -scale)) / (2 * scale);
    y -= rigid_ * (rigid_.transpose() * y);
    y += kRigidShift * (rigid_ * rigid_part);
  }

 private:
  Vector gradient_at(const Vector& direction, double scale) const {
    std::vector<Vec3> moved(positions_.begin(), positions_.end()), gradient(moved.size(), Vec3::Zero());
    for (std::size_t a = 0; a < moved.size(); ++a)
      moved[a] += scale * direction.segment<3>(static_cast<Eigen::Index>(3 * a));
    energy_(moved, gradient);
    ++evaluations_;
    return Eigen::Map<const Vector>(gradient[0].data(), rows());
  }

  std::span<const Vec3> positions_;
  const EnergyFunction& energy_;
  double step_;
  Basis rigid_;
  mutable int evaluations_ = 0;
};

}  // namespace

HessianSpectrum smallest_hessian_eigenvalues(std::span<const Vec3> positions, const EnergyFunction& energy,
                                             const SpectrumOptions& options) {
  ShiftedHessian hessian(positions, energy, options.step);
  const Eigen::Index subspace = std::min<Eigen::Index>(hessian.rows(), 20 * options.count);
  Spectra::SymEigsSolver<ShiftedHessian> solver(hessian, options.count, subspace);
  solver.init();
  solver.compute(Spectra::SortRule::SmallestAlge, options.max_restarts, options.tolerance,
                 Spectra::SortRule::SmallestAlge);
  HessianSpectrum spectrum;
  spectrum.converged = solver.info() == Spectra::CompInfo::Successful;
  const Vector values = solver.eigenvalues();
  spectrum.smallest.assign(values.begin(), values.end());
  spectrum.evaluations = hessian.evaluations();
  return spectrum;
}

}  // namespace nanocarbon
