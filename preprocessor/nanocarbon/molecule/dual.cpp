// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/molecule/dual.h"

#include <fmt/format.h>

#include <algorithm>

#include "nanocarbon/core/error.h"
#include "nanocarbon/mesh/edge_table.h"

namespace nanocarbon::molecule {
namespace {

constexpr std::uint32_t none = 0xffffffffu;

// For corner k of triangle t, across[3 t + k] is the triangle on the other side of the edge that starts at
// corner k.
using Across = std::vector<std::uint32_t>;

void check_triangles(const TriangleMesh& mesh) {
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    const bool inside = std::max({a, b, c}) < mesh.points.size();
    if (!inside || a == b || b == c || c == a)
      throw UserError(
          Failure::unsuitable,
          fmt::format("triangle {} ({}, {}, {}) does not have three different vertices of the mesh's {}", t,
                      a, b, c, mesh.points.size()));
  }
}

Across pair_edges(const TriangleMesh& triangulation) {
  const mesh::EdgeTable edges = mesh::edge_table(mesh::soup_of(triangulation));
  Across across(3 * triangulation.triangles.size(), none);
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto uses = edges.uses_of(e);
    if (uses.size() > 2)
      throw UserError(
          Failure::unsuitable,
          fmt::format("the edge between vertices {} and {} has {} triangles; a 2-manifold has at most two",
                      edges.low[e], edges.high[e], uses.size()));
    if (uses.size() < 2) continue;
    across[uses[0].corner] = uses[1].face;
    across[uses[1].corner] = uses[0].face;
  }
  return across;
}

std::size_t corner_of(const Triangle& triangle, VertexIndex vertex) {
  return triangle[0] == vertex ? 0 : triangle[1] == vertex ? 1 : 2;
}

void append_ring(const TriangleMesh& mesh, const Across& across, VertexIndex vertex, std::uint32_t first,
                 std::size_t valence, Rings& rings) {
  // Leaving each triangle by the edge that was not entered needs no orientation beyond the first triangle's.
  const std::size_t begin = rings.atoms.size();
  std::uint32_t triangle = first, previous = none;
  do {
    rings.atoms.push_back(triangle);
    const std::size_t k = corner_of(mesh.triangles[triangle], vertex);
    const std::uint32_t before = across[3 * triangle + k], after = across[3 * triangle + (k + 2) % 3];
    const std::uint32_t next = previous == none || after != previous ? after : before;
    previous = triangle;
    triangle = next;
    if (triangle == none) {
      rings.atoms.resize(begin);  // on the boundary
      return;
    }
  } while (triangle != first);
  if (rings.atoms.size() - begin != valence)
    throw UserError(
        Failure::unsuitable,
        fmt::format(
            "the triangles at vertex {} form more than one fan, so the mesh is not a 2-manifold there",
            vertex));
  rings.offsets.push_back(static_cast<std::uint32_t>(rings.atoms.size()));
}

void append_rings(const TriangleMesh& mesh, const Across& across, Rings& rings) {
  std::vector<std::uint32_t> valence(mesh.points.size(), 0), lowest(mesh.points.size(), none);
  std::vector<bool> open(mesh.points.size(), false);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const VertexIndex v = mesh.triangles[t][k];
      ++valence[v];
      lowest[v] = std::min(lowest[v], t);
      if (across[3 * t + k] == none) open[v] = open[mesh.triangles[t][(k + 1) % 3]] = true;
    }
  for (VertexIndex v = 0; v < mesh.points.size(); ++v)
    if (valence[v] > 0 && !open[v]) append_ring(mesh, across, v, lowest[v], valence[v], rings);
}

}  // namespace

Molecule dual(const TriangleMesh& triangulation) {
  check_triangles(triangulation);
  const Across across = pair_edges(triangulation);
  Molecule molecule;
  const std::size_t atoms = triangulation.triangles.size();
  molecule.elements.assign(atoms, Element::carbon);
  molecule.positions.reserve(atoms);
  const Space& space = triangulation.space;
  if (space.periodic()) molecule.cell = *space.cell();
  for (const Triangle& triangle : triangulation.triangles) {
    const auto [a, b, c] = corners_of(triangulation, triangle);
    molecule.positions.emplace_back((a + b + c) / 3.0);
  }

  molecule.bonds.reserve(3 * atoms / 2);
  for (AtomIndex t = 0; t < atoms; ++t) {
    std::array<std::uint32_t, 3> others = {across[3 * t], across[3 * t + 1], across[3 * t + 2]};
    std::sort(others.begin(), others.end());
    for (std::size_t k = 0; k < 3; ++k)
      if (others[k] != none && others[k] > t)
        molecule.bonds.push_back(
            {t, others[k], space.image(molecule.positions[t], molecule.positions[others[k]])});
  }
  if (std::adjacent_find(molecule.bonds.begin(), molecule.bonds.end()) != molecule.bonds.end()) {
    const Bond twice = *std::adjacent_find(molecule.bonds.begin(), molecule.bonds.end());
    throw UserError(
        Failure::unsuitable,
        fmt::format(
            "triangles {} and {} share two edges, so their atoms would have two bonds with each other",
            twice.first, twice.second));
  }
  append_rings(triangulation, across, molecule.rings);
  return molecule;
}

}  // namespace nanocarbon::molecule
