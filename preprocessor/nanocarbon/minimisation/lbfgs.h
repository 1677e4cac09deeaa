// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "nanocarbon/core/thread_team.h"
#include "nanocarbon/core/vec3.h"

namespace nanocarbon::multilevel {
class SheetPreconditioner;
}

namespace nanocarbon::minimisation {

//! An energy of atom positions: returns eV and fills the gradient (eV/Angstrom), which comes zeroed.
using EnergyFunction = std::function<double(std::span<const Vec3> positions, std::span<Vec3> gradient)>;

struct LbfgsOptions {
  int max_iterations = 200;
  double force_tolerance = 1e-3;  //!< eV/Angstrom, on the largest force on an atom
  double max_step = 0.1;          //!< Angstrom, the farthest any atom moves in one iteration
  //! Where steps begin instead of a multiple of the gradient: iterations then hardly grow with the number of
  //! atoms. Renewed on the way. It limits how far bonded atoms move against each other, not how far they move:
  //! max_step does not count. May be null.
  multilevel::SheetPreconditioner* preconditioner = nullptr;
  double max_strain = 0.2;     //!< Angstrom, of bonded atoms against each other, with a preconditioner
  int memory = 6;              //!< pairs; more of them cost more than they save
  ThreadTeam* team = nullptr;  //!< of what is done here, not of the energy; may be null
  //! Asked after each iteration; true ends the minimisation early. May be empty.
  std::function<bool(int iteration, double energy, std::span<const Vec3> positions)> stop = {};
};

struct LbfgsResult {
  double energy = 0;     //!< eV, at the positions returned
  double max_force = 0;  //!< eV/Angstrom
  int iterations = 0;
  bool converged = false;
};

//! \brief Minimises an energy by L-BFGS with a step limit for each atom, preconditioned if wanted.
//! \details Two-loop recursion (Nocedal and Wright, algorithm 7.4), backtracking until the energy does not
//! rise; pairs without positive curvature are left out. Energies that agree to rounding count as equal, so
//! that forces converge further than the energy's digits would show. Written here because the step limit and
//! early exit are needed.
LbfgsResult minimise_lbfgs(std::vector<Vec3>& positions, const EnergyFunction& energy,
                           const LbfgsOptions& options);

//! Largest norm among the vectors.
double largest_norm(std::span<const Vec3> vectors, ThreadTeam* team = nullptr);

}  // namespace nanocarbon::minimisation
