// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cmath>
#include <numbers>

#include "nanocarbon/annealing/network_edit.h"
#include "nanocarbon/core/random_stream.h"
#include "nanocarbon/structures/fullerene.h"

namespace nanocarbon::test {

//! The unit sphere as an icosahedral triangulation with 20 n^2 faces.
inline TriangleMesh unit_sphere(int n) {
  TriangleMesh mesh = structures::icosahedral_triangulation(n, 0);
  for (Vec3& p : mesh.points) p.normalize();
  return mesh;
}

//! Scale at which a surface of the given area (mesh units) carries as many atoms as graphene would: 2.6195
//! square Angstrom for each.
inline double scale_for(std::size_t atoms, double area) {
  return std::sqrt(2.6195 * static_cast<double>(atoms) / area);
}

//! The unit sphere badly triangulated with 20 n^2 faces: random flips have left vertices of valence 4 to 8
//! everywhere, and vertices sit at the centroids of what surrounds them.
inline TriangleMesh rough_sphere(int n, std::uint64_t seed, double flips_per_face, double jitter = 0) {
  annealing::TrivalentNetwork network = annealing::trivalent_network(unit_sphere(n));
  std::vector<AtomIndex> no_atoms;
  std::vector<annealing::RingIndex> no_rings;
  RandomStream random(seed, 0);
  const std::size_t atoms = network.atoms.size();
  for (std::size_t flip = 0; static_cast<double>(flip) < flips_per_face * static_cast<double>(atoms);
       ++flip) {
    const auto edit = annealing::flip_bond(network, static_cast<AtomIndex>(random.below(atoms)),
                                           static_cast<unsigned>(random.below(3)));
    if (!edit) continue;
    bool fits = true;
    for (const auto& [ring, change] : edit->rings) {
      const int size = static_cast<int>(network.rings[ring].size) + change;
      fits &= size >= 5 && size <= 7;
    }
    if (fits) annealing::commit_edit(network, *edit, no_atoms, no_rings);
  }
  TriangleMesh mesh = unit_sphere(n);
  for (std::size_t a = 0; a < atoms; ++a)
    mesh.triangles[a] = {network.atoms[a].ring[0], network.atoms[a].ring[1], network.atoms[a].ring[2]};
  for (int round = 0; round < 200; ++round) {
    std::vector<Vec3> sums(mesh.points.size(), Vec3::Zero());
    for (const Triangle& t : mesh.triangles)
      for (int s = 0; s < 3; ++s) sums[t[s]] += mesh.points[t[(s + 1) % 3]] + mesh.points[t[(s + 2) % 3]];
    for (std::size_t v = 0; v < sums.size(); ++v)
      mesh.points[v] = (mesh.points[v] + sums[v].normalized()).normalized();
  }
  const double edge = std::sqrt(4 * std::numbers::pi / static_cast<double>(atoms) * 4 / std::sqrt(3.0));
  for (Vec3& p : mesh.points) {
    for (int d = 0; d < 3; ++d) p[d] += jitter * edge * (2 * random.uniform() - 1);
    p.normalize();
  }
  return mesh;
}

}  // namespace nanocarbon::test
