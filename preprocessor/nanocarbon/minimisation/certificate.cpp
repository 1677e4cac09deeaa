// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/minimisation/certificate.h"

#include <algorithm>
#include <iterator>

#include "nanocarbon/minimisation/hessian_spectrum.h"
#include "nanocarbon/minimisation/minimise_molecule.h"
#include "nanocarbon/minimisation/sparse_hessian.h"
#include "nanocarbon/topology/connected_components.h"

namespace nanocarbon::minimisation {

namespace {

constexpr double push = 0.05;  // Angstrom, of the atom that moves farthest

//! Atoms of either rows.
CouplingRows merged(const CouplingRows& a, const CouplingRows& b) {
  CouplingRows rows{{0}, {}};
  for (std::size_t atom = 0; atom + 1 < a.offsets.size(); ++atom) {
    const auto first = a.of(atom), second = b.of(atom);
    std::set_union(first.begin(), first.end(), second.begin(), second.end(), std::back_inserter(rows.atoms));
    rows.offsets.push_back(rows.atoms.size());
  }
  return rows;
}

//! Which atoms' forces may change when an atom moves.
CouplingRows coupled_by(const Molecule& molecule, const potential::Potential& potential) {
  const double cutoff = potential.bond_cutoffs().carbon_carbon.end;  // the longest of all
  CouplingRows bonded =
      coupled_atoms(neighbours_within(molecule.positions, nullptr, cutoff), potential.bonded_reach());
  if (!(potential.unbonded_reach() > 0)) return bonded;
  return merged(bonded,
                coupled_atoms(neighbours_within(molecule.positions, nullptr, potential.unbonded_reach()), 1));
}

//! What moves on its own: components of the bonds, or of all that act on each other.
topology::Components loose_parts(const Molecule& molecule, const CouplingRows& coupled) {
  std::vector<Bond> links = molecule.bonds;
  for (AtomIndex a = 0; a < molecule.size(); ++a)
    for (const std::uint32_t b : coupled.of(a))
      if (a < b) links.push_back({a, b});
  return topology::connected_components(molecule.size(), links);
}

HessianSpectrum spectrum_of(const Molecule& molecule, potential::Potential& potential, int eigenvalues) {
  const CouplingRows coupled = coupled_by(molecule, potential);
  const topology::Components components = loose_parts(molecule, coupled);
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
