// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <memory>
#include <span>

#include "nanocarbon/core/space.h"
#include "nanocarbon/core/thread_team.h"
#include "nanocarbon/minimisation/multilevel/node_graph.h"
#include "nanocarbon/minimisation/multilevel/sheet_springs.h"

namespace nanocarbon::multilevel {

//! Below so many atoms plain L-BFGS needs less time.
inline constexpr std::size_t least_atoms = 2000;

//! \brief An approximate inverse of the Hessian of a molecule of bonded sheets, whatever its size.
//! \details One cycle of a multilevel solver (Brandt 1977) for springs that stand for the sheet: on each level a
//! sweep of block Gauss-Seidel before and one after the correction from coarser nodes, which are interpolated by
//! moving least squares; a Cholesky factorisation on the coarsest. Time and memory are linear in atoms. The
//! operator is symmetric and positive definite. A molecule in free space that nothing holds, of one
//! component, is not moved as a whole: its steps have no rigid part (which would count against the limit of their strain).
class SheetPreconditioner {
 public:
  //! \param team may be null; outlives the preconditioner
  //! \param positions Angstrom; what is near what on the sheet is taken from here once and for all
  SheetPreconditioner(const Space& space, std::span<const Vec3> positions, const NodeGraph& bonds,
                      ThreadTeam* team = nullptr, const SheetStiffness& stiffness = {});
  ~SheetPreconditioner();
  SheetPreconditioner(SheetPreconditioner&&) noexcept;
  SheetPreconditioner& operator=(SheetPreconditioner&&) noexcept;

  //! Takes the springs as they are at these positions.
  //! \param holds one for each atom, or empty
  void renew(std::span<const Vec3> positions, const Holds& holds = {});
  //! The same with the holds as they are, if atoms have moved far against their neighbours since the last time.
  void renew_if_strained(std::span<const Vec3> positions);

  //! The step that would take a gradient of the springs away, with its sign: eV/Angstrom to Angstrom.
  void apply(std::span<const Vec3> gradient, std::span<Vec3> step) const;

  //! How far a displacement moves two bonded atoms against each other, at most. Where there are several components,
  //! no less than a fifth of how far it moves any atom: they must not pass through each other.
  double strain(std::span<const Vec3> displacement) const;

 private:
  struct Levels;
  std::unique_ptr<Levels> levels_;
};

}  // namespace nanocarbon::multilevel
