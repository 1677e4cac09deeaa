// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/annealing/fixed_bond_rebo2.h"

#include <algorithm>
#include <cmath>

#include "nanocarbon/annealing/network_guards.h"
#include "nanocarbon/annealing/open_atoms.h"
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

// Below this sine of the angle at the bond a dihedral angle has no direction; keeps forces finite.
constexpr double least_sine = 1e-3;

// In place of the half-edge back: the bond's other half is counted elsewhere, or not at all.
constexpr std::uint32_t no_half = static_cast<std::uint32_t>(-1);

}  // namespace

// Directions perpendicular to a bond of the other bonds at one of its ends (dihedral term). At an open atom
// hydrogen lies opposite to the other carbon in that projection: it doubles its terms, which are even.
struct FixedBondRebo2::Fan {
  std::uint32_t halves[2];
  Vec3 u[2];
  double sine[2];
  double along[2];
  int arms = 0;
  double weight = 1;  // of each
};

void FixedBondRebo2::set_graph(const FixedBondGraph& graph) {
  graph_ = graph;
  loops_.set_graph(graph_);
  incomplete_.clear();
  for (AtomIndex a = 0; a < graph_.inner_count(); ++a)
    if (!graph_.complete(a)) incomplete_.push_back(a);
  apart_.assign(graph_.inner_count(), false);
}

double FixedBondRebo2::set_edges(std::size_t atom, std::span<const Vec3> positions) {
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
  return set_angles(atom);
}

double FixedBondRebo2::set_angles(std::size_t atom) {
  const HalfEdge* e = &edges_[3 * atom];
  Angle* angle = &angles_[3 * atom];
  const auto& neighbours = graph_.neighbours[atom];
  double hydrogen = 0;
  for (unsigned s = 0; s < 3; ++s) {
    const unsigned a = (s + 1) % 3, b = (s + 2) % 3;
    if (neighbours[a] == no_atom || neighbours[b] == no_atom) {
      angle[s] = {0, 0, 0, 0, 0};
      continue;
    }
    const double cosine = e[a].x * e[b].x + e[a].y * e[b].y + e[a].z * e[b].z;
    if (graph_.hydrogen && neighbours[s] == no_atom) {
      const OpenAtom open = open_atom(cosine);
      angle[s] = {cosine, open.angular_sum, open.by_cosine, 0, open.hydrogen_slope};
      hydrogen = open.hydrogen;
      continue;
    }
    const rebo2::ValueSlope g = rebo2::angular_carbon_few(rebo2::rebo2_parameters().carbon, cosine);
    angle[s] = {cosine, g.value, g.slope, 0, 0};
  }
  return hydrogen;
}

double FixedBondRebo2::add_half_order(std::uint32_t half, double attraction) {
  const std::uint32_t atom = half / 3, slot = half % 3;
  Angle* angle = &angles_[3 * atom];
  const unsigned k[2] = {(slot + 1) % 3, (slot + 2) % 3};
  const double zeta = 1 + angle[k[0]].g + angle[k[1]].g;
  const double p = 1 / std::sqrt(zeta);
  const double weight = attraction * 0.5 * -0.5 * p / zeta;
  angle[k[0]].weight += weight;
  angle[k[1]].weight += weight;
  return 0.5 * p;
}

FixedBondRebo2::Fan FixedBondRebo2::fan_of(std::uint32_t half, const Vec3& axis) const {
  const std::uint32_t atom = half / 3;
  Fan fan;
  for (unsigned n = 1; n < 3; ++n) {
    const std::uint32_t slot = (half % 3 + n) % 3;
    if (graph_.neighbours[atom][slot] == no_atom) {
      fan.weight = 2;
      continue;
    }
    const HalfEdge& other = edges_[3 * atom + slot];
    const Vec3 e(other.x, other.y, other.z);
    const int k = fan.arms++;
    fan.halves[k] = 3 * atom + slot;
    fan.along[k] = e.dot(axis);
    const Vec3 across = e - fan.along[k] * axis;
    fan.sine[k] = std::max(across.norm(), least_sine);
    fan.u[k] = across / fan.sine[k];
  }
  return fan;
}

