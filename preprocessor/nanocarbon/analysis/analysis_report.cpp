// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/analysis/analysis_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>

namespace nanocarbon::analysis {
namespace {

using Json = nlohmann::ordered_json;

Json counts_json(std::span<const std::uint64_t> counts) {
  Json json = Json::object();
  for (std::size_t size = 0; size < counts.size(); ++size)
    if (counts[size] > 0) json[std::to_string(size)] = counts[size];
  return json;
}

Json distribution_json(const Distribution& d) {
  if (d.spread.count == 0) return nullptr;
  return {{"count", d.spread.count},
          {"min", d.spread.min},
          {"mean", d.spread.mean},
          {"max", d.spread.max},
          {"standard_deviation", d.spread.deviation},
          {"histogram",
           {{"from", d.histogram.from}, {"width", d.histogram.width}, {"counts", d.histogram.counts}}}};
}

// Writes lists of atoms by their names, without a tree for each.
class NamedLists {
 public:
  NamedLists(JsonWriter& json, std::span<const std::int64_t> ids) : json_(json), ids_(ids) {}
  void write(std::span<const AtomIndex> atoms) {
    names_.clear();
    for (const AtomIndex a : atoms) names_.push_back(ids_[a]);
    json_.numbers(names_);
  }

 private:
  JsonWriter& json_;
  std::span<const std::int64_t> ids_;
  std::vector<std::int64_t> names_;
};

void write(JsonWriter& json, std::string_view key, const Json& value) {
  json.key(key);
  json.value(value);
}

Json statistics_json(std::span<const std::uint64_t> counts, std::size_t atoms) {
  Json per_atom = Json::object();
  for (std::size_t size = 0; size < counts.size(); ++size)
    if (counts[size] > 0)
      per_atom[std::to_string(size)] = static_cast<double>(counts[size]) / static_cast<double>(atoms);
  return {{"by_size", counts_json(counts)}, {"per_atom", per_atom}};
}

void write_rings(JsonWriter& json, const MoleculeComponents& components, std::span<const std::int64_t> ids) {
  json.key("rings");
  json.begin_object();
  write(json, "by_size", counts_json(components.ring_counts));
  if (!components.king_counts.empty()) {
    write(json, "atoms_searched", components.atoms_searched);
    write(json, "king", statistics_json(components.king_counts, components.atoms_searched));
    write(json, "primitive", statistics_json(components.primitive_counts, components.atoms_searched));
  }
  if (!components.rings_not_counted.empty()) write(json, "not_counted", components.rings_not_counted);
  json.key("atoms");
  json.begin_list();
  NamedLists lists(json, ids);
  for (std::size_t r = 0; r < components.rings.size(); ++r) lists.write(components.rings[r]);
  json.end();
  json.end();
}

void write_components(JsonWriter& json, const MoleculeComponents& components,
                      std::span<const std::int64_t> ids) {
  json.key("pieces");
  json.begin_list();
  for (const MoleculeComponent& component : components.list) {
    Json item = {{"atoms", component.atoms},
                 {"first_atom", ids[component.first]},
                 {"surface", component.is_surface()}};
    if (component.is_surface()) {
      item["has_rings"] = component.topology.has_rings;
      item["euler_characteristic"] = component.topology.euler_characteristic();
      item["orientable"] = component.topology.orientable;
      item["genus"] = component.topology.genus;
      item["boundary_loops"] = component.topology.boundary_loops;
    } else {
      item["reason"] = component.not_a_surface;
    }
    item["rings"] = name(component.rings);
    json.value(item);
  }
  json.end();
}

std::map<std::string, std::size_t> kinds_of(std::span<const Defect> defects) {
  std::map<std::string, std::size_t> kinds;
  for (const Defect& defect : defects) ++kinds[defect.kind];
  return kinds;
}

// The lines of a table. Amorphous carbon has clusters of nearly any number of rings: beyond some, they share a line.
std::map<std::string, std::string> lines_of(std::span<const Defect> defects) {
  constexpr std::size_t most_clusters = 6;
  std::map<std::string, std::size_t> kinds, clusters;
  std::size_t all = 0, fewest = std::numeric_limits<std::size_t>::max(), most = 0;
  for (const Defect& defect : defects) {
    const bool cluster = defect.kind.starts_with("cluster of ");
    ++(cluster ? clusters : kinds)[defect.kind];
    if (!cluster) continue;
    ++all;
    fewest = std::min(fewest, defect.ring_sizes.size());
    most = std::max(most, defect.ring_sizes.size());
  }
  std::map<std::string, std::string> lines;
  if (clusters.size() > most_clusters)
    lines["clusters of rings"] = fmt::format("{}, of {} to {} rings each", all, fewest, most);
  else
    kinds.merge(clusters);
  for (const auto& [kind, count] : kinds) lines[kind] = std::to_string(count);
  return lines;
}

// Where the defects are, if they are few.
std::vector<std::string> places_of(std::span<const Defect> defects, std::span<const std::int64_t> ids) {
  constexpr std::size_t most_defects = 10, most_atoms = 6;
  if (defects.size() > most_defects) return {"(where they are: --json, --xyz, --page)"};
  std::vector<std::string> places;
  for (const Defect& defect : defects) {
    std::vector<std::int64_t> names;
    for (const AtomIndex a : std::span(defect.atoms).first(std::min(defect.atoms.size(), most_atoms)))
      names.push_back(ids[a]);
    places.push_back(fmt::format("{} at {:.2f} {:.2f} {:.2f}: atom IDs {}{}", defect.kind,
                                 defect.position.x(), defect.position.y(), defect.position.z(),
                                 fmt::join(names, ", "), defect.atoms.size() > most_atoms ? ", ..." : ""));
  }
  return places;
}

std::string cell_text(const Molecule& molecule, const BondDistributions& bonds) {
  if (!molecule.cell) {
    const std::size_t open = bonds.with(0) + bonds.with(1) + bonds.with(2);
    return open == 0 ? "none: free space"
                     : fmt::format(
                           "none: free space ({} carbon atoms have fewer than three bonds; if a box was "
                           "periodic, its cell is missing)",
                           open);
  }
  const Cell& cell = *molecule.cell;
  std::string ways;
  for (std::size_t d = 0; d < 3; ++d)
    if (cell.periodic[d]) ways += "abc"[d];
  const Vec3 edges = cell.vectors.colwise().norm();
  return fmt::format("{:.5g} x {:.5g} x {:.5g} A, periodic along {}", edges[0], edges[1], edges[2],
                     fmt::join(ways, ", "));
}

void write_defects(JsonWriter& json, std::span<const Defect> defects, std::span<const std::int64_t> ids) {
  json.key("defects");
  json.begin_object();
  write(json, "count", defects.size());
  write(json, "by_kind", kinds_of(defects));
  json.key("list");
  json.begin_list();
  NamedLists lists(json, ids);
  for (const Defect& defect : defects) {
    json.begin_object();
    write(json, "kind", defect.kind);
    write(json, "ring_sizes", defect.ring_sizes);
    write(json, "rings", defect.rings);
    json.key("atoms");
    lists.write(defect.atoms);
    write(json, "position", {defect.position.x(), defect.position.y(), defect.position.z()});
    json.end();
  }
  json.end();
  json.end();
}

Json cell_json(const Molecule& molecule) {
  if (!molecule.cell) return nullptr;
  Json vectors = Json::array();
  for (int d = 0; d < 3; ++d) {
    const Vec3 edge = molecule.cell->vectors.col(d);
    vectors.push_back({edge.x(), edge.y(), edge.z()});
  }
  return {{"vectors", vectors}, {"periodic", molecule.cell->periodic}};
}

template <typename Count>
std::string listed(std::span<const Count> counts) {
  std::string text;
  for (std::size_t size = 0; size < counts.size(); ++size)
    if (counts[size] > 0) text += fmt::format("{}{}: {}", text.empty() ? "" : ", ", size, counts[size]);
  return text.empty() ? "none" : text;
}

std::string per_atom(std::span<const std::uint64_t> counts, std::size_t atoms) {
  std::string text;
  for (std::size_t size = 0; size < counts.size(); ++size)
    if (counts[size] > 0)
      text += fmt::format("{}{}: {:.4g}", text.empty() ? "" : ", ", size,
                          static_cast<double>(counts[size]) / static_cast<double>(atoms));
  return text.empty() ? "none" : text;
}

std::string topology_text(const MoleculeComponent& component) {
  if (!component.is_surface()) return "no surface: " + component.not_a_surface;
  if (!component.topology.has_rings) return "no rings";
  return fmt::format("{}, genus {}, Euler characteristic {}, {} boundary loop{}",
                     component.topology.orientable ? "orientable" : "one-sided", component.topology.genus,
                     component.topology.euler_characteristic(), component.topology.boundary_loops,
                     component.topology.boundary_loops == 1 ? "" : "s");
}

}  // namespace

FrameSummary summarise(const Molecule& molecule, const Analysis& analysis) {
  FrameSummary frame;
  frame.atoms = molecule.size();
  frame.bonds = molecule.bonds.size();
  frame.components = analysis.components.list.size();
  frame.ring_counts = analysis.components.ring_counts;
  for (std::size_t k = 0; k < 3; ++k) frame.hybridisation[k] = analysis.bonds.share_with(k + 2);
  frame.bond_mean = analysis.bonds.carbon_carbon.spread.mean;
  frame.defects = analysis.defects.size();
  frame.energy = analysis.energy;
  return frame;
}

void write_analysis_json(JsonWriter& json, const Molecule& molecule, std::span<const std::int64_t> ids,
                         const Analysis& analysis) {
  const BondDistributions& b = analysis.bonds;
  const MoleculeComponents& p = analysis.components;
  write(json, "atoms", molecule.size());
  write(json, "carbons", b.carbons);
  write(json, "hydrogens", b.hydrogens);
  write(json, "cell", cell_json(molecule));
  json.key("bonds");
  json.begin_object();
  write(json, "C-C", distribution_json(b.carbon_carbon));
  write(json, "C-H", distribution_json(b.carbon_hydrogen));
  write(json, "H-H", distribution_json(b.hydrogen_hydrogen));
  json.end();
  write(json, "angles", distribution_json(b.angles));
  Json coordination = Json::object();
  for (std::size_t n = 0; n < b.carbons_with.size(); ++n)
    if (b.carbons_with[n] > 0) coordination[std::to_string(n)] = b.carbons_with[n];
  write(json, "coordination", coordination);
  write(json, "hybridisation", {{"sp", b.share_with(2)}, {"sp2", b.share_with(3)}, {"sp3", b.share_with(4)}});
  write(json, "surface", p.all_surfaces());
  if (p.all_surfaces() && !p.surface.problem) {
    write(json, "euler_characteristic", p.surface.euler_characteristic);
    write(json, "orientable", p.surface.orientable);
    write(json, "genus", p.surface.genus);
    write(json, "boundary_loops", p.surface.boundary_loops);
  }
  write_rings(json, p, ids);
  write_components(json, p, ids);
  write_defects(json, analysis.defects, ids);
  write(json, "pyramidalisation", distribution_json(analysis.pyramidalisation));
  write(json, "mean_curvature", distribution_json(analysis.mean_curvature));
  write(json, "gaussian_curvature", distribution_json(analysis.gaussian_curvature));
  if (analysis.energy)
    write(json, "energy",
          {{"potential", analysis.potential},
           {"total", *analysis.energy},
           {"per_atom", *analysis.energy / static_cast<double>(molecule.size())}});
}

void write_frame_json(JsonWriter& json, const FrameSummary& frame) {
  const FrameChange& c = frame.change;
  const auto bonds = [&](std::string_view key, std::span<const topology::BondedIds> list) {
    json.key(key);
    json.begin_list();
    for (const topology::BondedIds& bond : list) json.numbers(std::array{bond.first, bond.second});
    json.end();
  };
  const auto atoms = [&](std::string_view key, std::span<const std::int64_t> list) {
    json.key(key);
    json.numbers(list);
  };
  json.begin_object();
  write(json, "file", frame.file);
  write(json, "frame", frame.frame);
  if (frame.step) write(json, "step", *frame.step);
  write(json, "atoms", frame.atoms);
  write(json, "bonds", frame.bonds);
  write(json, "pieces", frame.components);
  write(json, "rings", counts_json(frame.ring_counts));
  write(json, "defects", frame.defects);
  write(json, "mean_bond", frame.bond_mean);
  write(json, "verdict", topology::name(c.verdict));
  if (!c.reason.empty()) write(json, "reason", c.reason);
  bonds("broken", c.changes.broken);
  bonds("formed", c.changes.formed);
  atoms("repelled", c.repelled);
  atoms("lost", c.lost);
  atoms("added", c.added);
  if (frame.energy) write(json, "energy", *frame.energy);
  json.end();
}

std::string analysis_table(const Molecule& molecule, std::span<const std::int64_t> ids,
                           const Analysis& analysis) {
  constexpr std::size_t most_lines = 8;
  const BondDistributions& b = analysis.bonds;
  const MoleculeComponents& p = analysis.components;
  std::string table;
  const auto line = [&](std::string_view title, const std::string& value) {
    table += fmt::format("  {:<26}{}\n", title, value);
  };
  line("atoms", fmt::format("{}: {} carbon, {} hydrogen", molecule.size(), b.carbons, b.hydrogens));
  line("cell", cell_text(molecule, b));
  const auto lengths = [&](const char* title, const Distribution& d) {
    if (d.spread.count > 0)
      line(title, fmt::format("{}; {:.3f} to {:.3f}, mean {:.4f}, deviation {:.4f}", d.spread.count,
                              d.spread.min, d.spread.max, d.spread.mean, d.spread.deviation));
  };
  lengths("C-C bonds, A", b.carbon_carbon);
  lengths("C-H bonds, A", b.carbon_hydrogen);
  lengths("H-H bonds, A", b.hydrogen_hydrogen);
  if (b.angles.spread.count > 0)
    line("angles, degrees",
         fmt::format("{:.1f} to {:.1f}, mean {:.2f}, deviation {:.2f}", b.angles.spread.min,
                     b.angles.spread.max, b.angles.spread.mean, b.angles.spread.deviation));
  line("carbons by bonds", listed<std::size_t>(b.carbons_with));
  line("sp, sp2, sp3", fmt::format("{:.2f}%, {:.2f}%, {:.2f}%", 100 * b.share_with(2), 100 * b.share_with(3),
                                   100 * b.share_with(4)));
  const std::string sizes = listed<std::uint64_t>(p.ring_counts);
  line("rings by size",
       sizes == "none" ? fmt::format("none of up to {} atoms", p.ring_counts.size() - 1) : sizes);
  if (!p.king_counts.empty()) {
    line("King's rings an atom", per_atom(p.king_counts, p.atoms_searched));
    line("primitive rings an atom", per_atom(p.primitive_counts, p.atoms_searched));
  }
  if (!p.rings_not_counted.empty()) line("rings", p.rings_not_counted);
  std::vector<std::size_t> order(p.list.size());
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t x, std::size_t y) { return p.list[x].atoms > p.list[y].atoms; });
  line("pieces", std::to_string(p.list.size()));
  for (std::size_t k = 0; k < std::min(order.size(), most_lines); ++k) {
    const MoleculeComponent& component = p.list[order[k]];
    line(fmt::format("  from atom ID {}", ids[component.first]),
         fmt::format("{} atoms; {}", component.atoms, topology_text(component)));
  }
  if (order.size() > most_lines) line("  ...", fmt::format("and {} smaller ones", order.size() - most_lines));
  line("defects", std::to_string(analysis.defects.size()));
  for (const auto& [kind, value] : lines_of(analysis.defects)) line("  " + kind, value);
  for (const std::string& place : places_of(analysis.defects, ids)) table += "    " + place + "\n";
  const auto values = [&](const char* title, const Distribution& d) {
    if (d.spread.count > 0)
      line(title, fmt::format("{:.4g} to {:.4g}, mean {:.4g}, deviation {:.4g}", d.spread.min, d.spread.max,
                              d.spread.mean, d.spread.deviation));
  };
  values("pyramidalisation, deg", analysis.pyramidalisation);
  values("mean curvature, 1/A", analysis.mean_curvature);
  values("Gaussian curvature, 1/A2", analysis.gaussian_curvature);
  if (analysis.energy)
    line("energy, eV/atom",
         fmt::format("{:.5f} ({})", *analysis.energy / static_cast<double>(molecule.size()),
                     analysis.potential));
  return table;
}

