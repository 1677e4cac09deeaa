// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/potential/rebo2/conjugation.h"

#include <cmath>

#include "nanocarbon/potential/rebo2/dihedral.h"
#include "nanocarbon/potential/rebo2/pair_terms.h"

namespace nanocarbon::rebo2 {

namespace {

//! How unsaturated a neighbour k of i is: F over its coordination without the bond to i.
ValueSlope unsaturation(const HalfEdges& edges, const HalfEdge& ik, const Model& model) {
  const double n_ki = edges.coordination(ik.to) - ik.weight;
  return cosine_switch(n_ki, model.parameters.conjugation_begin, model.parameters.conjugation_end);
}

//! The sum whose square enters N_conj, over the neighbours of one end but the other.
double conjugation_sum(HalfEdges& edges, const Centre& end, std::uint32_t other, const Model& model) {
  double sum = 0.0;
  for (const HalfEdge& bond : edges.of(end))
    if (bond.to != other && bond.element == Element::carbon)
      sum += bond.weight * unsaturation(edges, bond, model).value;
  return sum;
}

void add_weight_derivative(HalfEdge& edge, std::uint32_t from, double by_weight,
                           const potential::AtomShares& shares) {
  edge.by_weight += by_weight;
  if (shares.virials)
    shares.add_virial<2>({from, edge.to}, edge, by_weight * edge.weight_slope * edge.direction);
}

//! Adds the derivatives by one end's coordination and by its conjugation sum.
void add_end_derivatives(HalfEdges& edges, const Centre& end, std::uint32_t other, double by_coordination,
                         double by_conjugation_sum, const Model& model, const potential::AtomShares& shares) {
  for (HalfEdge& bond : edges.of(end)) {
    if (bond.to == other) continue;
    double by_weight = by_coordination;
    if (bond.element == Element::carbon) {
      const ValueSlope f = unsaturation(edges, bond, model);
      by_weight += by_conjugation_sum * f.value;
      if (std::abs(f.slope) > negligible)
        for (HalfEdge& next : edges.of(edges.centre(bond.to)))
          if (next.to != end.atom)
            add_weight_derivative(next, bond.to, by_conjugation_sum * bond.weight * f.slope, shares);
    }
    add_weight_derivative(bond, end.atom, by_weight, shares);
  }
}

}  // namespace

WholeBondOrder whole_bond_order(HalfEdges& edges, const Centre& i, const HalfEdge& ij, const Centre& j,
                                const Model& model) {
  WholeBondOrder order = {};
  const double sum_i = conjugation_sum(edges, i, j.atom, model);
  const double sum_j = conjugation_sum(edges, j, i.atom, model);
  order.conjugation_sums = {sum_i, sum_j};
  const double n_ij = i.coordination() - ij.weight;
  const double n_ji = j.coordination() - ij.weight;
  const double n_conj = 1.0 + sum_i * sum_i + sum_j * sum_j;
  order.pi = model.tables.f(i.element, j.element).evaluate(n_ij, n_ji, n_conj);
  if (i.element == Element::carbon && j.element == Element::carbon) {
    order.torsion = model.tables.t_cc.evaluate(n_ij, n_ji, n_conj);
    if (std::abs(order.torsion.value) <= negligible) order.torsion = {0.0, {0.0, 0.0, 0.0}};
  }
  order.dihedrals = order.torsion.value != 0.0 ? dihedral_sum(edges, i, ij, j, model) : 0.0;
  for (int d = 0; d < 3; ++d) order.slope[d] = order.pi.slope[d] + order.torsion.slope[d] * order.dihedrals;
  return order;
}

void add_whole_bond_order_derivatives(HalfEdges& edges, const Centre& i, HalfEdge& ij, const Centre& j,
                                      const WholeBondOrder& order, double strength, const Model& model,
                                      const potential::AtomShares& shares) {
  if (!order.flat()) {
    const auto& [by_i, by_j, by_conj] = order.slope;
    const auto& [sum_i, sum_j] = order.conjugation_sums;
    add_end_derivatives(edges, i, j.atom, strength * by_i, strength * by_conj * 2.0 * sum_i, model, shares);
    add_end_derivatives(edges, j, i.atom, strength * by_j, strength * by_conj * 2.0 * sum_j, model, shares);
  }
  if (order.torsion.value != 0.0)
    add_dihedral_derivatives(edges, i, ij, j, model, strength * order.torsion.value, shares);
}

EnergyParts add_bond_terms(HalfEdges& edges, const Centre& i, HalfEdge& ij, const Model& model, double share,
                           const potential::AtomShares& shares) {
  EnergyParts energy;
  if (ij.weight <= negligible) return energy;
  if (model.torsion && i.element == Element::carbon && ij.element == Element::carbon)
    energy.torsion = add_torsion_energy(edges, i, ij, *model.torsion, share, shares);
  const Centre& j = edges.centre(ij.to);
  const WholeBondOrder order = whole_bond_order(edges, i, ij, j, model);
  const double value = order.value();
  if (value == 0.0 && order.torsion.value == 0.0 && order.flat()) return energy;

  const PairParameters& pair = model.parameters.pairs[pair_index(i.element, j.element)];
  const ValueSlope attraction = pair_attraction(pair, ij.length);
  const double strength = share * ij.weight * attraction.value;
  energy.conjugation = strength * order.pi.value;
  energy.dihedral = strength * order.torsion.value * order.dihedrals;
  shares.add_bond_energy(i.atom, j.atom, strength * value);

  const double by_length = share * ij.weight * attraction.slope * value;
  const double by_weight = share * attraction.value * value;
  ij.by_length += by_length;
  ij.by_weight += by_weight;
  if (shares.virials)
    shares.add_virial<2>({i.atom, j.atom}, ij, (by_length + by_weight * ij.weight_slope) * ij.direction);
  add_whole_bond_order_derivatives(edges, i, ij, j, order, strength, model, shares);
  return energy;
}

}  // namespace nanocarbon::rebo2
