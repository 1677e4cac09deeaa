// SPDX-License-Identifier: GPL-2.0-or-later
#include "support/lammps_reference.h"

#include <mpi.h>

#include <algorithm>
#include <cstdio>
#include <initializer_list>
#include <stdexcept>

#define LAMMPS_LIB_MPI  // for lammps_open with a communicator
#include "library.h"
#ifdef NANOCARBON_PLUGIN_FILE
#include "host/plugin_command.h"
#endif

namespace nanocarbon::test {

namespace {

//! A command's word, then numbers.
std::string words(std::string text, std::initializer_list<double> numbers) {
  for (const double number : numbers) {
    char buffer[40];
    std::snprintf(buffer, sizeof buffer, " %.17g", number);
    text.append(buffer);
  }
  return text;
}

Mat3 symmetric(const double* v) {
  Mat3 m;
  m << v[0], v[3], v[4], v[3], v[1], v[5], v[4], v[5], v[2];
  return m;
}

}  // namespace

LammpsReference::LammpsReference([[maybe_unused]] bool with_plugin) : with_plugin_(with_plugin) {
  const char* arguments[] = {"lammps", "-log", "none", "-screen", "none", "-nocite"};
  lammps_ = lammps_open(6, const_cast<char**>(arguments), MPI_COMM_SELF, nullptr);
  if (!lammps_) throw std::runtime_error("cannot start LAMMPS");
}

LammpsReference::~LammpsReference() { lammps_close(lammps_); }

void LammpsReference::command(const std::string& text) {
  lammps_commands_string(lammps_, text.c_str());
  if (lammps_has_error(lammps_)) {
    char message[1000];
    lammps_get_last_error_message(lammps_, message, sizeof message);
    throw std::runtime_error(message);
  }
}

void LammpsReference::place(std::span<const Vec3> positions, std::span<const Element> elements,
                            const Cell* cell) {
  command("clear");
#ifdef NANOCARBON_PLUGIN_FILE
  if (with_plugin_) {
    add_plugin_command(*static_cast<LAMMPS_NS::LAMMPS*>(lammps_));
    command("plugin load " NANOCARBON_PLUGIN_FILE);
  }
#endif
  command("units metal\natom_style atomic\natom_modify map array sort 0 0\nnewton on");
  Vec3 low = Vec3::Zero(), high = Vec3::Zero();
  if (cell) {
    std::string boundary = "boundary";
    for (const bool periodic : cell->periodic) boundary += periodic ? " p" : " f";
    command(boundary);
    const Mat3& m = cell->vectors;
    command("box tilt large");
    command(words("region box prism", {0.0, m(0, 0), 0.0, m(1, 1), 0.0, m(2, 2), m(0, 1), m(0, 2), m(1, 2)}) +
            " units box");
  } else {
    for (const Vec3& p : positions) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    command("boundary f f f");
    command(words("region box block", {low.x() - 15.0, high.x() + 15.0, low.y() - 15.0, high.y() + 15.0,
                                       low.z() - 15.0, high.z() + 15.0}) +
            " units box");
  }
  command("create_box 2 box\nmass 1 12.011\nmass 2 1.008");
  std::vector<int> ids, types;
  std::vector<double> x;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    ids.push_back(static_cast<int>(i) + 1);
    types.push_back(elements[i] == Element::carbon ? 1 : 2);
    const Vec3 p = cell ? Vec3(positions[i] - cell->origin) : positions[i];
    x.insert(x.end(), p.begin(), p.end());
  }
  atoms_ = positions.size();
  const int made = lammps_create_atoms(lammps_, static_cast<int>(atoms_), ids.data(), types.data(), x.data(),
                                       nullptr, nullptr, 0);
  if (made != static_cast<int>(atoms_)) throw std::runtime_error("LAMMPS took only some of the atoms");
  volume_ = cell ? volume(*cell) : (high - low + Vec3::Constant(30.0)).prod();
}

