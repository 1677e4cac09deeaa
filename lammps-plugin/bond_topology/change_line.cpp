// SPDX-License-Identifier: GPL-2.0-or-later
#include "bond_topology/change_line.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>

namespace nanocarbon {
namespace {

using Json = nlohmann::ordered_json;

Json list(const std::vector<topology::BondedIds>& bonds) {
  Json result = Json::array();
  for (const topology::BondedIds& bond : bonds) result.push_back({bond.first, bond.second});
  return result;
}

// Sorted lists: what is in the first and not in the second.
template <typename Item>
std::vector<Item> without(const std::vector<Item>& items, const std::vector<Item>& others) {
  std::vector<Item> result;
  std::set_difference(items.begin(), items.end(), others.begin(), others.end(), std::back_inserter(result));
  return result;
}

void add_topology(Json& line, const topology::SurfaceTopology& topology) {
  line["pieces"] = topology.components.size();
  if (topology.problem) {
    line["surface"] = false;
    return;
  }
  line["surface"] = true;
  line["euler_characteristic"] = topology.euler_characteristic;
  line["orientable"] = topology.orientable;
  line["genus"] = topology.genus;
  line["boundary_loops"] = topology.boundary_loops;
  Json rings = Json::object();
  for (std::size_t size = 0; size < topology.ring_counts.size(); ++size)
    if (topology.ring_counts[size] > 0) rings[std::to_string(size)] = topology.ring_counts[size];
  line["rings"] = rings;
}

std::uint32_t rings_of(const topology::SurfaceTopology& topology, std::size_t size) {
  return size < topology.ring_counts.size() ? topology.ring_counts[size] : 0;
}

std::uint32_t other_rings(const topology::SurfaceTopology& topology) {
  std::uint32_t count = 0;
  for (std::size_t size = 0; size < topology.ring_counts.size(); ++size)
    if (size < 5 || size > 7) count += topology.ring_counts[size];
  return count;
}

std::string counted(std::size_t count, const std::string& thing) {
  return std::to_string(count) + " " + thing + (count == 1 ? "" : "s");
}

}  // namespace

std::string start_line(const SimulationTime& when, const WatchStart& start) {
  Json line = {{"step", when.step}, {"time", when.time}, {"event", "start"}};
  line["atoms"] = start.atoms.ids.size();
  line["bonds"] = start.bonds.size();
  add_topology(line, start.topology);
  return line.dump();
}

std::string change_line(const SimulationTime& when, const WatchReport& before, const WatchReport& now) {
  Json line = {{"step", when.step}, {"time", when.time}, {"event", "change"}};
  line["verdict"] = name(now.verdict);
  if (!now.reason.empty()) line["reason"] = now.reason;
  line["broken"] = list(without(before.bonds, now.bonds));
  line["formed"] = list(without(now.bonds, before.bonds));
  line["repelled"] = without(now.repelled, before.repelled);
  line["returned"] = without(before.repelled, now.repelled);
  line["lost"] = without(now.lost, before.lost);
  line["since_start"] = {{"broken", now.changes.broken.size()},
                         {"formed", now.changes.formed.size()},
                         {"repelled", now.repelled.size()},
                         {"lost", now.lost.size()}};
  add_topology(line, now.topology);
  return line.dump();
}

WatchFigures figures(const WatchReport& report) {
  const topology::SurfaceTopology& topology = report.topology;
  const double unknown = std::numeric_limits<double>::quiet_NaN();
  const auto of_surface = [&](double value) { return topology.problem ? unknown : value; };
  return {static_cast<double>(report.verdict),
          {static_cast<double>(report.repelled.size()), static_cast<double>(report.changes.broken.size()),
           static_cast<double>(report.changes.formed.size()), static_cast<double>(topology.components.size()),
           of_surface(topology.euler_characteristic), of_surface(topology.genus),
           of_surface(topology.boundary_loops), of_surface(rings_of(topology, 5)),
           of_surface(rings_of(topology, 6)), of_surface(rings_of(topology, 7)),
           of_surface(other_rings(topology)), of_surface(topology.orientable ? 1.0 : 0.0)}};
}

std::string summary(const std::string& title, const SimulationTime& when, const WatchReport& report) {
  const topology::SurfaceTopology& topology = report.topology;
  std::string text =
      title + ": " + std::string(name(report.verdict)) + " at step " + std::to_string(when.step);
  if (!report.reason.empty()) text.append(" (").append(report.reason).append(")");
  text += "\n  since the start: " + counted(report.changes.broken.size(), "bond") + " broken, " +
          std::to_string(report.changes.formed.size()) + " formed, " +
          counted(report.repelled.size(), "atom") + " repelled, " + std::to_string(report.lost.size()) +
          " of them lost\n";
  text +=
      "  now: " + counted(report.bonds.size(), "bond") + ", " + counted(topology.components.size(), "piece");
  if (topology.problem) {
    text += ", no surface\n";
    return text;
  }
  text += ", Euler characteristic " + std::to_string(topology.euler_characteristic) + ", " +
          (topology.orientable ? "orientable, genus " : "not orientable, cross-caps or genus ") +
          std::to_string(topology.genus) + ", " + counted(topology.boundary_loops, "boundary loop") + "\n";
  text += "  rings: " + std::to_string(rings_of(topology, 5)) + " of 5, " +
          std::to_string(rings_of(topology, 6)) + " of 6, " + std::to_string(rings_of(topology, 7)) +
          " of 7, " + std::to_string(other_rings(topology)) + " other\n";
  return text;
}

}  // namespace nanocarbon
