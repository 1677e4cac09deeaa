// SPDX-License-Identifier: GPL-2.0-or-later
// What has become of a molecule since the first frame of a trajectory.
#pragma once

#include <string>
#include <vector>

#include "nanocarbon/molecule/molecule.h"
#include "nanocarbon/topology/bond_graph.h"
#include "nanocarbon/topology/surface_topology.h"

namespace nanocarbon::analysis {

//! The bonds of a frame by the names of their atoms.
struct NamedBonds {
  std::vector<std::int64_t> ids;           //!< of all atoms, ascending
  std::vector<Bond> bonds;                 //!< sorted, by index
  std::vector<topology::BondedIds> named;  //!< the same by ID, sorted
};

//! \brief Bonds by distance, with hysteresis: those of the frame before hold until they are longer than `breaking`.
//! \param ids ascending
//! \param before the frame before, or nullptr in the first
NamedBonds frame_bonds(const Molecule& molecule, std::span<const std::int64_t> ids,
                       const topology::BondDistances& distances, const NamedBonds* before);

//! What the LAMMPS fix bond/topology says of a step.
struct FrameChange {
  topology::Verdict verdict = topology::Verdict::intact;
  std::string reason;                  //!< empty where intact
  topology::BondChanges changes;       //!< since the first frame
  std::vector<std::int64_t> repelled;  //!< IDs, with those of lost atoms, ascending
  std::vector<std::int64_t> lost;      //!< IDs that the first frame has and this one has not
  std::vector<std::int64_t> added;     //!< the other way round; they are not watched
};

//! How many bonds and atoms have changed from one frame to the next.
struct FrameStep {
  std::size_t broken = 0, formed = 0, lost = 0, added = 0;
  bool none() const { return broken + formed + lost + added == 0; }
};

FrameStep compare_with_before(const NamedBonds& before, const NamedBonds& now);

//! How an atom fares, as in the fix's per-atom output.
enum class AtomFate : std::uint8_t { unchanged = 0, rebonded = 1, repelled = 2 };

FrameChange compare_frames(const NamedBonds& start, const topology::SurfaceTopology& start_surface,
                           const NamedBonds& now, const topology::SurfaceTopology& now_surface);

//! \param ids of the atoms now, ascending
std::vector<AtomFate> atom_fates(std::span<const std::int64_t> ids, const FrameChange& change);

}  // namespace nanocarbon::analysis
