#include "nanocarbon/relaxation/fixed_bond_rebo2.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "nanocarbon/core/error.h"

namespace nanocarbon {

namespace {

// Carbon-carbon constants of REBO2 (Brenner et al. 2002, tables 2 and 3).
constexpr double kQ = 0.3134602960833, kA = 10953.544162170, kAlpha = 4.7465390606595;
constexpr std::array<double, 3> kB = {12388.79197798, 17.56740646509, 30.71493208065};
constexpr std::array<double, 3> kBeta = {4.7204523127, 1.4332132499, 1.3826912506};
constexpr double kTorsion = -0.004048;  // T_CC(2, 2, k), k = 2..9

struct Value {
  double f, slope;
};

Value angular(double cosine) {
  static constexpr double knots[3] = {-0.6666666667, -0.5, -0.3333333333};
  static constexpr double coefficients[4][6] = {
      {0.2816950000, 1.0627430000, 2.1363075000, 2.5334145000, 1.5544035000, 0.3862485000},
      {0.2827390000, 1.0718770000, 2.1681365000, 2.5885710000, 1.6019100000, 0.4025160000},
      {0.6900250000, 5.4601600000, 23.0108000000, 54.9086400000, 68.6124000000, 34.7051520000},
      {0.2718560918, 0.4892740137, -0.4328177539, -0.5616817383, 1.2708702246, -0.0375008379}};
  const int k = (cosine >= knots[0]) + (cosine >= knots[1]) + (cosine >= knots[2]);
  const double* c = coefficients[k];
  return {c[0] + cosine * (c[1] + cosine * (c[2] + cosine * (c[3] + cosine * (c[4] + cosine * c[5])))),
          c[1] + cosine * (2 * c[2] + cosine * (3 * c[3] + cosine * (4 * c[4] + cosine * 5 * c[5])))};
}

// Directions perpendicular to a bond of the two other bonds at one of its ends (dihedral term).
struct Fan {
  Vec3 u[2];
  double sine[2];
  double along[2];
};

// Below this sine of the angle at the bond a dihedral angle has no direction; keeps forces finite.
constexpr double kLeastSine = 1e-3;

}  // namespace

void FixedBondRebo2::Graph::list_all_bonds() {
  bonds.clear();
  for (AtomIndex a = 0; a < neighbours.size(); ++a)
    for (std::uint32_t s = 0; s < 3; ++s) {
      const AtomIndex n = neighbours[a][s];
      if (n == no_atom || n <= a) continue;
      const auto back = static_cast<std::uint32_t>(std::find(neighbours[n].begin(), neighbours[n].end(), a) -
                                                   neighbours[n].begin());
      bonds.push_back({3 * a + s, 3 * n + back});
    }
}

void FixedBondRebo2::set_angles(std::size_t atom) {
  const HalfEdge* e = &edges_[3 * atom];
  Angle* angle = &angles_[3 * atom];
  const auto& neighbours = graph.neighbours[atom];
  for (unsigned s = 0; s < 3; ++s) {
    const unsigned a = (s + 1) % 3, b = (s + 2) % 3;
    if (neighbours[a] == no_atom || neighbours[b] == no_atom) {
      angle[s] = {0, 0, 0, 0};
      continue;
    }
    const double cosine = e[a].x * e[b].x + e[a].y * e[b].y + e[a].z * e[b].z;
    const Value g = angular(cosine);
    angle[s] = {cosine, g.f, g.slope, 0};
  }
}

double FixedBondRebo2::add_bond(std::uint32_t h, std::uint32_t reverse) {
  const HalfEdge& edge = edges_[h];
  const double r = edge.length;
  const double screened = kA * std::exp(-kAlpha * r);
  const double repulsion = (1 + kQ / r) * screened;
  const double repulsion_slope = -kQ / (r * r) * screened - kAlpha * repulsion;
  double attraction = 0, attraction_slope = 0;
  for (int n = 0; n < 3; ++n) {
    const double term = -kB[n] * std::exp(-kBeta[n] * r);
    attraction += term;
    attraction_slope -= kBeta[n] * term;
  }

  const Vec3 axis(edge.x, edge.y, edge.z);
  double order = 0;
  Fan fan[2];
  bool dihedral = true;
  for (int end = 0; end < 2; ++end) {
    const std::uint32_t half = end == 0 ? h : reverse, atom = half / 3, slot = half % 3;
    Angle* angle = &angles_[3 * atom];
    const unsigned k[2] = {(slot + 1) % 3, (slot + 2) % 3};
    const double zeta = 1 + angle[k[0]].g + angle[k[1]].g;
    const double p = 1 / std::sqrt(zeta);
    order += 0.5 * p;
    const double weight = attraction * 0.5 * -0.5 * p / zeta;
    angle[k[0]].weight += weight;
    angle[k[1]].weight += weight;
    for (int n = 0; n < 2; ++n) {
      dihedral &= graph.neighbours[atom][k[n]] != no_atom;
      const HalfEdge& other = edges_[3 * atom + k[n]];
      const Vec3 e(other.x, other.y, other.z);
      // The angle between slots `slot` and k[n] is the one opposite to the third slot.
      fan[end].along[n] = e.dot(axis);
      const Vec3 across = e - fan[end].along[n] * axis;
      fan[end].sine[n] = std::max(across.norm(), kLeastSine);
      fan[end].u[n] = across / fan[end].sine[n];
    }
  }
  HalfEdge& own = edge_gradient_[h];
  if (dihedral) {
    double sum = 4;
    Vec3 on_axis = Vec3::Zero();
    const double scale = kTorsion * attraction;
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
    order += kTorsion * sum;
  }
  own.length = repulsion_slope + order * attraction_slope;
  return repulsion + order * attraction;
}

double FixedBondRebo2::evaluate(std::span<const Vec3> positions, std::span<Vec3> gradient) {
  const std::size_t atoms = std::min(graph.inner, graph.neighbours.size());
  edges_.resize(3 * atoms);
  angles_.resize(3 * atoms);
  edge_gradient_.assign(3 * atoms, HalfEdge{0, 0, 0, 0});
  for (std::size_t a = 0; a < atoms; ++a) {
    for (unsigned s = 0; s < 3; ++s) {
      const AtomIndex n = graph.neighbours[a][s];
      if (n == no_atom) {
        edges_[3 * a + s] = {0, 0, 0, 0};
        continue;
      }
      const Vec3 d = positions[n] - positions[a];
      const double r = d.norm();
      edges_[3 * a + s] = {d.x() / r, d.y() / r, d.z() / r, r};
    }
    set_angles(a);
  }
  double energy = 0;
  for (const auto& [h, reverse] : graph.bonds) energy += add_bond(h, reverse);

  for (std::size_t a = 0; a < atoms; ++a) {
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
      const AtomIndex n = graph.neighbours[a][s];
      if (n == no_atom) continue;
      const double along = g[s].x * e[s].x + g[s].y * e[s].y + g[s].z * e[s].z;
      const double inverse = 1 / e[s].length, radial = g[s].length - along * inverse;
      const Vec3 force(g[s].x * inverse + radial * e[s].x, g[s].y * inverse + radial * e[s].y,
                       g[s].z * inverse + radial * e[s].z);
      gradient[n] += force;
      gradient[a] -= force;
    }
  }
  return energy;
}

FixedBondRebo2::Graph fixed_bond_graph(const Molecule& molecule) {
  FixedBondRebo2::Graph graph;
  graph.neighbours.assign(molecule.size(), {no_atom, no_atom, no_atom});
  const auto add = [&](AtomIndex from, AtomIndex to) {
    for (AtomIndex& slot : graph.neighbours[from])
      if (slot == no_atom) {
        slot = to;
        return;
      }
    throw UserError(Failure::unsuitable,
                    fmt::format("atom {} has more than three bonds; only sp2 carbon can be relaxed", from));
  };
  for (const Bond& bond : molecule.bonds) {
    add(bond.first, bond.second);
    add(bond.second, bond.first);
  }
  graph.list_all_bonds();
  return graph;
}

FixedBondRebo2::Graph fixed_bond_graph(const TrivalentNetwork& network) {
  FixedBondRebo2::Graph graph;
  graph.neighbours.reserve(network.atoms.size());
  for (const TrivalentAtom& atom : network.atoms)
    graph.neighbours.push_back(atom.exists() ? atom.neighbour : std::array{no_atom, no_atom, no_atom});
  graph.list_all_bonds();
  return graph;
}

}  // namespace nanocarbon
