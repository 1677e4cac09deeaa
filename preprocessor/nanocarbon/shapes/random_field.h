// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "nanocarbon/core/vec3.h"

namespace nanocarbon::shapes {

//! \brief A Gaussian random field of one wave length and unit variance that repeats itself in a cube, and bumps added to
//! it.
//! \details Waves on the cube's reciprocal lattice, of about as many periods along an edge as asked for, with random
//! amplitudes and phases (Cahn 1965).
class RandomField {
 public:
  //! \param size edge of the cube, whose corner is at the origin
  //! \param waves wave lengths along the edge, from 1
  RandomField(double size, double waves, std::uint64_t seed);

  double size() const { return size_; }
  double wave_length() const { return wave_length_; }
  double operator()(const Vec3& at) const;

  //! Value, gradient and second derivatives.
  struct Jet {
    double value = 0;
    Vec3 gradient = Vec3::Zero();
    Mat3 hessian = Mat3::Zero();
  };
  Jet jet(const Vec3& at) const;

  //! Adds what is nearly a Gaussian around a point and its images.
  void add_bump(const Vec3& centre, double height, double width);

 private:
  struct Wave {
    Vec3 vector;
    double amplitude, phase;
  };
  struct Bump {
    Vec3 cosine, sine;  // of the centre's place in the cube as angles
    double height, narrow;
  };
  double size_, wave_length_;
  std::vector<Wave> waves_;
  std::vector<Bump> bumps_;
};

//! \brief Makes what is thinner than a thickness as thick as that, where the field has the value `level` on its surface.
//! \details A neck, and a wall with it, is thinnest at a saddle of the field whose value is near the level. Bumps take the
//! value there away from the level, on the side that it is on: what hangs together still does.
//! \param thickness in the field's units, up to 0.3 wave lengths
//! \return how many saddles were changed
std::size_t thicken_necks(RandomField& field, double level, double thickness);

}  // namespace nanocarbon::shapes
