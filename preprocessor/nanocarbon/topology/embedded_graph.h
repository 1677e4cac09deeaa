// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "nanocarbon/core/cell.h"
#include "nanocarbon/core/element.h"
#include "nanocarbon/core/vec3.h"
#include "nanocarbon/topology/bonds.h"

namespace nanocarbon::topology {

//! \brief A bond graph with the direction of each bond: all that the topology of its surface is read off.
//! \details In compressed rows of half-edges: each bond stands in the rows of both its atoms, with opposite
//! vectors. An atom may be bonded to several images of one atom or of itself; vectors tell such half-edges
//! apart.
struct EmbeddedGraph {
  std::vector<std::uint32_t> offsets = {0};  //!< size atoms + 1; row i is [offsets[i], offsets[i + 1])
  std::vector<AtomIndex> ends;               //!< the neighbour that each half-edge leads to
  std::vector<Vec3> vectors;                 //!< from the atom to that neighbour, Angstrom
  std::vector<Element> elements;             //!< of each atom
  std::vector<std::int64_t>
      ids;  //!< names of the atoms in messages; empty: indices plus one, as in data files

  std::size_t atoms() const { return offsets.size() - 1; }
  std::int64_t id(AtomIndex atom) const { return ids.empty() ? std::int64_t{atom} + 1 : ids[atom]; }
  std::uint32_t degree(AtomIndex atom) const { return offsets[atom + 1] - offsets[atom]; }
};

//! From bonds and positions.
//! \param cell nullptr in free space
EmbeddedGraph embedded_graph(std::span<const Vec3> positions, std::span<const Element> elements,
                             std::span<const Bond> bonds, const Cell* cell);

//! One end of a bond, by the IDs of its atoms.
struct BondEnd {
  std::int64_t atom;
  std::int64_t neighbour;
  Vec3 vector;  //!< from the atom to that neighbour, Angstrom
};

//! \brief From bond ends gathered in any order, as from the ranks of a parallel run. Atoms are numbered as in
//! `ids`.
//! \details The result does not depend on the order of the ends. Ends at or towards IDs that are not listed
//! are left out; the other end of such a bond is then reported by surface_topology, unless it is left out as
//! well.
//! \param ids of all atoms, in ascending order without repetition
//! \param elements of these atoms
EmbeddedGraph embedded_graph(std::span<const std::int64_t> ids, std::span<const Element> elements,
                             std::span<const BondEnd> ends);

}  // namespace nanocarbon::topology
