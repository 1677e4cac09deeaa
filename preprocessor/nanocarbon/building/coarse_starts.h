// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cmath>
#include <optional>

#include "nanocarbon/annealing/annealing_level.h"
#include "nanocarbon/building/annealed_options.h"

namespace nanocarbon::building {

//! \brief The starts that are annealed with a quarter of the atoms, or a quarter of that, to be refined.
//! \details On the surface at the scale of so few atoms: a coarse sheet is the stiffer one for its size, so
//! that it is held to the surface more than asked for, and thin parts are made wide enough for it where it
//! fails without. Each start has a seed of its own. Of no use are those from too few atoms for the topology,
//! those far from the surface, those that leave out or lose parts of the shape, those that overstretch a
//! bond, and at a sixteenth of the atoms those bent so sharply that annealing takes too long.
class CoarseStarts {
 public:
  //! \param surface Angstrom at full size
  //! \param atoms at full size
  //! \param refinements quarterings, from 1
  CoarseStarts(const TriangleMesh& surface, std::size_t atoms, int refinements, Triangulator triangulate,
               AnnealOptions options);

  //! Whether there is another one to try: not where so much was lost by annealing that more will be of no
  //! use.
  bool left() const { return attempt_ < attempts_ && annealed_ < attempts_ && !lost_for_good_; }

  //! The next one, annealed. Nothing where it is of no use.
  //! \pre left()
  std::optional<annealing::AnnealingLevel> next();

 private:
  double scale() const { return std::ldexp(1.0, -refinements_); }
  bool make_room();
  std::optional<annealing::AnnealingLevel> triangulated() const;
  bool too_bent(const annealing::AnnealingLevel& level) const;
  std::optional<annealing::AnnealingLevel> annealed();

  TriangleMesh surface_;  // at the scale of the level
  const std::size_t atoms_;
  const int refinements_;
  const Triangulator triangulate_;
  const AnnealOptions options_;
  const int attempts_;
  int attempt_ = 0;
  int annealed_ = 0;
  bool roomy_ = false;  // thin parts are as wide as the level needs
  bool lost_for_good_ = false;
};

}  // namespace nanocarbon::building
