// SPDX-License-Identifier: GPL-2.0-or-later
#include "potential/airebo/reference.h"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

namespace nanocarbon::test {

namespace {

std::vector<Vec3> vectors(const nlohmann::json& numbers) {
  std::vector<Vec3> result;
  for (std::size_t i = 0; i + 2 < numbers.size(); i += 3)
    result.emplace_back(numbers[i].get<double>(), numbers[i + 1].get<double>(), numbers[i + 2].get<double>());
  return result;
}

Molecule read_molecule(const nlohmann::json& entry) {
  Molecule m;
  m.positions = vectors(entry.at("positions"));
  for (const char c : entry.at("elements").get<std::string>())
    m.elements.push_back(c == 'C' ? Element::carbon : Element::hydrogen);
  Cell cell;
  for (int d = 0; d < 3; ++d) {
    const double low = entry.at("box")[d][0], high = entry.at("box")[d][1];
    cell.origin[d] = low;
    cell.vectors(d, d) = high - low;
    cell.periodic[d] = entry.at("periodic")[d].get<bool>();
  }
  if (cell.periodic[0] || cell.periodic[1] || cell.periodic[2]) m.cell = cell;
  return m;
}

}  // namespace

std::vector<AireboReferenceStructure> airebo_reference() {
  std::ifstream file(NANOCARBON_AIREBO_REFERENCE);
  std::vector<AireboReferenceStructure> structures;
  for (const nlohmann::json& entry : nlohmann::json::parse(file)) {
    AireboReferenceStructure s = {entry.at("name").get<std::string>(), read_molecule(entry), {}};
    for (const auto& [style, values] : entry.at("styles").items()) {
      const auto& v = values.at("virial");
      AireboReference r = {style, values.at("rebo"), values.at("lj"), values.at("torsion"), {}, {}};
      r.virial << v[0], v[3], v[4], v[3], v[1], v[5], v[4], v[5], v[2];
      if (values.contains("forces")) r.forces = vectors(values.at("forces"));
      s.references.push_back(std::move(r));
    }
    structures.push_back(std::move(s));
  }
  return structures;
}

AireboStyle airebo_style(const std::string& style) {
  std::istringstream words(style);
  std::string name;
  AireboStyle result = {&airebo::airebo_parameters(), {}};
  words >> name >> result.terms.cutoff;
  if (name.find("morse") != std::string::npos) result.parameters = &airebo::airebo_m_parameters();
  int long_range = 1, torsion = 1;
  if (words >> long_range >> torsion) {
    result.terms.long_range = long_range != 0;
    result.terms.torsion = torsion != 0;
    if (words >> result.terms.switch_begin)
      result.terms.switch_end = result.terms.cutoff;
    else
      result.terms.switch_begin = airebo::AireboTerms().switch_begin;
  }
  return result;
}

bool is_in_switches(const std::string& name) {
  constexpr std::array names = {
      "soup",          "stretched_benzene",    "methyl_pair",     "methane_dimer_30",
      "c60_pair_9",    "cyclopropane",         "acetylene_dimer", "graphite_rattled",
      "onion_rattled", "polyethylene_rattled", "random_cluster",  "radicals"};
  return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace nanocarbon::test
