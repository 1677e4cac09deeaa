// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/annealing/local_relaxation.h"

#include <algorithm>

#include "nanocarbon/annealing/boundary_curve.h"
#include "nanocarbon/annealing/fixed_bond_rebo2.h"
#include "nanocarbon/core/chunks.h"
#include "nanocarbon/minimisation/lbfgs.h"
#include "nanocarbon/topology/bond_shells.h"

namespace nanocarbon::annealing {

namespace {

// Bonds from an atom that feels a force to the farthest that moves with it.
constexpr unsigned reach = 6;
// The energy of a bond depends on its atoms' neighbours: what an atom changes reaches this many bonds further.
constexpr unsigned halo = 3;

// Larger pieces are no faster on their own than with the rest; and the share of all atoms that may be in pieces.
constexpr std::size_t largest_piece = 4000;
constexpr double largest_share = 0.5;

constexpr int iterations = 200;

// Atoms of a piece, those that move first, then shells that are held. The last only lends its positions.
struct Piece {
  std::vector<AtomIndex> atoms;
  std::size_t moving = 0, inner = 0;
};

struct Contact {
  std::uint32_t one;
  std::uint32_t other;  // of those that move, or none
  Vec3 held;            // where it is if it does not
};
constexpr std::uint32_t none = static_cast<std::uint32_t>(-1);

// What is around the atoms given, in pieces that do not touch each other, halo included.
std::vector<Piece> pieces_around(const FixedBondGraph& graph, std::span<const AtomIndex> forced) {
  // 1 + bonds to the next forced atom.
  std::vector<std::uint8_t> distance(graph.neighbours.size(), 0);
  std::vector<AtomIndex> all(forced.begin(), forced.end());
  for (const AtomIndex a : forced) distance[a] = 1;
  std::size_t shell = 0;
  for (unsigned k = 0; k < reach + halo; ++k)
    topology::add_bond_shell(graph, all, shell, [&](AtomIndex n) {
      if (n == no_atom || distance[n] != 0) return false;
      distance[n] = static_cast<std::uint8_t>(k + 2);
      return true;
    });
  std::vector<Piece> pieces;
  std::vector<bool> done(graph.neighbours.size(), false);
  for (const AtomIndex start : forced) {
    if (done[start]) continue;
    Piece& piece = pieces.emplace_back();
    piece.atoms = {start};
    done[start] = true;
    std::size_t next = 0;
    while (next < piece.atoms.size())
      topology::add_bond_shell(graph, piece.atoms, next, [&](AtomIndex n) {
        if (n == no_atom || done[n] || distance[n] == 0) return false;
        done[n] = true;
        return true;
      });
    // In order of the distance, then of the number.
    std::sort(piece.atoms.begin(), piece.atoms.end(), [&](AtomIndex a, AtomIndex b) {
      return distance[a] != distance[b] ? distance[a] < distance[b] : a < b;
    });
    const auto count = [&](unsigned bonds) {
      return static_cast<std::size_t>(
          std::partition_point(piece.atoms.begin(), piece.atoms.end(),
                               [&](AtomIndex a) { return distance[a] <= bonds + 1; }) -
          piece.atoms.begin());
    };
    piece.moving = count(reach);
    piece.inner = count(reach + halo - 1);
  }
  return pieces;
}

class PieceModel {
 public:
  //! \param number scratch, `none` for each atom
  PieceModel(const HeldMolecule& whole, const std::vector<Vec3>& positions, const Piece& piece,
             std::vector<std::uint32_t>& number)
      : moving_(piece.moving) {
    FixedBondGraph graph = part_of(whole.graph, piece.atoms, piece.inner, number);
    graph.space = {};
    for (const AtomIndex a : piece.atoms) {
      positions_.push_back(positions[a]);
      if (!whole.planes.empty()) {
        planes_.push_back(whole.planes[a]);
        planes_.back().point += whole.mean_height * planes_.back().normal;
      }
      if (a < whole.edges.size()) edges_.push_back(whole.edges[a]);
    }
    planes_.resize(std::min(planes_.size(), moving_));
    for (std::uint32_t k = 0; k < moving_; ++k)
      for (const AtomIndex other : whole.contacts.near(piece.atoms[k])) {
        const std::uint32_t o = number[other] < moving_ ? number[other] : none;
        if (o == none || o > k) contacts_.push_back({k, o, positions[other]});
      }
    for (const AtomIndex a : piece.atoms) number[a] = none;
    rebo2_.set_graph(graph);
    tether_ = whole.tether;
    reach_ = whole.reach;
    gradient_.resize(positions_.size());
  }

