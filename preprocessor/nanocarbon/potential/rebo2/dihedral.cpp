// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/potential/rebo2/dihedral.h"

#include "nanocarbon/potential/rebo2/dihedral_arms.h"

namespace nanocarbon::rebo2 {

namespace {

//! w', which may end sooner than the bond's weight.
auto arm_weight(const Model& model) {
  return [&model](const HalfEdge& arm) -> ValueSlope {
    const PairParameters& pair = model.parameters.pairs[pair_index(Element::carbon, arm.element)];
    if (pair.dihedral_cutoff_end == pair.cutoff_end) return {arm.weight, arm.weight_slope};
    return cosine_switch(arm.length, pair.cutoff_begin, pair.dihedral_cutoff_end);
  };
}

}  // namespace

double dihedral_sum(HalfEdges& edges, const Centre& i, const HalfEdge& ij, const Centre& j,
                    const Model& model) {
  double sum = 0.0;
  for_each_dihedral(edges, i, ij, j, arm_weight(model),
                    [&](const DihedralArm& k, const HalfEdge&, const DihedralArm& l, const HalfEdge&,
                        double cosine) { sum += (1.0 - cosine * cosine) * k.factor() * l.factor(); });
  return sum;
}

void add_dihedral_derivatives(HalfEdges& edges, const Centre& i, HalfEdge& ij, const Centre& j,
                              const Model& model, double by_sum, const potential::AtomShares& shares) {
  for_each_dihedral(
      edges, i, ij, j, arm_weight(model),
      [&](const DihedralArm& k, HalfEdge& ik, const DihedralArm& l, HalfEdge& jl, double cosine) {
        const ValueSlope f = {by_sum * (1.0 - cosine * cosine), -2.0 * by_sum * cosine};
        add_dihedral_slopes(i, ij, k, ik, l, jl, cosine, f, shares);
      });
}

}  // namespace nanocarbon::rebo2
