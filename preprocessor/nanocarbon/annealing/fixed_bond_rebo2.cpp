// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/annealing/fixed_bond_rebo2.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "nanocarbon/potential/rebo2/angular_spline.h"
#include "nanocarbon/potential/rebo2/coordination_tables.h"
#include "nanocarbon/potential/rebo2/pair_terms.h"
#include "nanocarbon/potential/rebo2/sp2_constants.h"

namespace nanocarbon::annealing {

namespace {

// T_CC(2, 2, k), k = 2..9: of bonds between three-coordinated carbons.
double torsion_constant() {
  static const double constant = rebo2::sp2_bond_constants(rebo2::rebo2_tables()).torsion;
  return constant;
}

// Directions perpendicular to a bond of the two other bonds at one of its ends (dihedral term).
struct Fan {
  Vec3 u[2];
  double sine[2];
  double along[2];
};

// Below this sine of the angle at the bond a dihedral angle has no direction; keeps forces finite.
constexpr double least_sine = 1e-3;

// In place of the half-edge back: the bond's other half is counted elsewhere, or not at all.
constexpr std::uint32_t no_half = static_cast<std::uint32_t>(-1);

}  // namespace

void FixedBondRebo2::set_graph(const FixedBondGraph& graph) {
  graph_ = graph;
  loops_.set_graph(graph_);
  incomplete_.clear();
  for (AtomIndex a = 0; a < graph_.inner_count(); ++a)
    if (!graph_.complete(a)) incomplete_.push_back(a);
}

void FixedBondRebo2::set_edges(std::size_t atom, std::span<const Vec3> positions) {
  for (unsigned s = 0; s < 3; ++s) {
    const AtomIndex n = graph_.neighbours[atom][s];
    if (n == no_atom) {
      edges_[3 * atom + s] = {0, 0, 0, 0};
      continue;
    }
    const Vec3 d = graph_.space.displacement(positions[atom], positions[n]);
    const double r = d.norm();
    edges_[3 * atom + s] = {d.x() / r, d.y() / r, d.z() / r, r};
  }
  set_angles(atom);
}

void FixedBondRebo2::set_angles(std::size_t atom) {
  const HalfEdge* e = &edges_[3 * atom];
  Angle* angle = &angles_[3 * atom];
  const auto& neighbours = graph_.neighbours[atom];
  for (unsigned s = 0; s < 3; ++s) {
    const unsigned a = (s + 1) % 3, b = (s + 2) % 3;
    if (neighbours[a] == no_atom || neighbours[b] == no_atom) {
      angle[s] = {0, 0, 0, 0};
      continue;
    }
    const double cosine = e[a].x * e[b].x + e[a].y * e[b].y + e[a].z * e[b].z;
    const rebo2::ValueSlope g = rebo2::angular_carbon_few(rebo2::rebo2_parameters().carbon, cosine);
    angle[s] = {cosine, g.value, g.slope, 0};
  }
}

double FixedBondRebo2::add_bond(std::uint32_t h, std::uint32_t reverse) {
  const HalfEdge& edge = edges_[h];
  const double r = edge.length;
  const rebo2::PairParameters& pair =
      rebo2::rebo2_parameters().pairs[rebo2::pair_index(Element::carbon, Element::carbon)];
  const rebo2::ValueSlope repulsion = rebo2::pair_repulsion(pair, r),
                          attraction = rebo2::pair_attraction(pair, r);

  const Vec3 axis(edge.x, edge.y, edge.z);
  double order = 0;
  Fan fan[2];
  const int ends = reverse == no_half ? 1 : 2;
  const double share = 0.5 * ends;
  bool dihedral = ends == 2;
  for (int end = 0; end < ends; ++end) {
    const std::uint32_t half = end == 0 ? h : reverse, atom = half / 3, slot = half % 3;
    Angle* angle = &angles_[3 * atom];
    const unsigned k[2] = {(slot + 1) % 3, (slot + 2) % 3};
    const double zeta = 1 + angle[k[0]].g + angle[k[1]].g;
    const double p = 1 / std::sqrt(zeta);
    order += 0.5 * p;
    const double weight = attraction.value * 0.5 * -0.5 * p / zeta;
    angle[k[0]].weight += weight;
    angle[k[1]].weight += weight;
    for (int n = 0; n < 2; ++n) {
      dihedral &= graph_.neighbours[atom][k[n]] != no_atom;
      const HalfEdge& other = edges_[3 * atom + k[n]];
      const Vec3 e(other.x, other.y, other.z);
      // The angle between slots `slot` and k[n] is the one opposite to the third slot.
      fan[end].along[n] = e.dot(axis);
      const Vec3 across = e - fan[end].along[n] * axis;
      fan[end].sine[n] = std::max(across.norm(), least_sine);
      fan[end].u[n] = across / fan[end].sine[n];
    }
  }
  HalfEdge& own = edge_gradient_[h];
  if (dihedral) {
    double sum = 4;
    Vec3 on_axis = Vec3::Zero();
    const double scale = torsion_constant() * attraction.value;
    for (int end = 0; end < 2; ++end) {
      const std::uint32_t half = end == 0 ? h : reverse, atom = half / 3, slot = half % 3;
      const Fan& here = fan[end];
      const Fan& there = fan[1 - end];
      for (int n = 0; n < 2; ++n) {
        const double c0 = here.u[n].dot(there.u[0]), c1 = here.u[n].dot(there.u[1]);
        if (end == 0) sum -= c0 * c0 + c1 * c1;
        const Vec3 by_u = -2 * scale * (c0 * there.u[0] + c1 * there.u[1]);
        const Vec3 by_e = (by_u - by_u.dot(here.u[n]) * here.u[n]) / here.sine[n];
        HalfEdge& target = edge_gradient_[3 * atom + (slot + 1 + n) % 3];
        target.x += by_e.x();
        target.y += by_e.y();
        target.z += by_e.z();
        on_axis -= here.along[n] * by_e;
      }
    }
    own.x += on_axis.x();
    own.y += on_axis.y();
    own.z += on_axis.z();
    order += torsion_constant() * sum;
  }
  own.length = share * repulsion.slope + order * attraction.slope;
  return share * repulsion.value + order * attraction.value;
}

double FixedBondRebo2::evaluate_each_bond(std::span<const Vec3> positions, std::span<Vec3> gradient) {
  const std::size_t atoms = graph_.inner_count();
  resize_scratch();
  for (std::size_t a = 0; a < atoms; ++a) set_edges(a, positions);
  double energy = 0;
  for (AtomIndex a = 0; a < atoms; ++a)
    for (std::uint32_t s = 0; s < 3; ++s) {
      const AtomIndex n = graph_.neighbours[a][s];
      if (n == no_atom || n < a) continue;
      energy += add_bond(3 * a + s, n < atoms ? 3 * n + graph_.slot(n, a) : no_half);
    }
  for (std::size_t a = 0; a < atoms; ++a) add_forces(a, gradient);
  return energy;
}

double FixedBondRebo2::evaluate(std::span<const Vec3> positions, std::span<Vec3> gradient) {
  const std::optional<double> fast = loops_.evaluate(positions, gradient);
  if (!fast) return evaluate_each_bond(positions, gradient);
  double energy = *fast;
  if (incomplete_.empty()) return energy;
  // Bonds of incomplete atoms have no dihedral: each end is for itself.
  resize_scratch();
  for (const AtomIndex a : incomplete_) {
    set_edges(a, positions);
    for (std::uint32_t s = 0; s < 3; ++s)
      if (graph_.neighbours[a][s] != no_atom) energy += add_bond(3 * a + s, no_half);
    add_forces(a, gradient);
  }
  return energy;
}

void FixedBondRebo2::resize_scratch() {
  const std::size_t atoms = graph_.inner_count();
  edges_.resize(3 * atoms);
  angles_.resize(3 * atoms);
  edge_gradient_.assign(3 * atoms, HalfEdge{0, 0, 0, 0});
}

void FixedBondRebo2::add_forces(std::size_t a, std::span<Vec3> gradient) {
  const HalfEdge* e = &edges_[3 * a];
  HalfEdge* g = &edge_gradient_[3 * a];
  for (unsigned s = 0; s < 3; ++s) {
    const Angle& angle = angles_[3 * a + s];
    const double w = angle.weight * angle.slope;
    if (w == 0) continue;
    const unsigned i = (s + 1) % 3, j = (s + 2) % 3;
    g[i].x += w * e[j].x, g[i].y += w * e[j].y, g[i].z += w * e[j].z;
    g[j].x += w * e[i].x, g[j].y += w * e[i].y, g[j].z += w * e[i].z;
  }
  for (unsigned s = 0; s < 3; ++s) {
    const AtomIndex n = graph_.neighbours[a][s];
    if (n == no_atom) continue;
    const double along = g[s].x * e[s].x + g[s].y * e[s].y + g[s].z * e[s].z;
    const double inverse = 1 / e[s].length, radial = g[s].length - along * inverse;
    const Vec3 force(g[s].x * inverse + radial * e[s].x, g[s].y * inverse + radial * e[s].y,
                     g[s].z * inverse + radial * e[s].z);
    gradient[n] += force;
    gradient[a] -= force;
  }
}

}  // namespace nanocarbon::annealing