double FixedBondRebo2::add_dihedral(const std::array<std::uint32_t, 2>& halves, double attraction) {
  const HalfEdge& edge = edges_[halves[0]];
  const Vec3 axis(edge.x, edge.y, edge.z);
  const Fan fan[2] = {fan_of(halves[0], axis), fan_of(halves[1], axis)};
  const double weight = fan[0].weight * fan[1].weight;
  const double scale = weight * torsion_constant() * attraction;
  double sum = 4;
  Vec3 on_axis = Vec3::Zero();
  for (int end = 0; end < 2; ++end) {
    const Fan& here = fan[end];
    const Fan& there = fan[1 - end];
    for (int n = 0; n < here.arms; ++n) {
      Vec3 by_u = Vec3::Zero();
      for (int m = 0; m < there.arms; ++m) {
        const double c = here.u[n].dot(there.u[m]);
        if (end == 0) sum -= weight * c * c;
        by_u -= 2 * scale * c * there.u[m];
      }
      const Vec3 by_e = (by_u - by_u.dot(here.u[n]) * here.u[n]) / here.sine[n];
      HalfEdge& target = edge_gradient_[here.halves[n]];
      target.x += by_e.x();
      target.y += by_e.y();
      target.z += by_e.z();
      on_axis -= here.along[n] * by_e;
    }
  }
  HalfEdge& own = edge_gradient_[halves[0]];
  own.x += on_axis.x();
  own.y += on_axis.y();
  own.z += on_axis.z();
  return torsion_constant() * sum;
}

double FixedBondRebo2::add_bond(std::uint32_t h, std::uint32_t reverse, bool reverse_half_too) {
  const double r = edges_[h].length;
  const rebo2::PairParameters& pair =
      rebo2::rebo2_parameters().pairs[rebo2::pair_index(Element::carbon, Element::carbon)];
  const rebo2::ValueSlope repulsion = rebo2::pair_repulsion(pair, r),
                          attraction = rebo2::pair_attraction(pair, r);
  double share = 0.5, order = add_half_order(h, attraction.value);
  if (reverse != no_half) {
    if (reverse_half_too) {
      share = 1;
      order += add_half_order(reverse, attraction.value);
    }
    const AtomIndex one = h / 3, other = reverse / 3;
    const std::size_t open = (graph_.open(one) ? 1 : 0) + (graph_.open(other) ? 1 : 0);
    if (open > 0) order += pi_of_open_bond(open);
    if (has_fan(one) && has_fan(other)) order += add_dihedral({h, reverse}, attraction.value);
  }
  edge_gradient_[h].length = share * repulsion.slope + order * attraction.slope;
  return share * repulsion.value + order * attraction.value;
}

double FixedBondRebo2::evaluate_each_bond(std::span<const Vec3> positions, std::span<Vec3> gradient) {
  const std::size_t atoms = graph_.inner_count();
  resize_scratch();
  std::fill(edge_gradient_.begin(), edge_gradient_.end(), HalfEdge{0, 0, 0, 0});
  double energy = 0;
  for (std::size_t a = 0; a < atoms; ++a) energy += set_edges(a, positions);
  for (AtomIndex a = 0; a < atoms; ++a)
    for (std::uint32_t s = 0; s < 3; ++s) {
      const AtomIndex n = graph_.neighbours[a][s];
      if (n == no_atom || n < a) continue;
      energy += add_bond(3 * a + s, n < atoms ? 3 * n + graph_.slot(n, a) : no_half);
    }
  for (std::size_t a = 0; a < atoms; ++a) add_forces(a, gradient);
  return energy;
}

// Whether a bond has terms that do not belong to one of its ends.
bool FixedBondRebo2::has_whole_terms(AtomIndex one, AtomIndex other) const {
  return graph_.open(one) || graph_.open(other) || (graph_.complete(one) && graph_.complete(other));
}

