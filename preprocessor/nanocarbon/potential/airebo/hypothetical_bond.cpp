// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/potential/airebo/hypothetical_bond.h"

#include "nanocarbon/potential/rebo2/pair_terms.h"

namespace nanocarbon::airebo {

using potential::AtomsView;
using rebo2::Centre;
using rebo2::HalfBondOrder;
using rebo2::HalfEdge;
using rebo2::HalfEdges;
using rebo2::Model;

HalfEdge half_edge(const AtomsView& atoms, std::uint32_t from, std::uint32_t to,
                   const rebo2::Rebo2Parameters& parameters) {
  const auto position = [&](std::uint32_t atom) {
    return Eigen::Map<const Vec3>(atoms.positions + 3 * std::size_t{atom});
  };
  const Vec3 delta = position(to) - position(from);
  const double length = delta.norm();
  const std::size_t pair = rebo2::pair_index(atoms.elements[from], atoms.elements[to]);
  const rebo2::ValueSlope weight = rebo2::bond_weight(parameters.pairs[pair], length);
  return {to, atoms.elements[to], length, weight.value, weight.slope, delta / length};
}

HypotheticalBond evaluate_hypothetical_bond(HalfEdges& edges, std::uint32_t i, const HalfEdge& ij,
                                            const Model& model, HypotheticalBondScratch& scratch) {
  const Centre& at_i = edges.centre(i);
  const Centre& at_j = edges.centre(ij.to);
  HypotheticalBond bond = {ij, ij, {}, {}, {}};
  bond.ji.to = i;
  bond.ji.element = at_i.element;
  bond.ji.direction = -ij.direction;
  const double length = model.parameters.pairs[rebo2::pair_index(at_i.element, at_j.element)].cutoff_begin;
  bond.p_ij = rebo2::half_bond_order(edges.of(at_i), at_i, bond.ij, length, model, scratch.angles_i);
  bond.p_ji = rebo2::half_bond_order(edges.of(at_j), at_j, bond.ji, length, model, scratch.angles_j);
  bond.whole = rebo2::whole_bond_order(edges, at_i, bond.ij, at_j, model);
  return bond;
}

void add_hypothetical_bond_derivatives(HalfEdges& edges, std::uint32_t i, HypotheticalBond& bond,
                                       double by_order, const Model& model,
                                       const HypotheticalBondScratch& scratch, double* forces,
                                       const potential::AtomShares& shares) {
  const Centre& at_i = edges.centre(i);
  const Centre& at_j = edges.centre(bond.ij.to);
  // dp/dsum = -p^3/2, and half of each p is in b*.
  const auto by_sum = [&](const HalfBondOrder& p) { return -0.25 * by_order * p.value * p.value * p.value; };
  rebo2::add_half_bond_order_derivatives(edges.of(at_i), at_i, bond.ij, bond.p_ij, by_sum(bond.p_ij), false,
                                         scratch.angles_i, shares);
  rebo2::add_half_bond_order_derivatives(edges.of(at_j), at_j, bond.ji, bond.p_ji, by_sum(bond.p_ji), false,
                                         scratch.angles_j, shares);
  rebo2::add_whole_bond_order_derivatives(edges, at_i, bond.ij, at_j, bond.whole, by_order, model, shares);
  const Vec3 pull = rebo2::half_edge_pull(bond.ij, 0.0, bond.ij.by_direction) -
                    rebo2::half_edge_pull(bond.ji, 0.0, bond.ji.by_direction);
  Eigen::Map<Vec3>(forces + 3 * std::size_t{i}) += pull;
  Eigen::Map<Vec3>(forces + 3 * std::size_t{bond.ij.to}) -= pull;
}

}  // namespace nanocarbon::airebo
