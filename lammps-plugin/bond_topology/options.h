// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lammps.h"
#include "nanocarbon/core/element.h"
#include "nanocarbon/topology/bond_graph.h"
#include "nanocarbon/topology/surface_topology.h"

namespace nanocarbon {

//! The settings of one fix bond/topology; its documentation page says what each does.
struct BondTopologyOptions {
  int every = 0;
  topology::BondDistances distances;
  topology::TopologyOptions topology;
  std::string file;  //!< empty: none
  bool append = false;
  bool halt = false;
  //! Of types from 1, as the keyword element says; empty without it, nothing for NULL.
  std::vector<std::optional<Element>> elements;
};

//! \brief Reads the arguments of the fix command, from N on.
//! \details Errors go through LAMMPS and name the keyword and its value.
BondTopologyOptions read_options(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg);

//! "yes" or "no". Others are an error that names the keyword.
bool read_yes_or_no(LAMMPS_NS::LAMMPS* lmp, const std::string& keyword, const std::string& value);

}  // namespace nanocarbon
