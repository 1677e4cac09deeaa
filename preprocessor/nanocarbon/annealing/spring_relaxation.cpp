// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/annealing/spring_relaxation.h"

#include <algorithm>
#include <iterator>

#include "nanocarbon/annealing/network_springs.h"
#include "nanocarbon/topology/bond_shells.h"

namespace nanocarbon::annealing {

namespace {

// Holds the shape while springs pull on badly scaled bonds.
constexpr double spring_tether = 0.5;
constexpr double force_tolerance = 0.05;  // eV/Angstrom
constexpr int rounds = 3;                 // planes are renewed in each

// Bonds beyond the atoms given up to which others move as well.
constexpr unsigned moved_beyond = 6;

// Part of a bond graph: first what moves, then two shells of held atoms, so that every spring of what moves is there.
struct Part {
  std::vector<AtomIndex> atoms;  // in the whole
  std::size_t moving = 0;
  FixedBondGraph graph;
};

Part part_around(const FixedBondGraph& whole, std::span<const AtomIndex> atoms) {
  Part part;
  std::vector<bool> inside(whole.neighbours.size(), false);
  const topology::FirstTime first(inside);
  std::copy_if(atoms.begin(), atoms.end(), std::back_inserter(part.atoms), first);
  std::size_t shell = 0;
  for (unsigned k = 0; k < moved_beyond; ++k) topology::add_bond_shell(whole, part.atoms, shell, first);
  part.moving = part.atoms.size();
  topology::add_bond_shell(whole, part.atoms, shell, first);
  const std::size_t inner = part.atoms.size();
  topology::add_bond_shell(whole, part.atoms, shell, first);
  std::vector<AtomIndex> number(whole.neighbours.size(), no_atom);
  part.graph = part_of(whole, part.atoms, inner, number);
  return part;
}

}  // namespace

void relax_by_springs(FixedBondModel& model, const TetherSurface& surface, std::vector<Vec3>& positions,
                      int iterations) {
  const auto stage = model.running.stage("springs");
  ThreadTeam* const team = model.running.team;
  for (int round = 0; round < rounds; ++round) {
    model.planes = tangent_planes(surface, positions, model.planes, team);
    const auto energy = [&](std::span<const Vec3> x, std::span<Vec3> g) {
      const FixedBondGraph& graph = model.rebo2.graph();
      return add_springs(graph, model.rebo2.chunks(), x, g, team) +
             model.contacts.evaluate(x, graph, g, team) +
             add_tether(model.planes, spring_tether, x, g, model.free_mean, team);
    };
    minimisation::minimise_lbfgs(
        positions, energy,
        {.max_iterations = iterations / rounds, .force_tolerance = force_tolerance, .team = team});
  }
}

void relax_by_springs_around(FixedBondModel& model, const TetherSurface& surface,
                             std::vector<Vec3>& positions, std::span<const AtomIndex> atoms, int iterations) {
  const auto stage = model.running.stage("springs");
  const Part part = part_around(model.rebo2.graph(), atoms);
  const double mean = model.free_mean ? mean_height(model.planes, positions, model.running.team) : 0;
  std::vector<Vec3> moved;
  std::vector<TangentPlane> planes;
  for (const AtomIndex a : part.atoms) {
    moved.push_back(positions[a]);
    planes.push_back(model.planes[a]);
  }
  StericContacts contacts;
  for (int round = 0; round < rounds; ++round) {
    planes = tangent_planes(surface, moved, planes);
    std::vector<TangentPlane> raised = planes;
    for (TangentPlane& plane : raised) plane.point += mean * plane.normal;
    const auto energy = [&](std::span<const Vec3> x, std::span<Vec3> g) {
      const double sum = add_springs(part.graph, x, g) + contacts.evaluate(x, part.graph, g) +
                         add_tether(raised, spring_tether, x, g, false);
      for (std::size_t k = part.moving; k < g.size(); ++k) g[k].setZero();
      return sum;
    };
    minimisation::minimise_lbfgs(moved, energy,
                                 {.max_iterations = iterations / rounds, .force_tolerance = force_tolerance});
  }
  for (std::size_t k = 0; k < part.moving; ++k) positions[part.atoms[k]] = moved[k];
}

}  // namespace nanocarbon::annealing
