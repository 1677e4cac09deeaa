// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/building/pressed_watch.h"

#include "nanocarbon/annealing/unknot.h"

namespace nanocarbon::building {

bool PressedWatch::for_good(int iteration, std::span<const Vec3> positions) {
  if (iteration % between != 0) return false;
  const auto carbons = positions.first(graph_.neighbours.size());
  pressed_ = annealing::tangled_atoms(carbons, graph_, team_).empty() ? 0 : pressed_ + 1;
  return pressed_ >= looks;
}

}  // namespace nanocarbon::building
