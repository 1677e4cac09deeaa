// SPDX-License-Identifier: GPL-2.0-or-later
// The connected components of a molecule, the surface of each that has one, and the rings.
#pragma once

#include <string>
#include <vector>

#include "nanocarbon/analysis/ring_search.h"
#include "nanocarbon/molecule/molecule.h"
#include "nanocarbon/topology/surface_topology.h"

namespace nanocarbon::analysis {

//! How a component's rings were found.
enum class RingKind : std::uint8_t { faces, king, primitive, none };
std::string_view name(RingKind kind);

//! A connected component.
struct MoleculeComponent {
  std::size_t atoms = 0;
  AtomIndex first = 0;                   //!< its lowest atom
  std::string not_a_surface;             //!< why it is none; empty where it is one
  topology::ComponentTopology topology;  //!< where it is a surface
  RingKind rings = RingKind::faces;
  bool is_surface() const { return not_a_surface.empty(); }
};

//! Which rings are wanted.
enum class RingChoice {
  automatic,  //!< faces where a component is a surface, King's elsewhere
  king,
  primitive
};

struct ComponentOptions {
  RingChoice rings = RingChoice::automatic;
  int max_ring = 12;     //!< 3 to 64; of a surface, a longer face is a hole
  unsigned threads = 1;  //!< the result does not depend on it
};

//! Components and rings.
struct MoleculeComponents {
  //! Of all components together, as the LAMMPS fix and verdicts see them.
  topology::SurfaceTopology surface;
  std::vector<MoleculeComponent> list;  //!< numbered by their lowest atom
  std::vector<std::uint32_t> of_atom;
  Rings rings;  //!< of all components; faces run counter-clockwise seen from outside where there is one
  Rings holes;  //!< boundary loops around holes of the components that are surfaces (SurfaceTopology::holes)
  std::vector<std::uint64_t> ring_counts;  //!< by size; size max_ring + 1
  //! Of the components that were searched: those that are not surfaces, or all if asked for. Empty if none were.
  std::vector<std::uint64_t> king_counts, primitive_counts;
  std::size_t atoms_searched = 0;         //!< in those components: what such counts are divided by
  std::size_t atoms_without_surface = 0;  //!< in the components that are not surfaces
  std::string
      rings_not_counted;  //!< why the rings of components without surface are not known; usually empty

  bool all_surfaces() const { return atoms_without_surface == 0; }
};

//! \brief Takes a molecule's components apart and reads the surface of each off its bonds.
//! \details A component that is no surface does not keep the others from being ones. Linear in atoms.
//! \param ids names of the atoms in messages; empty: indices plus one
//! \pre the bonds are known
MoleculeComponents find_components(const Molecule& molecule, std::span<const std::int64_t> ids,
                                   const ComponentOptions& options);

}  // namespace nanocarbon::analysis
