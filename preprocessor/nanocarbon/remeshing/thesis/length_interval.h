// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

namespace nanocarbon::thesis {

//! The edge lengths that are neither short nor long, Angstrom (thesis, chapter 4).
struct LengthInterval {
  double min;
  double max;

  double mean() const { return 0.5 * (min + max); }  //!< m, the length to aim at
  double half_width() const { return 0.5 * (max - min); }
  bool is_short(double length) const { return length < min; }
  bool is_long(double length) const { return length > max; }
  bool contains(double length) const { return !is_short(length) && !is_long(length); }
};

//! \brief The interval for a triangulation whose dual's bonds are to lie in the given one: times sqrt(3).
//! \details In a lattice of equilateral triangles the centroids of neighbours are 1/sqrt(3) of an edge apart.
LengthInterval edge_interval(double min_bond, double max_bond);

//! \brief The interpolated interval l_i of the i-th iteration (thesis, section 4.1).
//! \details min(2 m_i, m) -+ (l_max - l_min)/2: a fine mesh at most doubles its mean edge at a time. As
//! written the lower end falls below m_i, and at last below zero, where m_i is less than the half-width;
//! nothing would be collapsed any more. The half-width is therefore at most m_i, which changes nothing for
//! larger m_i.
//! \param mean_length m_i, the mean edge of the mesh as it is
LengthInterval interpolated_interval(const LengthInterval& target, double mean_length);

}  // namespace nanocarbon::thesis
