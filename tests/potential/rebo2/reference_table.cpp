// SPDX-License-Identifier: GPL-2.0-or-later
#include "potential/rebo2/reference_table.h"

#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace nanocarbon::test {

namespace {

using nlohmann::json;

json vectors(const std::vector<Vec3>& points, double unit) {
  json rows = json::array();
  for (const Vec3& p : points) {
    json row = json::array();
    // Whole multiples of a unit: short in the file, and read back to the same double.
    for (const double x : p) row.push_back(std::llround(x / unit));
    rows.push_back(std::move(row));
  }
  return rows;
}

std::vector<Vec3> read_vectors(const json& rows, double units_in_one) {
  std::vector<Vec3> points;
  for (const json& row : rows)
    points.emplace_back(row[0].get<double>() / units_in_one, row[1].get<double>() / units_in_one,
                        row[2].get<double>() / units_in_one);
  return points;
}

constexpr double position_units = 1e4;  // per Angstrom
constexpr double force_units = 1e11;    // per eV/Angstrom

}  // namespace

std::vector<ReferenceEntry> read_reference_table(const std::filesystem::path& path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error("cannot open " + path.string());
  std::vector<ReferenceEntry> entries;
  const json table = json::parse(file);
  for (const json& item : table["structures"]) {
    ReferenceEntry entry;
    entry.name = item["name"];
    entry.molecule.positions = read_vectors(item["positions"], position_units);
    for (const char symbol : item["elements"].get<std::string>())
      entry.molecule.elements.push_back(*element_from_symbol(std::string_view(&symbol, 1)));
    if (item.contains("cell")) {
      Cell cell;
      for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c) cell.vectors(r, c) = item["cell"][3 * r + c];
      cell.periodic = item["periodic"].get<std::array<bool, 3>>();
      entry.molecule.cell = cell;
    }
    entry.energy = item["energy"];
    entry.forces = read_vectors(item["forces"], force_units);
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 3; ++c) entry.virial(r, c) = item["virial"][3 * r + c];
    entry.atom_energies = item["atom_energies"].get<std::vector<double>>();
    entries.push_back(std::move(entry));
  }
  return entries;
}

void write_reference_table(const std::filesystem::path& path, const std::vector<ReferenceEntry>& entries) {
  std::ofstream file(path);
  file << R"({"units": "eV, Angstrom; positions in 1e-4 Angstrom, forces in 1e-11 eV/Angstrom",)" << '\n'
       << R"("source": "LAMMPS 29 Sep 2021, pair_style rebo, CH.rebo; written by write_rebo2_reference",)"
       << '\n'
       << "\"structures\": [\n";
  for (std::size_t n = 0; n < entries.size(); ++n) {
    const ReferenceEntry& entry = entries[n];
    std::string elements;
    for (const Element e : entry.molecule.elements) elements += symbol(e);
    json item = {{"name", entry.name},
                 {"elements", elements},
                 {"positions", vectors(entry.molecule.positions, 1.0 / position_units)},
                 {"energy", entry.energy},
                 {"forces", vectors(entry.forces, 1.0 / force_units)},
                 {"virial", json::array()},
                 {"atom_energies", entry.atom_energies}};
    if (const auto& cell = entry.molecule.cell) {
      item["cell"] = json::array();
      for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c) item["cell"].push_back(cell->vectors(r, c));
      item["periodic"] = cell->periodic;
    }
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 3; ++c) item["virial"].push_back(entry.virial(r, c));
    file << item.dump() << (n + 1 < entries.size() ? ",\n" : "\n");
  }
  file << "]}\n";
  if (!file.flush()) throw std::runtime_error("cannot write " + path.string());
}

}  // namespace nanocarbon::test
