// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "nanocarbon/mesh/triangle_mesh.h"
#include "nanocarbon/molecule/molecule.h"

namespace nanocarbon::annealing {

using RingIndex = std::uint32_t;
inline constexpr AtomIndex no_atom = 0xffffffffu;

//! Distance below which unbonded atoms repel each other, Angstrom. REBO2 itself sees other atoms up to 2.0.
inline constexpr double default_steric_reach = 2.9;

//! An atom of a trivalent network, the dual of a triangle: corner s of the triangle is ring[s], and
//! neighbour[s] lies across the side opposite to it, so the bond to neighbour[s] separates ring[s + 1] from
//! ring[s + 2]. Slots run counter-clockwise seen from outside.
struct TrivalentAtom {
  std::array<AtomIndex, 3> neighbour;  //!< no_atom across a side on the boundary
  std::array<RingIndex, 3> ring;

  bool exists() const { return ring[0] != no_atom; }
};

//! A ring of the network, the dual of a vertex.
struct TrivalentRing {
  std::uint32_t size = 0;    //!< atoms in it; 0 for an unused entry
  AtomIndex atom = no_atom;  //!< one of them; on the boundary the first one counter-clockwise
  bool boundary = false;     //!< a vertex on the boundary: a chain of atoms, not a ring
};

//! The bond graph of a carbon surface together with its rings: a triangulation and its dual in one.
//! Entries removed by a collapse stay in place, unused, until compact().
struct TrivalentNetwork {
  std::vector<TrivalentAtom> atoms;
  std::vector<TrivalentRing> rings;
  bool hydrogen = false;  //!< whether atoms with a side on the boundary bind hydrogen there
  double steric_reach = default_steric_reach;  //!< of unbonded atoms, see steric_contacts.h; Angstrom
};

//! The dual network of a triangulation: atom i is triangle i, ring v is vertex v.
//! \pre an oriented 2-manifold without isolated vertices;
//! \throw UserError (unsuitable) naming the edge otherwise
TrivalentNetwork trivalent_network(const TriangleMesh& triangulation);

//! Slot of an atom that holds the given neighbour or ring; 3 if none does.
unsigned slot_of_neighbour(const TrivalentAtom& atom, AtomIndex neighbour);
unsigned slot_of_ring(const TrivalentAtom& atom, RingIndex ring);

//! The atoms of a ring in counter-clockwise order, beginning at its own atom.
void atoms_of_ring(const TrivalentNetwork& network, RingIndex ring, std::vector<AtomIndex>& atoms);

//! Atoms and rings in use.
std::size_t atom_count(const TrivalentNetwork& network);

//! Moves the used entries to the front, keeping their order. Returns the former index of each atom.
std::vector<AtomIndex> compact(TrivalentNetwork& network);

//! The molecule of a compact network, in a cell with the images that its bonds lead to. Rings of the boundary
//! are left out.
Molecule molecule_of(const TrivalentNetwork& network, std::span<const Vec3> positions, const Space& space);

//! \brief The triangulation whose dual a compact network is: triangle i is atom i, vertex r is ring r.
//! \details Vertices are at the rings' centroids, those of the boundary as far outside as the sheet of atoms
//! goes on there.
TriangleMesh triangulation_of(const TrivalentNetwork& network, std::span<const Vec3> positions,
                              const Space& space);

//! Number of inner rings of each size: entry s counts the rings of s atoms.
std::vector<std::size_t> ring_counts(const TrivalentNetwork& network);

}  // namespace nanocarbon::annealing