  minimisation::LbfgsResult relax(double force_tolerance) {
    std::vector<Vec3> x(positions_.begin(), positions_.begin() + static_cast<std::ptrdiff_t>(moving_));
    const auto energy = [&](std::span<const Vec3> at, std::span<Vec3> g) { return evaluate(at, g); };
    const minimisation::LbfgsResult result = minimisation::minimise_lbfgs(
        x, energy, {.max_iterations = iterations, .force_tolerance = force_tolerance});
    std::copy(x.begin(), x.end(), positions_.begin());
    return result;
  }

  const Vec3& position(std::size_t k) const { return positions_[k]; }

 private:
  double evaluate(std::span<const Vec3> at, std::span<Vec3> gradient) {
    std::copy(at.begin(), at.end(), positions_.begin());
    std::fill(gradient_.begin(), gradient_.end(), Vec3::Zero());
    double energy = rebo2_.evaluate_guarded(positions_, gradient_);
    if (!planes_.empty()) energy += add_tether(planes_, tether_, at, gradient_, false);
    energy += add_boundary_tether(edges_, rebo2_.graph(), reach_, positions_, gradient_);
    for (const Contact& c : contacts_) {
      Vec3 at_one = Vec3::Zero();
      energy +=
          steric_pair(at[c.one], c.other == none ? c.held : at[c.other], rebo2_.graph().steric_reach, at_one);
      gradient_[c.one] += at_one;
      if (c.other != none) gradient_[c.other] -= at_one;
    }
    for (std::size_t k = 0; k < moving_; ++k) gradient[k] += gradient_[k];
    return energy;
  }

  std::size_t moving_;
  FixedBondRebo2 rebo2_;
  std::vector<Vec3> positions_, gradient_;
  std::vector<TangentPlane> planes_, edges_;
  std::vector<Contact> contacts_;
  double tether_ = 0, reach_ = 0;
};

}  // namespace

LocalRelaxation relax_around(const HeldMolecule& whole, std::vector<Vec3>& positions,
                             std::span<const AtomIndex> forced, double force_tolerance, ThreadTeam* team) {
  LocalRelaxation result;
  const double most = largest_share * static_cast<double>(positions.size());
  if (forced.empty() || static_cast<double>(forced.size()) > most) return result;
  std::vector<Piece> pieces = pieces_around(whole.graph, forced);
  std::erase_if(pieces, [](const Piece& p) { return p.moving > largest_piece; });
  std::size_t moved = 0;
  for (const Piece& piece : pieces) moved += piece.moving;
  if (static_cast<double>(moved) > most) return result;
  // What numbers the atoms is as long as the molecule: a few of them for all pieces.
  constexpr std::size_t at_once = 8;
  // Pieces may touch atoms of others, which stay where they were: the same whichever is relaxed first.
  const std::vector<Vec3> before = positions;
  for_each_index(team, std::min(pieces.size(), at_once), [&](std::size_t first) {
    std::vector<std::uint32_t> number(positions.size(), none);
    for (std::size_t k = first; k < pieces.size(); k += at_once) {
      PieceModel piece(whole, before, pieces[k], number);
      piece.relax(force_tolerance);
      for (std::size_t m = 0; m < pieces[k].moving; ++m) positions[pieces[k].atoms[m]] = piece.position(m);
    }
  });
  return {pieces.size(), moved};
}

}  // namespace nanocarbon::annealing