void LammpsReference::potential(const std::string& style) {
  style_ = style.substr(0, style.find(' '));
  // All of them stand in one folder.
  std::string file = NANOCARBON_CH_REBO;
  if (style_.starts_with("airebo"))
    file.replace(file.rfind("CH."), std::string::npos,
                 style_.starts_with("airebo/morse") ? "CH.airebo-m" : "CH.airebo");
  command("pair_style " + style + "\npair_coeff * * " + file + " C H");
}

LammpsEnergy LammpsReference::evaluate(bool atom_virials, bool atom_energies) {
  command(
      "neighbor 0.5 bin\nvariable pe equal pe\ncompute virial all pressure NULL virial\n"
      "compute parts all pair " +
      style_);
  if (atom_energies) command("compute peatom all pe/atom\ncompute sum_e all reduce sum c_peatom");
  if (atom_virials)
    command("compute stress all stress/atom NULL pair\ncompute sum_s all reduce sum c_stress[1]");
  // Only what the thermodynamic output asks for is up to date after a run.
  command(std::string("thermo_style custom step pe c_virial[1] c_parts[1]") +
          (atom_energies ? " c_sum_e" : "") + (atom_virials ? " c_sum_s" : "") + "\nrun 0");
  LammpsEnergy result;
  result.energy = *static_cast<double*>(lammps_extract_variable(lammps_, "pe", nullptr));
  const double to_ev = volume_ / *static_cast<double*>(lammps_extract_global(lammps_, "nktv2p"));
  const auto* pressure = static_cast<double*>(lammps_extract_compute(lammps_, "virial", 0, 1));
  result.virial = to_ev * symmetric(pressure);
  const auto* parts = static_cast<double*>(lammps_extract_compute(lammps_, "parts", 0, 1));
  std::copy_n(parts, 3, result.parts.begin());
  std::vector<double> forces(3 * atoms_);
  lammps_gather_atoms(lammps_, const_cast<char*>("f"), 1, 3, forces.data());
  const auto* tags = static_cast<int*>(lammps_extract_atom(lammps_, "id"));
  for (std::size_t i = 0; i < atoms_; ++i)
    result.forces.emplace_back(forces[3 * i], forces[3 * i + 1], forces[3 * i + 2]);
  if (atom_energies) {
    const auto* energies = static_cast<double*>(lammps_extract_compute(lammps_, "peatom", 1, 1));
    result.atom_energies.resize(atoms_);
    for (std::size_t i = 0; i < atoms_; ++i) result.atom_energies[tags[i] - 1] = energies[i];
  }
  if (atom_virials) {
    const double unit = 1.0 / *static_cast<double*>(lammps_extract_global(lammps_, "nktv2p"));
    auto** stress = static_cast<double**>(lammps_extract_compute(lammps_, "stress", 1, 2));
    result.atom_virials.resize(atoms_);
    for (std::size_t i = 0; i < atoms_; ++i) result.atom_virials[tags[i] - 1] = -unit * symmetric(stress[i]);
  }
  return result;
}

std::vector<Vec3> LammpsReference::positions() {
  std::vector<double> x(3 * atoms_);
  lammps_gather_atoms(lammps_, const_cast<char*>("x"), 1, 3, x.data());
  std::vector<Vec3> result;
  for (std::size_t i = 0; i < atoms_; ++i) result.emplace_back(x[3 * i], x[3 * i + 1], x[3 * i + 2]);
  return result;
}

double LammpsReference::variable(const std::string& expression) {
  command("variable answer delete\nvariable answer equal \"" + expression + "\"");
  auto* value = static_cast<double*>(lammps_extract_variable(lammps_, "answer", nullptr));
  const double copy = *value;
  lammps_free(value);
  return copy;
}

LammpsEnergy lammps_energy(LammpsReference& lammps, const std::string& style, std::span<const Vec3> positions,
                           std::span<const Element> elements, const Cell* cell) {
  lammps.place(positions, elements, cell);
  lammps.potential(style);
  return lammps.evaluate();
}

}  // namespace nanocarbon::test
