// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "nanocarbon/molecule/molecule.h"

namespace nanocarbon::test {

//! A step of a trajectory: all atoms in the order of their IDs, which are indices plus one.
struct Frame {
  long step;
  Molecule atoms;  //!< with the cell; without bonds
};

//! Reads `dump custom id type x y z` (type 1 is carbon), as far as all ranks have written it. Periodic as
//! given.
std::vector<Frame> read_trajectory(const std::string& path, std::array<bool, 3> periodic);

//! \brief The lines that fix bond/topology must write for a trajectory, computed by the library alone: bonds
//! by distance with hysteresis from frame to frame, surface and verdict from bonds, atoms repelled.
std::vector<nlohmann::json> expected_lines(const std::vector<Frame>& frames);

//! Both without their times, which a trajectory does not hold.
std::vector<nlohmann::json> parsed(const std::vector<std::string>& lines);

}  // namespace nanocarbon::test
