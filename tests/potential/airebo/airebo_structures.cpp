// SPDX-License-Identifier: GPL-2.0-or-later
#include "potential/airebo/airebo_structures.h"

#include <random>

#include "nanocarbon/structures/fullerene.h"
#include "potential/airebo/reference.h"

namespace nanocarbon::test {

namespace {

void round_coordinates(Molecule& molecule) {
  for (Vec3& p : molecule.positions) p = (p * 1e4).array().round().matrix() / 1e4;
}

//! Four molecules in a cubic cell.
Molecule fullerene_crystal() {
  const Molecule ball = structures::fullerene(1, 1);
  Molecule crystal;
  constexpr double edge = 14.1;
  crystal.cell = orthogonal_cell(Vec3::Constant(edge));
  for (const Vec3& at : {Vec3(0.0, 0.0, 0.0), Vec3(0.0, 0.5, 0.5), Vec3(0.5, 0.0, 0.5), Vec3(0.5, 0.5, 0.0)})
    for (std::size_t i = 0; i < ball.size(); ++i) {
      crystal.positions.push_back(ball.positions[i] + edge * at);
      crystal.elements.push_back(Element::carbon);
    }
  return crystal;
}

double smallest_distance(const Molecule& m, const Vec3& p) {
  double smallest = 1e9;
  for (const Vec3& q : m.positions) {
    Vec3 d = p - q;
    for (int k = 0; k < 3; ++k) {
      const double edge = m.cell->vectors(k, k);
      d[k] -= edge * std::round(d[k] / edge);
    }
    smallest = std::min(smallest, d.norm());
  }
  return smallest;
}

}  // namespace

Molecule random_crystal(unsigned seed, std::size_t atoms, double edge) {
  std::mt19937_64 random(seed);
  const auto uniform = [&] { return static_cast<double>(random() >> 11) * 0x1.0p-53; };
  Molecule crystal;
  crystal.cell = orthogonal_cell(Vec3::Constant(edge));
  while (crystal.size() < atoms) {
    const double x = uniform(), y = uniform(), z = uniform();
    const Vec3 p = edge * Vec3(x, y, z);
    if (smallest_distance(crystal, p) < 0.95) continue;
    crystal.positions.push_back(p);
    crystal.elements.push_back(random() % 2 == 0 ? Element::carbon : Element::hydrogen);
  }
  return crystal;
}

std::vector<ComparisonStructure> airebo_structures() {
  std::vector<ComparisonStructure> structures;
  const auto add = [&](const std::string& name, const Molecule& molecule) {
    for (const double distance : {0.0, 0.05, 0.15}) {
      Molecule moved = molecule;
      rattle(moved, distance, static_cast<unsigned>(structures.size()) + 1000);
      round_coordinates(moved);
      structures.push_back({name + ", rattled by " + std::to_string(distance), std::move(moved)});
    }
  };
  for (const AireboReferenceStructure& s : airebo_reference())
    for (const char* name :
         {"graphite", "bundle_10_10", "c60_at_c240", "polyethylene", "benzene_dimer", "c60_pair_9", "soup"})
      if (s.name == name) add(s.name, s.molecule);
  add("C60 crystal", fullerene_crystal());
  for (unsigned seed = 1; seed <= 6; ++seed) {
    Molecule crystal = random_crystal(seed, 60, seed <= 3 ? 8.0 : 10.0);
    round_coordinates(crystal);
    structures.push_back({"crystal " + std::to_string(seed), std::move(crystal)});
  }
  for (ComparisonStructure& s : comparison_structures()) structures.push_back(std::move(s));
  return structures;
}

double airebo_force_tolerance(const Molecule& molecule) { return 10.0 * force_tolerance(molecule); }

}  // namespace nanocarbon::test
