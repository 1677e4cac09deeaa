// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

#include "nanocarbon/potential/atom_shares.h"
#include "nanocarbon/potential/rebo2/half_edges.h"
#include "nanocarbon/potential/rebo2/pair_terms.h"

namespace nanocarbon::rebo2 {

//! One arm of a dihedral: a neighbour k of one end, seen from the bond's axis.
struct DihedralArm {
  double cosine;  //!< between the axis and the arm, towards the other end of the bond
  double sine_squared;
  ValueSlope weight;      //!< over the arm's length
  ValueSlope not_linear;  //!< 1 - Sp2 over the cosine (Stuart et al. 2000)
  double factor() const { return weight.value * not_linear.value; }
  //! LAMMPS leaves out angles with a smaller sine.
  bool counts() const { return std::sqrt(sine_squared) > negligible; }
};

inline DihedralArm make_dihedral_arm(const HalfEdge& arm, const Vec3& axis, const ValueSlope& weight) {
  const double cosine = std::clamp(axis.dot(arm.direction), -1.0, 1.0);
  const ValueSlope linear = cubic_switch(cosine, linear_angle_begin, linear_angle_end);
  return {cosine, 1.0 - cosine * cosine, weight, {1.0 - linear.value, -linear.slope}};
}

//! \brief Calls visit(arm at i, its half-edge, arm at j, its half-edge, cos omega) for every dihedral around
//! ij.
//! \details Those with k = l are left out. cos omega is 1 for cis.
//! \param weight of an arm, by its half-edge
template <class Weight, class Visit>
void for_each_dihedral(HalfEdges& edges, const Centre& i, const HalfEdge& ij, const Centre& j,
                       Weight&& weight, Visit&& visit) {
  for (HalfEdge& ik : edges.of(i)) {
    if (ik.to == ij.to) continue;
    const DihedralArm k = make_dihedral_arm(ik, ij.direction, weight(ik));
    if (!k.counts()) continue;
    for (HalfEdge& jl : edges.of(j)) {
      if (jl.to == i.atom || jl.to == ik.to) continue;
      const DihedralArm l = make_dihedral_arm(jl, -ij.direction, weight(jl));
      if (!l.counts()) continue;
      // The arms' projections onto the plane across the axis; the two ends see the axis in opposite
      // directions.
      const double product = ik.direction.dot(jl.direction) + k.cosine * l.cosine;
      visit(k, ik, l, jl, product / std::sqrt(k.sine_squared * l.sine_squared));
    }
  }
}

//! Adds the derivatives of factor_k factor_l f(cos omega) to the half-edges, f and its slope being given.
inline void add_dihedral_slopes(const Centre& i, HalfEdge& ij, const DihedralArm& k, HalfEdge& ik,
                                const DihedralArm& l, HalfEdge& jl, double cosine, const ValueSlope& f,
                                const potential::AtomShares& shares) {
  const double by_cosine = f.slope * k.factor() * l.factor();
  const double by_product = by_cosine / std::sqrt(k.sine_squared * l.sine_squared);
  const double by_cosine_k = by_cosine * cosine * k.cosine / k.sine_squared + by_product * l.cosine +
                             f.value * k.weight.value * k.not_linear.slope * l.factor();
  const double by_cosine_l = by_cosine * cosine * l.cosine / l.sine_squared + by_product * k.cosine +
                             f.value * l.weight.value * l.not_linear.slope * k.factor();
  const Vec3 by_axis = by_cosine_k * ik.direction - by_cosine_l * jl.direction;
  const Vec3 by_k = by_product * jl.direction + by_cosine_k * ij.direction;
  const Vec3 by_l = by_product * ik.direction - by_cosine_l * ij.direction;
  const double by_length_k = f.value * k.weight.slope * k.not_linear.value * l.factor();
  const double by_length_l = f.value * l.weight.slope * l.not_linear.value * k.factor();
  ij.by_direction += by_axis;
  ik.by_direction += by_k;
  jl.by_direction += by_l;
  ik.by_length += by_length_k;
  jl.by_length += by_length_l;
  if (shares.virials) {
    const std::array<std::uint32_t, 4> atoms = {ik.to, i.atom, ij.to, jl.to};
    shares.add_virial(atoms, ij, half_edge_pull(ij, 0.0, by_axis));
    shares.add_virial(atoms, ik, half_edge_pull(ik, by_length_k, by_k));
    shares.add_virial(atoms, jl, half_edge_pull(jl, by_length_l, by_l));
  }
}

}  // namespace nanocarbon::rebo2
