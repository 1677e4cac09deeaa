// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <Eigen/SparseCore>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "nanocarbon/core/neighbours_within.h"
#include "nanocarbon/minimisation/lbfgs.h"

namespace nanocarbon::minimisation {

//! Atoms at most `reach` steps away from each atom, itself included, in compressed rows.
struct CouplingRows {
  std::vector<std::size_t> offsets;
  std::vector<std::uint32_t> atoms;

  std::span<const std::uint32_t> of(std::size_t atom) const {
    return {atoms.data() + offsets[atom], atoms.data() + offsets[atom + 1]};
  }
};
CouplingRows coupled_atoms(const NeighbourList& neighbours, unsigned reach);

//! \brief The Hessian of an energy by central differences of its forces, eV/Angstrom^2.
//! \details Atoms that share no row are displaced together (Curtis, Powell and Reid 1974), so that a few
//! hundred evaluations do whatever the size.
//! \param coupled which atoms' forces may change when an atom moves
//! \param step of the differences, Angstrom. REBO2's angular spline has a knot at 120 degrees, where all
//! angles of graphene lie: errors are linear in the step there, 1e-5 eV/Angstrom^2 at 2e-6 Angstrom
Eigen::SparseMatrix<double> sparse_hessian(std::span<const Vec3> positions, const CouplingRows& coupled,
                                           const EnergyFunction& energy, double step = 2e-6);

}  // namespace nanocarbon::minimisation
