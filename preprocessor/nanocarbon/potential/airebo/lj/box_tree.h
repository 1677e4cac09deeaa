// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "nanocarbon/core/vec3.h"

namespace nanocarbon::airebo {

//! An axis-aligned box, Angstrom.
struct Box {
  Vec3 low;
  Vec3 high;
};

//! \brief Boxes over boxes: finds those near a given one.
//! \details Fast if boxes with close numbers are close in space.
class BoxTree {
 public:
  explicit BoxTree(std::vector<Box> boxes);

  //! \brief Appends the numbers of the boxes at a distance of at most reach, in order.
  //! \param first only boxes from this number on
  void find(const Box& box, double reach, std::uint32_t first, std::vector<std::uint32_t>& found) const;

  const Box& operator[](std::uint32_t number) const { return levels_.front()[number]; }

 private:
  void find_below(std::size_t level, std::uint32_t node, const Box& box, double reach_squared,
                  std::uint32_t first, std::vector<std::uint32_t>& found) const;

  static constexpr std::uint32_t fan = 4;
  std::vector<std::vector<Box>> levels_;  // the boxes, what holds each four of them, and so on
};

}  // namespace nanocarbon::airebo
