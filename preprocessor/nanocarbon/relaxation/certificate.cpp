#include "nanocarbon/relaxation/certificate.h"

#include <algorithm>

#include "nanocarbon/molecule/connected_pieces.h"
#include "nanocarbon/rebo2/rebo2.h"
#include "nanocarbon/relaxation/hessian_spectrum.h"
#include "nanocarbon/relaxation/minimise_rebo2.h"
#include "nanocarbon/relaxation/sparse_hessian.h"

namespace nanocarbon {

namespace {

// Carbon's cut-off in REBO2, the longest of all, and how many bonds apart two atoms still share a dihedral
// angle.
constexpr double kCutOff = 2.0;
constexpr unsigned kReach = 3;

constexpr double kPush = 0.05;  // Angstrom, of the atom that moves farthest

HessianSpectrum spectrum_of(const Molecule& molecule, int eigenvalues) {
  Rebo2 rebo2;
  const auto energy = [&](std::span<const Vec3> positions, std::span<Vec3> gradient) {
    const Rebo2Result& result = rebo2.evaluate(positions, molecule.elements);
    for (std::size_t a = 0; a < gradient.size(); ++a) gradient[a] -= result.forces[a];
    return result.energy;
  };
  const CouplingRows coupled = coupled_atoms(neighbours_within(molecule.positions, nullptr, kCutOff), kReach);
  const Pieces pieces = connected_pieces(molecule.size(), molecule.bonds);
  return smallest_eigenvalues(sparse_hessian(molecule.positions, coupled, energy),
                              RigidMotions(molecule.positions, pieces.of_atom), eigenvalues);
}

// Moves a molecule off a saddle along a mode, whichever way ends lower.
Rebo2MinimisationResult leave_saddle(Molecule& molecule, const Eigen::VectorXd& mode,
                                     const Rebo2MinimisationOptions& options) {
  double farthest = 0;
  for (Eigen::Index k = 0; k < mode.size(); k += 3) farthest = std::max(farthest, mode.segment<3>(k).norm());
  const Molecule saddle = molecule;
  Rebo2MinimisationResult best;
  for (const double way : {1.0, -1.0}) {
    Molecule pushed = saddle;
    for (std::size_t a = 0; a < pushed.size(); ++a)
      pushed.positions[a] += way * kPush / farthest * mode.segment<3>(static_cast<Eigen::Index>(3 * a));
    const Rebo2MinimisationResult minimised = minimise_rebo2(pushed, options);
    const bool better = minimised.intact != best.intact ? minimised.intact : minimised.energy < best.energy;
    if (way > 0 || better) {
      best = minimised;
      molecule = std::move(pushed);
    }
  }
  return best;
}

}  // namespace

Certificate certify(Molecule& molecule, const CertificateOptions& options) {
  const Rebo2MinimisationOptions minimisation{.force_tolerance = options.force_tolerance};
  Rebo2MinimisationResult minimised = minimise_rebo2(molecule, minimisation);
  HessianSpectrum spectrum = spectrum_of(molecule, options.eigenvalues);
  Certificate certificate;
  const auto at_saddle = [&] {
    return !spectrum.smallest.empty() && spectrum.smallest.front() < -spectrum.uncertainty;
  };
  for (; at_saddle() && certificate.pushes < options.pushes; ++certificate.pushes) {
    minimised = leave_saddle(molecule, spectrum.mode, minimisation);
    spectrum = spectrum_of(molecule, options.eigenvalues);
  }
  certificate.energy = minimised.energy;
  certificate.max_force = minimised.max_force;
  certificate.eigenvalues = spectrum.smallest;
  certificate.uncertainty = spectrum.uncertainty;
  certificate.complete = spectrum.complete;
  certificate.intact = minimised.intact;
  return certificate;
}

}  // namespace nanocarbon
