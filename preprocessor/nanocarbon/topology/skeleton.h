// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "nanocarbon/topology/embedded_graph.h"
#include "nanocarbon/topology/not_a_surface.h"

namespace nanocarbon::topology {

//! The part of a bond graph that its surface is read off: carbon, without trees that hang on by one bond.
struct Skeleton {
  static constexpr std::uint32_t none = 0xffffffffu;
  std::vector<std::uint32_t>
      twin;  //!< of each half-edge: the same bond's other end; none outside the skeleton
  std::vector<std::uint8_t> degree;      //!< of each atom: 3, 2 or 0
  std::vector<std::uint32_t> component;  //!< of each atom, also outside the skeleton; numbered by lowest atom
  std::uint32_t components = 0;          //!< how many
  std::optional<NotASurface> problem;    //!< an atom with four carbon bonds or a bond known at one end only;
                                         //!< then only `component` counts
};

//! \brief Finds the skeleton, linear.
//! \details A hydrogen hangs on its nearest neighbour only and belongs to that one's component.
Skeleton find_skeleton(const EmbeddedGraph& graph);

}  // namespace nanocarbon::topology
