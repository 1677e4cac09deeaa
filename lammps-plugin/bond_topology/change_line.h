// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "bond_topology/surface_watch.h"

namespace nanocarbon {

//! When something was seen: LAMMPS's step, and the time in its units.
struct SimulationTime {
  std::int64_t step;
  double time;
};

//! One line of JSON (without a line end) that says what was there when the watch began.
std::string start_line(const SimulationTime& when, const WatchStart& start);

//! One line of JSON: what has changed between two looks, and how things stand after the second.
std::string change_line(const SimulationTime& when, const WatchReport& before, const WatchReport& now);

//! The figures of a report that thermo output shows, in the order of the fix's global vector, see the
//! documentation.
struct WatchFigures {
  static constexpr int count = 12;
  double verdict = 0.0;
  double vector[count] = {};  //!< not a number where the bonds are not a surface and have no such figure
};
WatchFigures figures(const WatchReport& report);

//! A few lines for the log.
std::string summary(const std::string& title, const SimulationTime& when, const WatchReport& report);

}  // namespace nanocarbon
