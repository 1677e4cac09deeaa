// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/potential/airebo/long_range.h"

#include "nanocarbon/potential/rebo2/switching.h"

namespace nanocarbon::airebo {

using potential::AtomShares;
using potential::AtomsView;
using rebo2::Centre;
using rebo2::HalfEdge;
using rebo2::HalfEdges;
using rebo2::ValueSlope;

namespace {

//! Adds the derivatives of an energy by the weight of a path to its bonds.
void add_path_derivatives(std::uint32_t i, const BondPath& path, double by_weight, HalfEdges& edges,
                          const AtomShares& shares) {
  for (int b = 0; b < path.length; ++b) {
    double others = by_weight;
    for (int c = 0; c < path.length; ++c)
      if (c != b) others *= edges[path.bonds[c]].weight;
    HalfEdge& bond = edges[path.bonds[b]];
    bond.by_weight += others;
    if (!shares.virials) continue;
    const Vec3 pull = others * bond.weight_slope * bond.direction;
    const std::uint32_t first = edges[path.bonds[0]].to;
    if (path.length == 1)
      shares.add_virial<2>({i, path.to}, bond, pull);
    else if (path.length == 2)
      shares.add_virial<3>({i, first, path.to}, bond, pull);
    else
      shares.add_virial<4>({i, first, edges[path.bonds[1]].to, path.to}, bond, pull);
  }
}

}  // namespace

void add_bonds_for(const LongRangeTerm& term, const AtomsView& atoms, const potential::NearPairs& near,
                   const AireboModel& model, HalfEdges& edges) {
  const auto position = [&](std::uint32_t atom) {
    return Eigen::Map<const Vec3>(atoms.positions + 3 * std::size_t{atom});
  };
  const std::size_t elements = rebo2::pair_index(atoms.elements[term.i], atoms.elements[term.j]);
  const double end = model.parameters.long_range[elements].length_switch_end;
  if (!((position(term.j) - position(term.i)).squaredNorm() < end * end)) return;
  for (const std::uint32_t atom : {term.i, term.j}) {
    edges.add(atom, atoms, near, model.parameters.rebo);
    const Centre centre = edges.centre(atom);
    for (std::uint32_t e = centre.first; e < centre.first + centre.count; ++e)
      edges.add(edges[e].to, atoms, near, model.parameters.rebo);
  }
}

double add_long_range_term(const LongRangeTerm& term, const AtomsView& atoms, const AireboModel& model,
                           HalfEdges& edges, HypotheticalBondScratch& scratch, double* forces,
                           const AtomShares& shares) {
  const std::size_t elements = rebo2::pair_index(atoms.elements[term.i], atoms.elements[term.j]);
  const LongRangeParameters& pair = model.parameters.long_range[elements];
  const HalfEdge ij = half_edge(atoms, term.i, term.j, model.parameters.rebo);
  const LjValue v = lj_value(model.lj, elements, ij.length);
  const ValueSlope s_r = rebo2::cubic_switch(ij.length, pair.length_switch_begin, pair.length_switch_end);
  const double c = term.share * (term.path ? term.c - term.path->weight : term.c);

  ValueSlope s_b = {0.0, 0.0};
  if (s_r.value > 0.0) {
    HypotheticalBond bond = evaluate_hypothetical_bond(edges, term.i, ij, model.rebo, scratch);
    s_b = rebo2::cubic_switch(bond.order(), pair.order_switch_begin, pair.order_switch_end);
    if (s_b.slope != 0.0)
      add_hypothetical_bond_derivatives(edges, term.i, bond, c * v.energy * s_r.value * s_b.slope, model.rebo,
                                        scratch, forces, shares);
  }
  const double part = term.d - s_r.value * (1.0 - s_b.value);
  const double energy = c * v.energy * part;
  shares.add_bond_energy(term.i, term.j, energy);

  const double by_length = c * (v.slope * part - v.energy * s_r.slope * (1.0 - s_b.value));
  const Vec3 pull = by_length * ij.direction;
  Eigen::Map<Vec3>(forces + 3 * std::size_t{term.i}) += pull;
  Eigen::Map<Vec3>(forces + 3 * std::size_t{term.j}) -= pull;
  if (shares.virials) shares.add_virial<2>({term.i, term.j}, ij, pull);
  if (term.path) add_path_derivatives(term.i, *term.path, -term.share * v.energy * part, edges, shares);
  return energy;
}

}  // namespace nanocarbon::airebo
