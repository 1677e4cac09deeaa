// SPDX-License-Identifier: GPL-2.0-or-later
// Where positions are: in free space, or in a cell that is periodic in one to three directions.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>

#include "nanocarbon/core/cell.h"
#include "nanocarbon/core/vec3.h"

namespace nanocarbon {

//! \brief The space that positions lie in: what lies between two of them is a displacement in this space.
//! \details Of a periodic cell the displacement leads to the nearest image. A displacement shorter than half
//! the cell's least width is the nearest one in any cell, skewed ones too, and is taken as it is: positions
//! that are kept together cost one dot product. A value; free space by default, where every result is bit for
//! bit the plain difference.
class Space {
 public:
  Space() = default;
  //! \pre the cell is right-handed and not degenerate, and its edges are no longer than another basis of the
  //! lattice would have them by much: tilts of at most half an edge, as LAMMPS has them
  explicit Space(const Cell& cell);
  //! Free where there is no cell, as molecules keep theirs.
  explicit Space(const std::optional<Cell>& cell) {
    if (cell) *this = Space(*cell);
  }

  bool periodic() const { return cell_.has_value(); }
  //! nullptr in free space.
  const Cell* cell() const { return cell_ ? &*cell_ : nullptr; }

  //! What leads from one position to the nearest image of another, Angstrom (or the positions' own unit).
  Vec3 displacement(const Vec3& from, const Vec3& to) const {
    const Vec3 plain = to - from;
    if (!cell_ || plain.squaredNorm() < safe_squared_) return plain;
    return nearest_image(plain);
  }
  //! The image of a point that is nearest to an anchor.
  Vec3 beside(const Vec3& point, const Vec3& anchor) const {
    return cell_ ? Vec3(anchor + displacement(anchor, point)) : point;
  }

  //! Whether one position is nearer to another than to any image of that. May say no where it is far from both.
  bool is_nearest(const Vec3& one, const Vec3& other) const {
    return (other - one).squaredNorm() < safe_squared_;
  }

  //! The image of a point that lies in the cell: its fractional coordinates along periodic edges are from 0 to
  //! below 1. The point itself in free space.
  Vec3 wrapped(const Vec3& point) const;
  //! Cell multiples to add to the second position for the image of it that is nearest to the first.
  std::array<std::int32_t, 3> image(const Vec3& from, const Vec3& to) const;
  //! Of a translation by whole edges of the cell, how many of each.
  std::array<std::int32_t, 3> multiples(const Vec3& translation) const;
  //! Calls visit(shift) for no translation and then for those by an edge of the cell or several different
  //! ones, either way: where the images of the cell around it are. Once in free space.
  template <class Visit>
  void for_images(const Visit& visit) const;

  //! The least distance between a point and an image of it; infinite in free space.
  double least_width() const { return least_width_; }
  //! The same space with all lengths times a factor above zero.
  Space scaled(double factor) const;
  //! The same space strained about the origin: positions x are now at deformation * x.
  Space strained(const Mat3& deformation) const;

 private:
  Vec3 nearest_image(const Vec3& difference) const;

  std::optional<Cell> cell_;
  Mat3 to_fractional_ = Mat3::Zero();
  double least_width_ = std::numeric_limits<double>::infinity();
  double safe_squared_ = std::numeric_limits<double>::infinity();  // square of half the least width
};

template <class Visit>
void Space::for_images(const Visit& visit) const {
  visit(Vec3(Vec3::Zero()));
  if (!cell_) return;
  const auto steps = [&](std::size_t axis) { return cell_->periodic[axis] ? 1 : 0; };
  for (int i = -steps(0); i <= steps(0); ++i)
    for (int j = -steps(1); j <= steps(1); ++j)
      for (int k = -steps(2); k <= steps(2); ++k)
        if (i != 0 || j != 0 || k != 0) visit(image_shift(*cell_, {i, j, k}));
}

}  // namespace nanocarbon
