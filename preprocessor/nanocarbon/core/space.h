// SPDX-License-Identifier: GPL-2.0-or-later
// Where positions are: in free space, or in a cell that is periodic in one to three directions.
#pragma once

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

  //! The least distance between a point and an image of it; infinite in free space.
  double least_width() const { return least_width_; }
  //! The same space with all lengths times a factor above zero.
  Space scaled(double factor) const;

 private:
  Vec3 nearest_image(const Vec3& difference) const;

  std::optional<Cell> cell_;
  Mat3 to_fractional_ = Mat3::Zero();
  double least_width_ = std::numeric_limits<double>::infinity();
  double safe_squared_ = std::numeric_limits<double>::infinity();  // square of half the least width
};

}  // namespace nanocarbon
