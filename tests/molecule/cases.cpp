// SPDX-License-Identifier: GPL-2.0-or-later
#include "molecule/cases.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <random>
#include <set>

#include "molecule/shapes.h"
#include "nanocarbon/molecule/dual.h"
#include "nanocarbon/molecule/molecule_graph.h"
#include "nanocarbon/topology/bond_graph.h"

namespace nanocarbon::test {
namespace {

constexpr double pi = std::numbers::pi;

// A closed grid of quads cut in two; `glued` gives the vertex at any (i, j).
template <typename Glued>
std::vector<Triangle> grid_triangles(int columns, int rows, const Glued& glued) {
  std::vector<Triangle> triangles;
  for (int i = 0; i < columns; ++i)
    for (int j = 0; j < rows; ++j) {
      triangles.push_back({glued(i, j), glued(i + 1, j), glued(i, j + 1)});
      triangles.push_back({glued(i + 1, j), glued(i + 1, j + 1), glued(i, j + 1)});
    }
  return triangles;
}

// The surface of a body of unit cubes, its quads cut in two and its vertices averaged with their neighbours.
TriangleMesh surface_of_cubes(const std::set<std::array<int, 3>>& cubes) {
  std::map<std::array<int, 3>, VertexIndex> vertices;
  TriangleMesh mesh;
  const auto vertex = [&](const std::array<int, 3>& at) {
    const auto [found, is_new] = vertices.emplace(at, static_cast<VertexIndex>(mesh.points.size()));
    if (is_new) mesh.points.emplace_back(at[0], at[1], at[2]);
    return found->second;
  };
  const auto filled = [&](const std::array<int, 3>& c) { return cubes.count(c) > 0; };
  for (const auto& cube : cubes)
    for (std::size_t d = 0; d < 3; ++d)
      for (const int side : {0, 1}) {
        std::array<int, 3> next = cube;
        next[d] += side ? 1 : -1;
        if (filled(next)) continue;
        std::array<std::array<int, 3>, 4> corners;
        const std::size_t u = (d + 1) % 3, v = (d + 2) % 3;
        for (std::size_t k = 0; k < 4; ++k) {
          corners[k] = cube;
          corners[k][d] += side;
          corners[k][u] += k == 1 || k == 2;
          corners[k][v] += k >= 2;
        }
        if (!side) std::reverse(corners.begin(), corners.end());
        const VertexIndex a = vertex(corners[0]), b = vertex(corners[1]), c = vertex(corners[2]),
                          e = vertex(corners[3]);
        mesh.triangles.push_back({a, b, c});
        mesh.triangles.push_back({a, c, e});
      }
  for (int round = 0; round < 3; ++round) {
    std::vector<Vec3> sum(mesh.points.size(), Vec3::Zero());
    std::vector<int> count(mesh.points.size(), 0);
    for (const Triangle& t : mesh.triangles)
      for (int k = 0; k < 3; ++k) {
        sum[t[k]] += mesh.points[t[(k + 1) % 3]] + mesh.points[t[(k + 2) % 3]];
        count[t[k]] += 2;
      }
    for (std::size_t i = 0; i < sum.size(); ++i)
      mesh.points[i] = 0.5 * mesh.points[i] + 0.5 * sum[i] / count[i];
  }
  return mesh;
}

}  // namespace

Molecule with_bonds_by_distance(Molecule molecule) {
  molecule.bonds.clear();
  return with_updated_bonds(std::move(molecule));
}

Molecule with_updated_bonds(Molecule molecule) {
  const Cell* cell = molecule.cell ? &*molecule.cell : nullptr;
  molecule.bonds = topology::bonds_within(molecule.positions, molecule.elements, cell, {}, molecule.bonds);
  molecule.rings = {};
  return molecule;
}

Molecule rattled(Molecule molecule, double deviation, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> move(0.0, deviation);
  for (Vec3& p : molecule.positions) p += Vec3(move(random), move(random), move(random));
  return molecule;
}

Molecule turned_and_shuffled(const Molecule& molecule, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<AtomIndex> place(molecule.size());
  std::iota(place.begin(), place.end(), 0u);
  std::shuffle(place.begin(), place.end(), random);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const Vec3 axis(uniform(random), uniform(random), uniform(random));
  const Mat3 turn = Eigen::AngleAxisd(3.0 * uniform(random), axis.normalized()).toRotationMatrix();
  Molecule result = molecule;
  result.rings = {};
  if (result.cell) {
    result.cell->vectors = turn * result.cell->vectors;
    result.cell->origin = turn * result.cell->origin;
  }
  for (std::size_t i = 0; i < molecule.size(); ++i) {
    result.positions[place[i]] = turn * molecule.positions[i];
    result.elements[place[i]] = molecule.elements[i];
  }
  for (Bond& bond : result.bonds) {
    bond.first = place[bond.first];
    bond.second = place[bond.second];
    if (bond.first > bond.second) {
      std::swap(bond.first, bond.second);
      for (auto& c : bond.image) c = -c;
    }
  }
  std::sort(result.bonds.begin(), result.bonds.end());
  return result;
}

Molecule together(Molecule first, const Molecule& second) {
  const auto shift = static_cast<AtomIndex>(first.size());
  first.positions.insert(first.positions.end(), second.positions.begin(), second.positions.end());
  first.elements.insert(first.elements.end(), second.elements.begin(), second.elements.end());
  for (const Bond& bond : second.bonds)
    first.bonds.push_back({bond.first + shift, bond.second + shift, bond.image});
  first.rings = {};
  return first;
}

Molecule without_atom(const Molecule& molecule, AtomIndex atom) {
  Molecule result = molecule;
  result.rings = {};
  result.positions.erase(result.positions.begin() + atom);
  result.elements.erase(result.elements.begin() + atom);
  result.bonds.clear();
  for (Bond bond : molecule.bonds) {
    if (bond.first == atom || bond.second == atom) continue;
    if (bond.first > atom) --bond.first;
    if (bond.second > atom) --bond.second;
    result.bonds.push_back(bond);
  }
  return result;
}

Molecule stone_wales(const Molecule& molecule, AtomIndex first, AtomIndex second) {
  Molecule result = molecule;
  const Vec3 middle = 0.5 * (molecule.positions[first] + molecule.positions[second]);
  Vec3 normal = Vec3::Zero();
  const topology::EmbeddedGraph graph = molecule::embedded_graph(molecule);
  for (const AtomIndex atom : {first, second}) {
    const std::uint32_t row = graph.offsets[atom];
    const Vec3 n =
        (graph.vectors[row + 1] - graph.vectors[row]).cross(graph.vectors[row + 2] - graph.vectors[row]);
    normal += n.dot(normal) < 0.0 ? Vec3(-n) : n;
  }
  const Mat3 turn = Eigen::AngleAxisd(pi / 2.0, normal.normalized()).toRotationMatrix();
  for (const AtomIndex atom : {first, second})
    result.positions[atom] = middle + turn * (molecule.positions[atom] - middle);
  return with_updated_bonds(std::move(result));
}

Molecule twisted_band(int half_twists) {
  // Staggered rows, an even number of them, look the same from both edges, so that the strip's ends fit after
  // a half twist.
  const int columns = 60, rows = 4;
  const double radius = columns / (2.0 * pi), height = std::sqrt(3.0) / 2.0;
  TriangleMesh mesh;
  for (int i = 0; i < columns; ++i)
    for (int j = 0; j <= rows; ++j) {
      const double along = 2.0 * pi * (i + 0.5 * (j % 2)) / columns, twist = 0.5 * half_twists * along;
      const double across = height * (j - 0.5 * rows);
      const double r = radius + across * std::cos(twist);
      mesh.points.emplace_back(r * std::cos(along), r * std::sin(along), across * std::sin(twist));
    }
  const auto vertex = [&](int i, int j) {
    const bool swapped = half_twists % 2 != 0 && i >= columns;
    return static_cast<VertexIndex>((rows + 1) * (i % columns) + (swapped ? rows - j : j));
  };
  for (int i = 0; i < columns; ++i)
    for (int j = 0; j < rows; ++j) {
      const int far = j % 2;  // the row with the points half a step ahead is j where this is 1, else j + 1
      mesh.triangles.push_back({vertex(i, j), vertex(i + 1, j), vertex(i + far, j + 1)});
      mesh.triangles.push_back({vertex(i + 1 - far, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
    }
  return molecule::dual(scaled_to_carbon(mesh));
}

Molecule klein_bottle() {
  const int columns = 80, rows = 30;
  TriangleMesh mesh;
  for (int i = 0; i < columns; ++i)
    for (int j = 0; j < rows; ++j) {
      const double u = 2.0 * pi * i / columns, v = 2.0 * pi * j / rows;
      const double out = std::cos(u / 2.0) * std::sin(v) - std::sin(u / 2.0) * std::sin(2.0 * v);
      const double up = std::sin(u / 2.0) * std::sin(v) + std::cos(u / 2.0) * std::sin(2.0 * v);
      mesh.points.emplace_back((3.0 + out) * std::cos(u), (3.0 + out) * std::sin(u), up);
    }
  mesh.triangles = grid_triangles(columns, rows, [&](int i, int j) {
    const int row = i >= columns ? 2 * rows - j : j;  // a turn around takes v to -v
    return static_cast<VertexIndex>(rows * (i % columns) + row % rows);
  });
  return molecule::dual(scaled_to_carbon(mesh));
}

Molecule handles(int genus) {
  std::set<std::array<int, 3>> cubes;
  const int length = 8 * genus + 4;
  for (int x = 0; x < length; ++x)
    for (int y = 0; y < 12; ++y)
      for (int z = 0; z < 4; ++z) {
        const bool hole = x % 8 >= 4 && x % 8 < 8 && y >= 4 && y < 8;
        if (!hole) cubes.insert({x, y, z});
      }
  return molecule::dual(scaled_to_carbon(surface_of_cubes(cubes)));
}

topology::SurfaceTopology topology(const Molecule& molecule, int max_ring) {
  topology::TopologyOptions options;
  options.max_ring = max_ring;
  return topology::surface_topology(molecule::embedded_graph(molecule), options);
}

}  // namespace nanocarbon::test
