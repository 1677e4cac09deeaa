// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/molecule/hydrogens.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "nanocarbon/molecule/molecule_graph.h"

namespace nanocarbon::molecule {
namespace {

constexpr double straight = 0.1;  // sine of six degrees: below it two directions span no plane

// The normal of the plane in which an atom with one bond continues its neighbour, and any one where that has
// no plane.
Vec3 normal_beyond(const topology::EmbeddedGraph& graph, AtomIndex atom, AtomIndex neighbour,
                   const Vec3& along) {
  Vec3 best = along.unitOrthogonal();
  double largest = straight;
  for (std::uint32_t h = graph.offsets[neighbour]; h < graph.offsets[neighbour + 1]; ++h) {
    if (graph.ends[h] == atom) continue;
    const Vec3 normal = along.cross(graph.vectors[h].normalized());
    if (normal.norm() > largest) {
      largest = normal.norm();
      best = normal.normalized();
    }
  }
  return best;
}

// Unit vectors of the bonds that are missing.
std::vector<Vec3> missing_directions(const topology::EmbeddedGraph& graph, AtomIndex atom) {
  const std::uint32_t row = graph.offsets[atom];
  const double sine = std::sqrt(0.75);
  if (graph.degree(atom) == 0) return {Vec3(1, 0, 0), Vec3(-0.5, sine, 0), Vec3(-0.5, -sine, 0)};
  const Vec3 first = graph.vectors[row].normalized();
  if (graph.degree(atom) == 1) {
    const Vec3 across = normal_beyond(graph, atom, graph.ends[row], first).cross(first);
    return {-0.5 * first + sine * across, -0.5 * first - sine * across};
  }
  const Vec3 sum = first + graph.vectors[row + 1].normalized();
  return {sum.norm() > straight ? Vec3(-sum.normalized()) : Vec3(first.unitOrthogonal())};
}

}  // namespace

Molecule saturated_with_hydrogen(const Molecule& molecule, const HydrogenOptions& options) {
  const topology::EmbeddedGraph graph = embedded_graph(molecule);
  Molecule result = molecule;
  for (AtomIndex a = 0; a < molecule.size(); ++a) {
    if (molecule.elements[a] != Element::carbon || graph.degree(a) >= 3) continue;
    for (const Vec3& direction : missing_directions(graph, a)) {
      result.bonds.push_back({a, static_cast<AtomIndex>(result.size()), {0, 0, 0}});
      result.positions.push_back(molecule.positions[a] + options.bond_length * direction);
      result.elements.push_back(Element::hydrogen);
    }
  }
  std::sort(result.bonds.begin(), result.bonds.end());
  return result;
}

std::size_t hydrogen_count(const Molecule& molecule) {
  return static_cast<std::size_t>(
      std::count(molecule.elements.begin(), molecule.elements.end(), Element::hydrogen));
}

Molecule carbon_skeleton(const Molecule& molecule) {
  Molecule result = molecule;
  const std::size_t carbons = molecule.size() - hydrogen_count(molecule);
  result.positions.resize(carbons);
  result.elements.resize(carbons);
  std::erase_if(result.bonds, [&](const Bond& bond) { return std::max(bond.first, bond.second) >= carbons; });
  return result;
}

}  // namespace nanocarbon::molecule
