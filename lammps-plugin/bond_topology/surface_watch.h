// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "nanocarbon/topology/bond_graph.h"
#include "nanocarbon/topology/surface_topology.h"

namespace nanocarbon {

//! The watched atoms and their bonds at one time, by ID.
struct WatchedAtoms {
  std::vector<std::int64_t> ids;  //!< ascending
  std::vector<Element> elements;
  std::vector<topology::BondEnd> bonds;  //!< each bond once, at its atom of lower ID
};

//! What everything later is compared with.
struct WatchStart {
  WatchedAtoms atoms;
  std::vector<topology::BondedIds> bonds;  //!< sorted
  topology::SurfaceTopology topology;
};

//! For output of one atom.
struct AtomState {
  enum : std::uint8_t { unchanged = 0, rebonded = 1, repelled = 2 };
  std::uint8_t state;  //!< rebonded: has lost or gained a bond since the start
  std::uint8_t coordination;
  std::uint8_t smallest_ring;  //!< 0: in none
};

//! The outcome of one look.
struct WatchReport {
  topology::Verdict verdict = topology::Verdict::intact;
  std::string reason;                      //!< why it is not intact, with the atom's ID where it is one atom
  std::vector<topology::BondedIds> bonds;  //!< now, sorted
  topology::BondChanges changes;           //!< since the start
  std::vector<std::int64_t> repelled;      //!< IDs, with those of lost atoms, ascending
  std::vector<std::int64_t> lost;          //!< IDs, ascending
  topology::SurfaceTopology topology;
  std::vector<AtomState> atoms;  //!< in the order of the IDs of the look
};

WatchStart start_watch(WatchedAtoms atoms, const topology::TopologyOptions& options);

//! Compares atoms with those of the start. An ID that the start does not have must not occur.
WatchReport report(const WatchStart& start, const WatchedAtoms& now,
                   const topology::TopologyOptions& options);

}  // namespace nanocarbon
