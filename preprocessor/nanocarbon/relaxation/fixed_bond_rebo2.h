#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "nanocarbon/molecule/molecule.h"
#include "nanocarbon/relaxation/trivalent_network.h"

namespace nanocarbon {

//! \brief REBO2 of three-coordinated carbon on a given bond graph: no cut-off, so no bond breaks or forms.
//! \details For integer coordination 3 the potential of pair_style rebo reduces to V_R, V_A, the first branch
//! of g_C and the dihedral term with T = -0.004048; P_CC(2, 0) and pi_RC vanish. Minima agree with the full
//! potential as long as bonds stay below 1.7 Angstrom and other pairs above 2.0. Atoms with fewer bonds
//! (borders) get no dihedral and no pi_RC term, which is an approximation. Brenner et al., J. Phys. Condens.
//! Matter 14, 783 (2002).
class FixedBondRebo2 {
 public:
  //! The bond graph: neighbours of each atom, no_atom for a missing one. Bonds without an entry in `bonds`
  //! add no energy, but their atoms count as neighbours: a patch of a molecule evaluates the bonds its atoms
  //! can change.
  struct Graph {
    std::vector<std::array<AtomIndex, 3>> neighbours;
    std::vector<std::array<std::uint32_t, 2>> bonds;   //!< the two half-edges 3 * atom + slot of each bond
    std::size_t inner = static_cast<std::size_t>(-1);  //!< atoms from here on are at no end of a listed bond

    //! Lists every bond between the atoms.
    void list_all_bonds();
  };

  Graph graph;

  //! Energy in eV; gradient (eV/Angstrom) is added to.
  //! \pre both spans have the size of graph.neighbours
  double evaluate(std::span<const Vec3> positions, std::span<Vec3> gradient);

 private:
  struct HalfEdge {
    double x, y, z, length;  // unit vector towards the neighbour
  };
  struct Angle {
    double cosine, g, slope, weight;
  };
  std::vector<HalfEdge> edges_;
  std::vector<HalfEdge>
      edge_gradient_;          // dE by the unit vector; length: dE by the length, per bond at half-edge 0
  std::vector<Angle> angles_;  // opposite to slot s of each atom

  void set_angles(std::size_t atom);
  double add_bond(std::uint32_t h, std::uint32_t reverse);
};

//! The bond graph of a molecule in free space. \throw UserError (unsuitable) if an atom has more than three
//! bonds.
FixedBondRebo2::Graph fixed_bond_graph(const Molecule& molecule);

//! The bond graph of a network; unused atoms have no neighbours.
FixedBondRebo2::Graph fixed_bond_graph(const TrivalentNetwork& network);

}  // namespace nanocarbon