std::string frames_csv(std::span<const FrameSummary> frames) {
  std::string text =
      "file,frame,step,atoms,bonds,pieces,verdict,broken,formed,repelled,lost,sp,sp2,sp3,rings_3,rings_4,"
      "rings_5,"
      "rings_6,rings_7,rings_8,rings_larger,defects,mean_bond,energy\n";
  for (const FrameSummary& f : frames) {
    const auto rings = [&](std::size_t size) {
      return size < f.ring_counts.size() ? f.ring_counts[size] : 0;
    };
    std::uint64_t larger = 0;
    for (std::size_t size = 9; size < f.ring_counts.size(); ++size) larger += f.ring_counts[size];
    std::string file = f.file;
    if (file.find_first_of(",\"\n") != std::string::npos) {
      std::string quoted = "\"";
      for (const char c : file) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
      file = quoted + "\"";
    }
    text += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},", file, f.frame,
                        f.step ? std::to_string(*f.step) : "", f.atoms, f.bonds, f.components,
                        topology::name(f.change.verdict), f.change.changes.broken.size(),
                        f.change.changes.formed.size(), f.change.repelled.size(), f.change.lost.size(),
                        f.hybridisation[0], f.hybridisation[1], f.hybridisation[2]);
    for (std::size_t size = 3; size <= 8; ++size) text += fmt::format("{},", rings(size));
    text += fmt::format("{},{},{},{}\n", larger, f.defects, f.bond_mean,
                        f.energy ? fmt::format("{}", *f.energy) : "");
  }
  return text;
}

}  // namespace nanocarbon::analysis
