// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/potential/rebo2/torsion_energy.h"

#include "nanocarbon/potential/rebo2/dihedral_arms.h"

namespace nanocarbon::rebo2 {

namespace {

//! 256/405 cos^10(omega/2) - 1/10 over cos omega.
ValueSlope torsion(double cosine) {
  constexpr double scale = 256.0 / 405.0;
  const double half = 0.5 * (1.0 + cosine);
  const double fourth = half * half * half * half;
  return {scale * fourth * half - 0.1, 2.5 * scale * fourth};
}

ValueSlope bond_weight_of(const HalfEdge& edge) { return {edge.weight, edge.weight_slope}; }

}  // namespace

double add_torsion_energy(HalfEdges& edges, const Centre& i, HalfEdge& ij, const TorsionBarriers& barriers,
                          double share, const potential::AtomShares& shares) {
  if (ij.weight <= negligible) return 0.0;
  double sum = 0.0;
  for_each_dihedral(
      edges, i, ij, edges.centre(ij.to), bond_weight_of,
      [&](const DihedralArm& k, HalfEdge& ik, const DihedralArm& l, HalfEdge& jl, double cosine) {
        const double strength = share * barriers.barriers[pair_index(ik.element, jl.element)];
        const ValueSlope f = torsion(cosine);
        const double by_weight = strength * f.value * k.factor() * l.factor();
        sum += by_weight;
        const std::array<std::uint32_t, 4> atoms = {ik.to, i.atom, ij.to, jl.to};
        shares.add_energy(atoms, ij.weight * by_weight);
        if (shares.virials) shares.add_virial(atoms, ij, by_weight * ij.weight_slope * ij.direction);
        const double scale = ij.weight * strength;
        add_dihedral_slopes(i, ij, k, ik, l, jl, cosine, {scale * f.value, scale * f.slope}, shares);
      });
  ij.by_weight += sum;
  return ij.weight * sum;
}

}  // namespace nanocarbon::rebo2
