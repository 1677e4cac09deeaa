// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "nanocarbon/topology/embedded_graph.h"
#include "nanocarbon/topology/not_a_surface.h"
#include "nanocarbon/topology/rings.h"

namespace nanocarbon::topology {

//! What two surfaces must share to be homeomorphic, for one connected component of a molecule.
struct ComponentTopology {
  bool has_rings = false;  //!< without a ring it is a fragment (a lone atom, a chain), counted as a disc
  bool orientable = true;
  int genus = 0;  //!< handles where orientable, cross-caps otherwise
  int boundary_loops = 0;
  friend auto operator<=>(const ComponentTopology&, const ComponentTopology&) = default;
  int euler_characteristic() const { return 2 - (orientable ? 2 : 1) * genus - boundary_loops; }
};

//! The surface that the rings of a bond graph make. Where it is none, only `problem`, coordination and
//! components mean anything.
struct SurfaceTopology {
  std::optional<NotASurface> problem;
  std::vector<ComponentTopology> components;  //!< numbered by their lowest atom
  int euler_characteristic = 0;               //!< these four: sums over the components
  int genus = 0;
  int boundary_loops = 0;
  bool orientable = true;                        //!< every component is
  std::vector<std::uint32_t> ring_counts;        //!< by size; size max_ring + 1
  std::vector<std::uint32_t> component_of_atom;  //!< index into components
  std::vector<std::uint8_t> coordination;        //!< bonds of each atom (255 for more)
  std::vector<std::uint8_t> smallest_ring;       //!< of each atom; 0 where it is in no ring
  Rings rings;  //!< each starts at its lowest atom; those of an orientable component all run
                //!< counter-clockwise seen from the side that it bends away from, the outside
  //! Boundary loops around holes in a sheet, which turn to the left as rings do; those of tubes' ends and of
  //! flakes do not. An atom stands there as often as the boundary passes it.
  Rings holes;
};

struct TopologyOptions {
  int max_ring = 12;  //!< a face with more atoms is a hole, that is a boundary loop; 3 to 255
};

//! \brief Reads a molecule's surface off its bonds by face tracing (not by shortest cycles).
//! \details orientation.h says how sides are told, face_tracing.h how faces are. Rings are the faces of at
//! most max_ring atoms, the others are boundary loops; so is a shorter face that turns the wrong way or not
//! at all (less than half a full turn to the left), as the boundary of a naphthalene or of a thin open tube does.
//! Hydrogen is not part of the surface. Carbon that hangs on by one bond, alone or as a tree, is left out of
//! faces and changes nothing. Not a surface, and never guessed: a carbon atom bonded to four or more others;
//! a bond known to one of its atoms only; a bond twisted by a right angle that only long cycles go through;
//! a face that no surface has (face_check.h), as atoms far out of place make. Linear; 10,000 atoms take two
//! milliseconds.
SurfaceTopology surface_topology(const EmbeddedGraph& graph, const TopologyOptions& options = {});

enum class Verdict { intact = 0, homeomorphic = 1, broken = 2, not_a_surface = 3 };
std::string_view name(Verdict verdict);

struct Judgement {
  Verdict verdict;
  std::string reason;             //!< empty where intact
  std::optional<AtomIndex> atom;  //!< where, if at one atom
};

//! \brief Compares a surface with the one it was.
//! \details Intact: the bonds are the same, whatever they make. Homeomorphic: other bonds, but the components
//! are of the same kinds (the multisets of ComponentTopology are equal; sums alone would miss changes that
//! make up for each other).
//! \param lost_atoms atoms that are no longer there at all, which is broken
Judgement judge(const SurfaceTopology& start, const SurfaceTopology& now, bool same_bonds,
                std::size_t lost_atoms = 0);

}  // namespace nanocarbon::topology
