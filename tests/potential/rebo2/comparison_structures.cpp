// SPDX-License-Identifier: GPL-2.0-or-later
#include "potential/rebo2/comparison_structures.h"

#include <cmath>
#include <random>

#include "nanocarbon/core/neighbours_within.h"
#include "nanocarbon/potential/rebo2/parameters.h"
#include "nanocarbon/structures/diamond.h"
#include "nanocarbon/structures/fullerene.h"
#include "nanocarbon/structures/graphene.h"
#include "nanocarbon/structures/hydrocarbons.h"
#include "nanocarbon/structures/schwarzite.h"
#include "nanocarbon/structures/tube.h"

namespace nanocarbon::test {

namespace {

double uniform(std::mt19937_64& random, double low, double high) {
  return low + (high - low) * (static_cast<double>(random() >> 11) * 0x1.0p-53);
}

void round_coordinates(Molecule& molecule) {
  for (Vec3& p : molecule.positions) p = (p * 1e4).array().round().matrix() / 1e4;
}

}  // namespace

void rattle(Molecule& molecule, double distance, unsigned seed) {
  std::mt19937_64 random(seed);
  for (Vec3& p : molecule.positions)
    for (double& x : p) x += uniform(random, -distance, distance);
}

Molecule random_cluster(unsigned seed) {
  std::mt19937_64 random(seed);
  Molecule cluster;
  const std::size_t atoms = 4 + random() % 7;
  const double radius = 1.1 * std::cbrt(static_cast<double>(atoms));
  while (cluster.size() < atoms) {
    const Vec3 p(uniform(random, -radius, radius), uniform(random, -radius, radius),
                 uniform(random, -radius, radius));
    if (p.norm() > radius) continue;
    bool too_close = false;
    for (const Vec3& q : cluster.positions) too_close |= (p - q).norm() < 0.9;
    if (too_close) continue;
    cluster.positions.push_back(p);
    cluster.elements.push_back(random() % 10 < 6 ? Element::carbon : Element::hydrogen);
  }
  return cluster;
}

std::vector<ComparisonStructure> comparison_structures() {
  std::vector<ComparisonStructure> structures;
  const auto add = [&](const std::string& name, Molecule molecule) {
    for (const double distance : {0.0, 0.05, 0.15}) {
      Molecule moved = molecule;
      rattle(moved, distance, static_cast<unsigned>(structures.size()));
      round_coordinates(moved);
      const char* suffix = distance == 0.0    ? ""
                           : distance == 0.05 ? ", rattled by 0.05"
                                              : ", rattled by 0.15";
      structures.push_back({name + suffix, std::move(moved)});
    }
  };
  add("graphene", structures::graphene(3, 2));
  add("diamond", structures::diamond(2, 2, 1));
  add("C60", structures::fullerene(1, 1));
  add("tube (5,5)", structures::periodic_tube(5, 5, 2));
  add("tube (7,2)", structures::periodic_tube(7, 2, 1));
  add("tube (4,0), open", structures::open_tube(4, 0, 9.0));
  add("schwarzite D688", structures::schwarzite_d688(1, 1, 1));
  add("schwarzite P688", structures::schwarzite_p688(1, 1, 1));
  add("flake", structures::graphene_flake(5.0));
  add("methane", structures::methane());
  add("methyl", structures::methyl_radical());
  add("acetylene", structures::acetylene());
  add("ethynyl", structures::ethynyl_radical());
  add("ethylene", structures::ethylene());
  add("ethane", structures::ethane());
  add("cyclopropane", structures::cyclopropane());
  add("benzene", structures::benzene());
  for (unsigned seed = 1; seed <= 200; ++seed) {
    Molecule cluster = random_cluster(seed);
    round_coordinates(cluster);
    structures.push_back({"cluster " + std::to_string(seed), std::move(cluster)});
  }
  return structures;
}

double force_tolerance(const Molecule& molecule) {
  const Cell* cell = molecule.cell ? &*molecule.cell : nullptr;
  const NeighbourList near = neighbours_within(molecule.positions, cell, 2.0);
  for (std::size_t i = 0; i < molecule.size(); ++i)
    for (const Neighbour& n : near.of(i)) {
      Vec3 delta = molecule.positions[n.atom] - molecule.positions[i];
      if (cell) delta += image_shift(*cell, n.image);
      const rebo2::PairParameters& pair =
          rebo2::rebo2_parameters().pairs[rebo2::pair_index(molecule.elements[i], molecule.elements[n.atom])];
      if (delta.norm() > pair.cutoff_begin && delta.norm() < pair.cutoff_end) return 1e-8;
    }
  return 1e-9;
}

}  // namespace nanocarbon::test
