// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "nanocarbon/annealing/fixed_bond_rebo2.h"
#include "nanocarbon/annealing/steric_contacts.h"
#include "nanocarbon/annealing/surface_tether.h"
#include "nanocarbon/core/stage_clock.h"
#include "nanocarbon/minimisation/lbfgs.h"

namespace nanocarbon::annealing {

//! What holds a molecule while it is being prepared: REBO2 on fixed bonds, guards, the steric term, and a
//! tether.
struct FixedBondModel {
  FixedBondRebo2 rebo2;
  StericContacts contacts;
  std::vector<TangentPlane> planes;  //!< one for each atom; empty for no tether
  double tether = 0;                 //!< eV/Angstrom^2
  bool free_mean = true;             //!< of the heights above the surface, see add_tether()
  std::vector<TangentPlane> edges;  //!< across the surface at its boundary (boundary_curve.h); empty for none
  double reach = -open_atom_depth;  //!< of open atoms beyond these
  Running running = {};

  //! Sum of the terms in eV; gradient added to.
  double evaluate(std::span<const Vec3> positions, std::span<Vec3> gradient);
};

//! \brief Minimises the model's energy over all positions, renewing the tangent planes every `renewal` iterations.
//! \details In molecules of 20,000 atoms and more places that still feel forces are relaxed on their own in between
//! (local_relaxation.h); only what is done to the whole counts as iterations.
minimisation::LbfgsResult minimise_fixed_bonds(FixedBondModel& model, const TetherSurface* surface,
                                               std::vector<Vec3>& positions,
                                               const minimisation::LbfgsOptions& options, int renewal = 40);

}  // namespace nanocarbon::annealing
