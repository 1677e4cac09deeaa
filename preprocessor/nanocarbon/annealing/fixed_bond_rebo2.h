// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "nanocarbon/annealing/fixed_bond_graph.h"
#include "nanocarbon/annealing/fixed_bond_loops.h"

namespace nanocarbon::annealing {

//! \brief REBO2 of three-coordinated carbon on a given bond graph: no cut-off, so no bond breaks or forms.
//! \details For integer coordination 3 the potential of pair_style rebo reduces to V_R, V_A, the first branch
//! of g_C and the dihedral term with T = -0.004048; P_CC(2, 0) and pi_RC vanish. Minima agree with the full
//! potential as long as bonds stay below 1.7 Angstrom and other pairs above 2.0. Atoms with fewer bonds
//! (boundaries) get no dihedral and no pi_RC term, which is an approximation. Brenner et al., J. Phys.
//! Condens. Matter 14, 783 (2002). Where the graph says that such atoms with two bonds hold hydrogen, its energy,
//! less that of hydrogen in benzene, and what it does to the bonds beside it are added (open_atoms.h).
class FixedBondRebo2 {
 public:
  void set_graph(const FixedBondGraph& graph);
  const FixedBondGraph& graph() const { return graph_; }

  //! Energy of the inner atoms in eV; gradient (eV/Angstrom) is added to.
  //! \details By vector loops; bond by bond around atoms with a bond or an angle outside their range. Small
  //! molecules are evaluated bond by bond as a whole where there is such an atom.
  //! \pre both spans have the size of graph().neighbours
  double evaluate(std::span<const Vec3> positions, std::span<Vec3> gradient, ThreadTeam* team = nullptr);

  //! The same with the guards of network_guards.h, at hardly any cost where they do not act.
  double evaluate_guarded(std::span<const Vec3> positions, std::span<Vec3> gradient,
                          ThreadTeam* team = nullptr);

  //! Parts of the molecule that may be worked on at once.
  const AtomChunks& chunks() const { return loops_.chunks(); }

  //! The same bond by bond, whatever the geometry; agrees with the above to 1e-9 eV for each atom.
  double evaluate_each_bond(std::span<const Vec3> positions, std::span<Vec3> gradient);

 private:
  struct HalfEdge {
    double x, y, z, length;  // unit vector towards the neighbour
  };
  struct Angle {
    double cosine, g, slope, weight;
    double direct;  // slope of what an open atom's hydrogen adds
  };
  struct Fan;
  std::vector<HalfEdge> edges_;
  // dE by the unit vector, and in place of the length dE by the length: of a bond at the half-edge that it is
  // evaluated from.
  std::vector<HalfEdge> edge_gradient_;
  std::vector<Angle> angles_;  // opposite to slot s of each atom

  FixedBondGraph graph_;
  FixedBondLoops loops_;
  std::vector<AtomIndex> incomplete_;  // inner atoms with less than three bonds; sorted
  std::vector<char> apart_;            // atoms that are not evaluated by the loops this time

  void resize_scratch();
  bool has_whole_terms(AtomIndex one, AtomIndex other) const;
  std::vector<AtomIndex> touched_by(std::span<const AtomIndex> apart) const;
  double add_apart(std::span<const AtomIndex> outside, std::span<const Vec3> positions,
                   std::span<Vec3> gradient);
  double add_guards_where_strained(std::span<const Vec3> positions, std::span<Vec3> gradient,
                                   ThreadTeam* team) const;
  // Return the energy of the atom's hydrogen, if any.
  double set_edges(std::size_t atom, std::span<const Vec3> positions);
  double set_angles(std::size_t atom);
  bool has_fan(AtomIndex atom) const { return graph_.complete(atom) || graph_.open(atom); }
  Fan fan_of(std::uint32_t half, const Vec3& axis) const;
  double add_half_order(std::uint32_t half, double attraction);
  double add_dihedral(const std::array<std::uint32_t, 2>& halves, double attraction);
  double add_bond(std::uint32_t h, std::uint32_t reverse, bool reverse_half_too = true);
  void add_forces(std::size_t atom, std::span<Vec3> gradient);
};

}  // namespace nanocarbon::annealing
