// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/potential/rebo2/half_edges.h"

#include "nanocarbon/potential/rebo2/pair_terms.h"

namespace nanocarbon::rebo2 {

void HalfEdges::clear(std::uint32_t atoms) {
  for (const Centre& centre : centres_) place_[centre.atom] = absent;
  if (place_.size() < atoms) place_.resize(atoms, absent);
  centres_.clear();
  edges_.clear();
}

void HalfEdges::add(std::uint32_t atom, const potential::AtomsView& atoms, const potential::NearPairs& near,
                    const Rebo2Parameters& parameters) {
  if (has(atom)) return;
  place_[atom] = static_cast<std::uint32_t>(centres_.size());
  Centre centre = {atom, atoms.elements[atom], static_cast<std::uint32_t>(edges_.size()), 0, 0.0, 0.0};
  const Eigen::Map<const Vec3> from(atoms.positions + 3 * std::size_t{atom});
  for (const std::uint32_t to : near.of(atom)) {
    const Vec3 delta = Eigen::Map<const Vec3>(atoms.positions + 3 * std::size_t{to}) - from;
    const Element element = atoms.elements[to];
    const PairParameters& pair = parameters.pairs[pair_index(centre.element, element)];
    const double squared = delta.squaredNorm();
    if (!(squared < pair.cutoff_end * pair.cutoff_end)) continue;
    const double length = std::sqrt(squared);
    const ValueSlope weight = bond_weight(pair, length);
    (element == Element::carbon ? centre.carbons : centre.hydrogens) += weight.value;
    edges_.push_back({to, element, length, weight.value, weight.slope, delta / length});
  }
  centre.count = static_cast<std::uint32_t>(edges_.size()) - centre.first;
  centres_.push_back(centre);
}

void HalfEdges::add_forces(double* forces) const {
  for (const Centre& centre : centres_) {
    Vec3 sum = Vec3::Zero();
    for (std::uint32_t e = centre.first; e < centre.first + centre.count; ++e) {
      const HalfEdge& edge = edges_[e];
      const Vec3 pull =
          half_edge_pull(edge, edge.by_length + edge.by_weight * edge.weight_slope, edge.by_direction);
      Eigen::Map<Vec3>(forces + 3 * std::size_t{edge.to}) -= pull;
      sum += pull;
    }
    Eigen::Map<Vec3>(forces + 3 * std::size_t{centre.atom}) += sum;
  }
}

}  // namespace nanocarbon::rebo2
