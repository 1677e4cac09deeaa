// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <span>

#include "nanocarbon/annealing/fixed_bond_graph.h"
#include "nanocarbon/core/thread_team.h"
#include "nanocarbon/core/vec3.h"

namespace nanocarbon::building {

//! \brief Tells a minimisation of the full potential that goes on for long and will not hold.
//! \details Where sheets are pressed onto each other, atoms creep along REBO2's cut-off for hundreds of iterations, and in
//! the end others are bound than should be. Sees that by looking now and then.
class PressedWatch {
 public:
  static constexpr int between = 50;  //!< iterations from one look to the next
  static constexpr int looks = 4;     //!< so many in a row have to see it

  //! \param graph of the carbons; outlives this
  explicit PressedWatch(const annealing::FixedBondGraph& graph, ThreadTeam* team = nullptr)
      : graph_(graph), team_(team) {}

  //! Whether REBO2 has seen other bonds than the graph's for long.
  //! \param positions the carbons', which hydrogens may follow
  bool for_good(int iteration, std::span<const Vec3> positions);

 private:
  const annealing::FixedBondGraph& graph_;
  ThreadTeam* team_;
  int pressed_ = 0;
};

}  // namespace nanocarbon::building
