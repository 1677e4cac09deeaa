// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/potential/rebo2/dihedral.h"

#include <algorithm>
#include <cmath>

#include "nanocarbon/potential/rebo2/pair_terms.h"

namespace nanocarbon::rebo2 {

namespace {

//! One arm of a dihedral: a neighbour k of one end, seen from the bond's axis.
struct Arm {
  double cosine;  //!< between the axis and the arm, towards the other end of the bond
  double sine_squared;
  ValueSlope weight;      //!< w' over the arm's length
  ValueSlope not_linear;  //!< 1 - Sp2 over the cosine
  bool counts;
  double factor() const { return weight.value * not_linear.value; }
};

Arm make_arm(const HalfEdge& arm, const Vec3& axis, const Model& model) {
  const PairParameters& pair = model.parameters.pairs[pair_index(Element::carbon, arm.element)];
  const double cosine = std::clamp(axis.dot(arm.direction), -1.0, 1.0);
  const double sine_squared = 1.0 - cosine * cosine;
  ValueSlope weight = {arm.weight, arm.weight_slope};
  if (pair.dihedral_cutoff_end != pair.cutoff_end)
    weight = cosine_switch(arm.length, pair.cutoff_begin, pair.dihedral_cutoff_end);
  const ValueSlope linear = cubic_switch(cosine, linear_angle_begin, linear_angle_end);
  return {cosine,
          sine_squared,
          weight,
          {1.0 - linear.value, -linear.slope},
          std::sqrt(sine_squared) > negligible};
}

//! Calls visit(arm at i, its half-edge, arm at j, its half-edge, cosine product) for every dihedral around
//! ij.
template <class Visit>
void for_each_dihedral(HalfEdges& edges, const Centre& i, const HalfEdge& ij, const Centre& j,
                       const Model& model, Visit&& visit) {
  for (HalfEdge& ik : edges.of(i)) {
    if (ik.to == ij.to) continue;
    const Arm k = make_arm(ik, ij.direction, model);
    if (!k.counts) continue;
    for (HalfEdge& jl : edges.of(j)) {
      if (jl.to == i.atom || jl.to == ik.to) continue;
      const Arm l = make_arm(jl, -ij.direction, model);
      if (!l.counts) continue;
      // The arms' projections onto the plane across the axis; the two ends see the axis in opposite
      // directions.
      const double product = ik.direction.dot(jl.direction) + k.cosine * l.cosine;
      visit(k, ik, l, jl, product);
    }
  }
}

}  // namespace

double dihedral_sum(HalfEdges& edges, const Centre& i, const HalfEdge& ij, const Centre& j,
                    const Model& model) {
  double sum = 0.0;
  for_each_dihedral(edges, i, ij, j, model,
                    [&](const Arm& k, const HalfEdge&, const Arm& l, const HalfEdge&, double product) {
                      const double cos2 = product * product / (k.sine_squared * l.sine_squared);
                      sum += (1.0 - cos2) * k.factor() * l.factor();
                    });
  return sum;
}

void add_dihedral_derivatives(HalfEdges& edges, const Centre& i, HalfEdge& ij, const Centre& j,
                              const Model& model, double by_sum, const potential::AtomShares& shares) {
  for_each_dihedral(
      edges, i, ij, j, model, [&](const Arm& k, HalfEdge& ik, const Arm& l, HalfEdge& jl, double product) {
        const double sines = k.sine_squared * l.sine_squared;
        const double cos2 = product * product / sines;
        const double sin2 = 1.0 - cos2;
        const double by_cos2 = -by_sum * k.factor() * l.factor();
        const double by_product = by_cos2 * 2.0 * product / sines;
        const double by_cosine_k = by_cos2 * cos2 * 2.0 * k.cosine / k.sine_squared + by_product * l.cosine +
                                   by_sum * sin2 * k.weight.value * k.not_linear.slope * l.factor();
        const double by_cosine_l = by_cos2 * cos2 * 2.0 * l.cosine / l.sine_squared + by_product * k.cosine +
                                   by_sum * sin2 * l.weight.value * l.not_linear.slope * k.factor();
        const Vec3 by_axis = by_cosine_k * ik.direction - by_cosine_l * jl.direction;
        const Vec3 by_k = by_product * jl.direction + by_cosine_k * ij.direction;
        const Vec3 by_l = by_product * ik.direction - by_cosine_l * ij.direction;
        const double by_length_k = by_sum * sin2 * k.weight.slope * k.not_linear.value * l.factor();
        const double by_length_l = by_sum * sin2 * l.weight.slope * l.not_linear.value * k.factor();
        ij.by_direction += by_axis;
        ik.by_direction += by_k;
        jl.by_direction += by_l;
        ik.by_length += by_length_k;
        jl.by_length += by_length_l;
        if (shares.virials) {
          const std::array<std::uint32_t, 4> atoms = {ik.to, i.atom, j.atom, jl.to};
          shares.add_virial(atoms, ij, half_edge_pull(ij, 0.0, by_axis));
          shares.add_virial(atoms, ik, half_edge_pull(ik, by_length_k, by_k));
          shares.add_virial(atoms, jl, half_edge_pull(jl, by_length_l, by_l));
        }
      });
}

}  // namespace nanocarbon::rebo2
