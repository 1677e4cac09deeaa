// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/minimisation/certificate.h"

#include <algorithm>

#include "nanocarbon/minimisation/hessian_spectrum.h"
#include "nanocarbon/minimisation/minimise_molecule.h"
#include "nanocarbon/minimisation/sparse_hessian.h"
#include "nanocarbon/topology/connected_components.h"

namespace nanocarbon::minimisation {

namespace {

constexpr double push = 0.05;  // Angstrom, of the atom that moves farthest

HessianSpectrum spectrum_of(const Molecule& molecule, potential::Potential& potential, int eigenvalues) {
  const double cutoff = potential.bond_cutoffs().carbon_carbon.end;  // the longest of all
  const CouplingRows coupled =
      coupled_atoms(neighbours_within(molecule.positions, nullptr, cutoff), potential.bonded_reach());
  const topology::Components components = topology::connected_components(molecule.size(), molecule.bonds);
  return smallest_eigenvalues(sparse_hessian(molecule.positions, coupled, energy_of(molecule, potential)),
                              RigidMotions(molecule.positions, components.of_atom), eigenvalues);
}

// Moves a molecule off a saddle along a mode, whichever way ends lower.
MinimisationResult leave_saddle(Molecule& molecule, potential::Potential& potential,
                                const Eigen::VectorXd& mode, const MinimisationOptions& options) {
  double farthest = 0;
  for (Eigen::Index k = 0; k < mode.size(); k += 3) farthest = std::max(farthest, mode.segment<3>(k).norm());
  const Molecule saddle = molecule;
  MinimisationResult best;
  for (const double way : {1.0, -1.0}) {
    Molecule pushed = saddle;
    for (std::size_t a = 0; a < pushed.size(); ++a)
      pushed.positions[a] += way * push / farthest * mode.segment<3>(static_cast<Eigen::Index>(3 * a));
    const MinimisationResult minimised = minimise_molecule(pushed, potential, options);
    const bool better = minimised.intact != best.intact ? minimised.intact : minimised.energy < best.energy;
    if (way > 0 || better) {
      best = minimised;
      molecule = std::move(pushed);
    }
  }
  return best;
}

}  // namespace

Certificate certify(Molecule& molecule, potential::Potential& potential, const CertificateOptions& options) {
  const MinimisationOptions minimisation{.force_tolerance = options.force_tolerance};
  MinimisationResult minimised = minimise_molecule(molecule, potential, minimisation);
  HessianSpectrum spectrum = spectrum_of(molecule, potential, options.eigenvalues);
  Certificate certificate;
  const auto at_saddle = [&] {
    return !spectrum.smallest.empty() && spectrum.smallest.front() < -spectrum.uncertainty;
  };
  for (; at_saddle() && certificate.pushes < options.pushes; ++certificate.pushes) {
    minimised = leave_saddle(molecule, potential, spectrum.mode, minimisation);
    spectrum = spectrum_of(molecule, potential, options.eigenvalues);
  }
  certificate.energy = minimised.energy;
  certificate.max_force = minimised.max_force;
  certificate.eigenvalues = spectrum.smallest;
  certificate.uncertainty = spectrum.uncertainty;
  certificate.complete = spectrum.complete;
  certificate.intact = minimised.intact;
  return certificate;
}

}  // namespace nanocarbon::minimisation
