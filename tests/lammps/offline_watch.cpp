// SPDX-License-Identifier: GPL-2.0-or-later
#include "lammps/offline_watch.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>

#include "lammps/lammps_run.h"
#include "nanocarbon/molecule/molecule_graph.h"
#include "nanocarbon/topology/bond_graph.h"
#include "nanocarbon/topology/surface_topology.h"

namespace nanocarbon::test {
namespace {

using nlohmann::json;

json pairs(const std::vector<Bond>& bonds) {
  json result = json::array();
  for (const Bond& bond : bonds) result.push_back({bond.first + 1, bond.second + 1});
  return result;
}

std::vector<Bond> without_images(std::vector<Bond> bonds) {
  for (Bond& bond : bonds) bond.image = {0, 0, 0};
  std::sort(bonds.begin(), bonds.end());
  return bonds;
}

std::vector<Bond> difference(const std::vector<Bond>& bonds, const std::vector<Bond>& others) {
  std::vector<Bond> result;
  std::set_difference(bonds.begin(), bonds.end(), others.begin(), others.end(), std::back_inserter(result));
  return result;
}

json difference_of_ids(const std::vector<bool>& marked, const std::vector<bool>& others) {
  json result = json::array();
  for (std::size_t a = 0; a < marked.size(); ++a)
    if (marked[a] && !others[a]) result.push_back(a + 1);
  return result;
}

void add_surface(json& line, const topology::SurfaceTopology& surface) {
  line["pieces"] = surface.components.size();
  line["surface"] = !surface.problem.has_value();
  if (surface.problem) return;
  line["euler_characteristic"] = surface.euler_characteristic;
  line["orientable"] = surface.orientable;
  line["genus"] = surface.genus;
  line["boundary_loops"] = surface.boundary_loops;
  line["rings"] = json::object();
  for (std::size_t size = 0; size < surface.ring_counts.size(); ++size)
    if (surface.ring_counts[size] > 0) line["rings"][std::to_string(size)] = surface.ring_counts[size];
}

}  // namespace

std::vector<Frame> read_trajectory(const std::string& path, std::array<bool, 3> periodic) {
  std::vector<Frame> frames;
  const std::vector<std::string> lines = lines_of(path);
  for (std::size_t at = 0; at + 9 <= lines.size();) {
    Frame frame;
    frame.step = std::stol(lines[at + 1]);
    const std::size_t atoms = std::stoul(lines[at + 3]);
    Vec3 low, high;
    for (int axis = 0; axis < 3; ++axis) std::istringstream(lines[at + 5 + axis]) >> low[axis] >> high[axis];
    Cell cell = orthogonal_cell(high - low, periodic);
    cell.origin = low;
    frame.atoms.cell = cell;
    frame.atoms.positions.resize(atoms);
    frame.atoms.elements.assign(atoms, Element::carbon);
    for (std::size_t k = 0; k < atoms; ++k) {
      std::size_t id = 0;
      int type = 0;
      Vec3 place;
      std::istringstream(lines[at + 9 + k]) >> id >> type >> place[0] >> place[1] >> place[2];
      if (id < 1 || id > atoms) throw std::runtime_error(path + ": an atom is missing");
      frame.atoms.positions[id - 1] = place;
    }
    frames.push_back(std::move(frame));
    at += 9 + atoms;
  }
  return frames;
}

std::vector<json> expected_lines(const std::vector<Frame>& frames) {
  std::vector<json> lines;
  std::vector<Bond> start, before;
  topology::SurfaceTopology first;
  std::vector<bool> repelled_before;
  for (const Frame& frame : frames) {
    Molecule molecule = frame.atoms;
    molecule.bonds =
        topology::bonds_within(molecule.positions, molecule.elements, &*molecule.cell, {}, before);
    const std::vector<Bond> previous = without_images(std::exchange(before, molecule.bonds));
    const std::vector<Bond> bonds = without_images(molecule.bonds);
    const topology::SurfaceTopology surface = topology::surface_topology(molecule::embedded_graph(molecule));
    json line = {{"step", frame.step}};
    if (lines.empty()) {
      line["event"] = "start";
      line["atoms"] = molecule.size();
      line["bonds"] = bonds.size();
      start = bonds;
      first = surface;
      repelled_before.assign(molecule.size(), false);
    } else {
      if (bonds == previous) continue;
      const std::vector<bool> repelled =
          topology::repelled_atoms(first.component_of_atom, surface.component_of_atom);
      line["event"] = "change";
      line["verdict"] = name(topology::judge(first, surface, bonds == start).verdict);
      line["broken"] = pairs(difference(previous, bonds));
      line["formed"] = pairs(difference(bonds, previous));
      line["repelled"] = difference_of_ids(repelled, repelled_before);
      line["returned"] = difference_of_ids(repelled_before, repelled);
      line["lost"] = json::array();
      line["since_start"] = {{"broken", difference(start, bonds).size()},
                             {"formed", difference(bonds, start).size()},
                             {"repelled", std::count(repelled.begin(), repelled.end(), true)},
                             {"lost", 0}};
      repelled_before = repelled;
    }
    add_surface(line, surface);
    lines.push_back(std::move(line));
  }
  return lines;
}

std::vector<json> parsed(const std::vector<std::string>& lines) {
  std::vector<json> result;
  for (const std::string& line : lines) {
    json object = json::parse(line);
    object.erase("time");
    object.erase("reason");
    result.push_back(std::move(object));
  }
  return result;
}

}  // namespace nanocarbon::test
