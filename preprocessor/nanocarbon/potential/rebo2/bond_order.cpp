// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/potential/rebo2/bond_order.h"

#include <cmath>

#include "nanocarbon/potential/rebo2/angular_spline.h"
#include "nanocarbon/potential/rebo2/pair_terms.h"

namespace nanocarbon::rebo2 {

namespace {

//! The coordination of a centre without one of its bonds: N_ij^C and N_ij^H.
struct Coordination {
  double carbons;
  double hydrogens;
  double total() const { return carbons + hydrogens; }
};

Coordination without(const Centre& centre, const HalfEdge& edge) {
  if (edge.element == Element::carbon) return {centre.carbons - edge.weight, centre.hydrogens};
  return {centre.carbons, centre.hydrogens - edge.weight};
}

BicubicValue evaluate_p(const Model& model, Element centre, Element other, const Coordination& n) {
  if (centre == Element::hydrogen) return {0.0, {0.0, 0.0}};
  return (other == Element::carbon ? model.tables.p_cc : model.tables.p_ch).evaluate(n.carbons, n.hydrogens);
}

constexpr double lambda_slope = 4.0;

//! The angle between bonds ij and ik at i, with e^lambda at hydrogen (equation 12 and Stuart et al. 2000).
AngleTerm evaluate_angle(const Model& model, Element centre, const HalfEdge& ij, double ij_length,
                         const HalfEdge& ik, double n_ij) {
  const double cosine = std::clamp(ij.direction.dot(ik.direction), -1.0, 1.0);
  if (centre == Element::carbon) return {cosine, 1.0, angular_carbon(model.parameters.carbon, cosine, n_ij)};
  const auto slack = [&](const HalfEdge& edge, double length) {
    return model.parameters.pairs[pair_index(Element::hydrogen, edge.element)].equilibrium - length;
  };
  return {cosine, std::exp(lambda_slope * (slack(ik, ik.length) - slack(ij, ij_length))),
          angular_hydrogen(model.parameters.hydrogen, cosine)};
}

}  // namespace

HalfBondOrder half_bond_order(std::span<const HalfEdge> bonds, const Centre& centre, const HalfEdge& ij,
                              double length, const Model& model, std::vector<AngleTerm>& angles) {
  angles.resize(bonds.size());
  const Coordination n = without(centre, ij);
  double sum = 0.0;
  double sum_by_n = 0.0;
  for (std::size_t k = 0; k < bonds.size(); ++k) {
    if (bonds[k].to == ij.to) continue;
    angles[k] = evaluate_angle(model, centre.element, ij, length, bonds[k], n.total());
    const double weight = bonds[k].weight * angles[k].stretch;
    sum += weight * angles[k].g.value;
    sum_by_n += weight * angles[k].g.by_coordination;
  }
  const BicubicValue p_spline = evaluate_p(model, centre.element, ij.element, n);
  return {1.0 / std::sqrt(1.0 + sum + p_spline.value), sum_by_n, p_spline.slope};
}

void add_half_bond_order_derivatives(std::span<HalfEdge> bonds, const Centre& centre, HalfEdge& ij,
                                     const HalfBondOrder& order, double by_sum, bool length_is_real,
                                     const std::vector<AngleTerm>& angles,
                                     const potential::AtomShares& shares) {
  const double by_carbons = by_sum * (order.spline_slope[0] + order.sum_by_coordination);
  const double by_hydrogens = by_sum * (order.spline_slope[1] + order.sum_by_coordination);
  for (std::size_t k = 0; k < bonds.size(); ++k) {
    HalfEdge& ik = bonds[k];
    if (ik.to == ij.to) continue;
    const AngleTerm& angle = angles[k];
    const double by_weight =
        by_sum * angle.g.value * angle.stretch + (ik.element == Element::carbon ? by_carbons : by_hydrogens);
    const double by_cosine = by_sum * ik.weight * angle.stretch * angle.g.by_cosine;
    const double by_stretch = centre.element == Element::hydrogen
                                  ? by_sum * ik.weight * angle.stretch * angle.g.value * lambda_slope
                                  : 0.0;
    const double by_length = length_is_real ? by_stretch : 0.0;
    ij.by_direction += by_cosine * ik.direction;
    ik.by_direction += by_cosine * ij.direction;
    ij.by_length += by_length;
    ik.by_length -= by_stretch;
    ik.by_weight += by_weight;
    if (shares.virials) {
      const std::array<std::uint32_t, 3> atoms = {centre.atom, ij.to, ik.to};
      shares.add_virial(atoms, ij, half_edge_pull(ij, by_length, by_cosine * ik.direction));
      shares.add_virial(
          atoms, ik, half_edge_pull(ik, by_weight * ik.weight_slope - by_stretch, by_cosine * ij.direction));
    }
  }
}

EnergyParts add_centre_terms(HalfEdges& edges, const Centre& centre, const Model& model,
                             std::vector<AngleTerm>& scratch, const potential::AtomShares& shares) {
  const std::span<HalfEdge> bonds = edges.of(centre);
  EnergyParts energy;
  for (HalfEdge& ij : bonds) {
    if (ij.weight <= negligible) continue;
    const HalfBondOrder p = half_bond_order(bonds, centre, ij, ij.length, model, scratch);
    const PairParameters& pair = model.parameters.pairs[pair_index(centre.element, ij.element)];
    const ValueSlope repulsion = pair_repulsion(pair, ij.length);
    const ValueSlope attraction = pair_attraction(pair, ij.length);
    const double repulsive = 0.5 * ij.weight * repulsion.value;
    const double sigma_pi = 0.5 * ij.weight * attraction.value * p.value;
    energy.repulsive += repulsive;
    energy.sigma_pi += sigma_pi;
    shares.add_bond_energy(centre.atom, ij.to, repulsive + sigma_pi);

    const double pair_by_length = 0.5 * ij.weight * (repulsion.slope + p.value * attraction.slope);
    const double pair_by_weight = 0.5 * (repulsion.value + p.value * attraction.value);
    ij.by_length += pair_by_length;
    ij.by_weight += pair_by_weight;
    if (shares.virials)
      shares.add_virial<2>({centre.atom, ij.to}, ij,
                           (pair_by_length + pair_by_weight * ij.weight_slope) * ij.direction);

    const double by_sum = -0.5 * p.value * p.value * sigma_pi;  // dp/dsum = -p^3/2
    add_half_bond_order_derivatives(bonds, centre, ij, p, by_sum, true, scratch, shares);
  }
  return energy;
}

}  // namespace nanocarbon::rebo2