// Atoms whose edges and forces add_apart() works on: those apart, and complete neighbours that share dihedral terms
// with them.
std::vector<AtomIndex> FixedBondRebo2::touched_by(std::span<const AtomIndex> apart) const {
  std::vector<AtomIndex> touched(apart.begin(), apart.end());
  for (const AtomIndex a : apart) {
    if (!has_fan(a)) continue;
    for (const AtomIndex n : graph_.neighbours[a])
      if (n < graph_.inner_count() && !apart_[n]) touched.push_back(n);
  }
  std::sort(touched.begin(), touched.end());
  touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
  return touched;
}

// The energy of the atoms that the loops leave out, bond by bond: each its own halves of its bonds, as in the loops;
// and what bonds with one of them have as a whole, the dihedral term and what hydrogen changes.
double FixedBondRebo2::add_apart(std::span<const AtomIndex> outside, std::span<const Vec3> positions,
                                 std::span<Vec3> gradient) {
  std::vector<AtomIndex> apart(outside.begin(), outside.end());
  apart.insert(apart.end(), incomplete_.begin(), incomplete_.end());
  resize_scratch();
  for (const AtomIndex a : apart) apart_[a] = true;
  const std::vector<AtomIndex> touched = touched_by(apart);
  double energy = 0;
  for (const AtomIndex a : touched) {
    energy += set_edges(a, positions);
    std::fill_n(&edge_gradient_[3 * a], 3, HalfEdge{0, 0, 0, 0});
  }
  for (const AtomIndex a : apart)
    for (std::uint32_t s = 0; s < 3; ++s) {
      const AtomIndex n = graph_.neighbours[a][s];
      if (n == no_atom) continue;
      const bool whole = n < graph_.inner_count() && has_whole_terms(a, n);
      if (whole && apart_[n] && n < a) continue;
      energy += add_bond(3 * a + s, whole ? 3 * n + graph_.slot(n, a) : no_half, whole && apart_[n]);
    }
  for (const AtomIndex a : touched) add_forces(a, gradient);
  for (const AtomIndex a : apart) apart_[a] = false;
  return energy;
}

double FixedBondRebo2::evaluate(std::span<const Vec3> positions, std::span<Vec3> gradient, ThreadTeam* team) {
  loops_.measure(positions, team);
  const std::vector<AtomIndex> outside = loops_.outside();
  if (!outside.empty() && chunks().count() < 2) return evaluate_each_bond(positions, gradient);
  const double energy = loops_.add(outside, graph_, gradient, team);
  if (incomplete_.empty() && outside.empty()) return energy;
  return energy + add_apart(outside, positions, gradient);
}

double FixedBondRebo2::add_guards_where_strained(std::span<const Vec3> positions, std::span<Vec3> gradient,
                                                 ThreadTeam* team) const {
  return chunks().sum(team, [&](std::size_t chunk) {
    std::vector<AtomIndex> strained;
    loops_.find_strained(longest_unguarded_bond, closest_unguarded_second_neighbours, chunk, strained);
    const auto first = std::lower_bound(incomplete_.begin(), incomplete_.end(), chunks().begin(chunk)),
               last = std::lower_bound(first, incomplete_.end(), chunks().end(chunk));
    strained.insert(strained.end(), first, last);
    std::sort(strained.begin(), strained.end());
    double energy = 0;
    for (const AtomIndex a : strained) energy += add_guards_at(a, graph_, positions, gradient);
    return energy;
  });
}

double FixedBondRebo2::evaluate_guarded(std::span<const Vec3> positions, std::span<Vec3> gradient,
                                        ThreadTeam* team) {
  const double energy = evaluate(positions, gradient, team);
  return energy + add_guards_where_strained(positions, gradient, team);
}

void FixedBondRebo2::resize_scratch() {
  const std::size_t atoms = graph_.inner_count();
  edges_.resize(3 * atoms);
  angles_.resize(3 * atoms);
  edge_gradient_.resize(3 * atoms);
  apart_.resize(atoms, false);
}

void FixedBondRebo2::add_forces(std::size_t a, std::span<Vec3> gradient) {
  const HalfEdge* e = &edges_[3 * a];
  HalfEdge* g = &edge_gradient_[3 * a];
  for (unsigned s = 0; s < 3; ++s) {
    const Angle& angle = angles_[3 * a + s];
    const double w = angle.weight * angle.slope + angle.direct;
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
