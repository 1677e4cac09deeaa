// SPDX-License-Identifier: GPL-2.0-or-later
#include "lammps/lammps_run.h"

#include <mpi.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <stdexcept>

#include "atom.h"
#include "fix.h"
#include "host/plugin_command.h"
#include "input.h"
#include "modify.h"
#include "nanocarbon/molecule/formats/lammps_data.h"
#include "update.h"

namespace nanocarbon::test {
namespace {

std::string number(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}

// Adds up over ranks what each knows of some atoms.
std::vector<double> summed(std::vector<double> values) {
  MPI_Allreduce(MPI_IN_PLACE, values.data(), static_cast<int>(values.size()), MPI_DOUBLE, MPI_SUM,
                MPI_COMM_WORLD);
  return values;
}

LAMMPS_NS::Fix& fix_of(LAMMPS_NS::LAMMPS& lmp, const std::string& id) {
  const int index = lmp.modify->find_fix(id);
  if (index < 0) throw std::runtime_error("no fix " + id);
  return *lmp.modify->fix[index];
}

}  // namespace

LammpsRun::LammpsRun(bool plugin) {
  std::vector<std::string> words = {"lmp", "-log", "none", "-screen", "none", "-nocite"};
  if (std::getenv("NANOCARBON_SHOW_LAMMPS") != nullptr) words = {"lmp", "-log", "none", "-nocite"};
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  lammps_ = std::make_unique<LAMMPS_NS::LAMMPS>(static_cast<int>(arguments.size()), arguments.data(),
                                                MPI_COMM_WORLD);
  add_plugin_command(*lammps_);
  if (plugin) command("plugin load " NANOCARBON_PLUGIN_FILE);
}

LammpsRun::~LammpsRun() = default;

void LammpsRun::command(const std::string& line) { lammps_->input->one(line); }

void LammpsRun::commands(const std::vector<std::string>& lines) {
  for (const std::string& line : lines) command(line);
}

void LammpsRun::read(const Molecule& molecule, const std::string& pair,
                     const std::vector<std::string>& before) {
  const SharedFolder folder;
  if (is_root()) molecule::write_lammps_data(folder / "molecule.data", molecule);
  MPI_Barrier(MPI_COMM_WORLD);
  std::string boundary = "boundary";
  for (int axis = 0; axis < 3; ++axis)
    boundary += molecule.cell && molecule.cell->periodic[axis] ? " p" : " f";
  commands({"units metal", "atom_style atomic", "atom_modify map yes", boundary});
  commands(before);
  commands({"read_data " + folder / "molecule.data", "pair_style " + pair});
  if (pair.starts_with("rebo") || pair.starts_with("airebo"))
    command("pair_coeff * * " + potential_file(pair) + " C H");
  else
    command("pair_coeff * *");
  command("timestep 0.0005");
  MPI_Barrier(MPI_COMM_WORLD);
}

void LammpsRun::place(const std::map<AtomIndex, Vec3>& places) {
  // By displacement, since that also carries atoms to other ranks.
  const std::vector<Vec3> now = positions();
  for (const auto& [atom, place] : places) {
    const std::string id = std::to_string(atom + 1);
    const Vec3 by = place - now[atom];
    command("group nanocarbon_moved id " + id);
    command("displace_atoms nanocarbon_moved move " + number(by[0]) + " " + number(by[1]) + " " +
            number(by[2]) + " units box");
    command("group nanocarbon_moved delete");
  }
}

double LammpsRun::fix_scalar(const std::string& id) { return fix_of(*lammps_, id).compute_scalar(); }

double LammpsRun::fix_vector(const std::string& id, int index) {
  return fix_of(*lammps_, id).compute_vector(index - 1);
}

std::map<std::int64_t, double> LammpsRun::fix_column(const std::string& id, int column) {
  const LAMMPS_NS::Atom& atom = *lammps_->atom;
  LAMMPS_NS::tagint highest = 0;
  for (int i = 0; i < atom.nlocal; ++i) highest = std::max(highest, atom.tag[i]);
  MPI_Allreduce(MPI_IN_PLACE, &highest, 1, MPI_LMP_TAGINT, MPI_MAX, MPI_COMM_WORLD);
  std::vector<double> values(highest + 1, 0.0);
  std::vector<double> there(highest + 1, 0.0);
  double* const* const rows = fix_of(*lammps_, id).array_atom;
  for (int i = 0; i < atom.nlocal; ++i) {
    values[atom.tag[i]] = rows[i][column];
    there[atom.tag[i]] = 1.0;
  }
  values = summed(values);
  there = summed(there);
  std::map<std::int64_t, double> result;
  for (std::int64_t tag = 1; tag <= highest; ++tag)
    if (there[tag] > 0.0) result[tag] = values[tag];
  return result;
}

std::vector<Vec3> LammpsRun::positions() {
  const LAMMPS_NS::Atom& atom = *lammps_->atom;
  std::vector<double> values(3 * static_cast<std::size_t>(atom.natoms), 0.0);
  for (int i = 0; i < atom.nlocal; ++i)
    for (int axis = 0; axis < 3; ++axis) values[3 * (atom.tag[i] - 1) + axis] = atom.x[i][axis];
  values = summed(values);
  std::vector<Vec3> result;
  for (std::size_t k = 0; k < values.size(); k += 3)
    result.emplace_back(values[k], values[k + 1], values[k + 2]);
  return result;
}

long LammpsRun::step() const { return static_cast<long>(lammps_->update->ntimestep); }

SharedFolder::SharedFolder() {
  std::array<char, 256> name = {};
  if (is_root()) {
    const std::string pattern = (std::filesystem::temp_directory_path() / "nanocarbon-test-XXXXXX").string();
    std::copy(pattern.begin(), pattern.end(), name.begin());
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder " + pattern);
  }
  MPI_Bcast(name.data(), static_cast<int>(name.size()), MPI_CHAR, 0, MPI_COMM_WORLD);
  path_ = name.data();
}

SharedFolder::~SharedFolder() {
  MPI_Barrier(MPI_COMM_WORLD);
  std::error_code ignored;
  if (is_root()) std::filesystem::remove_all(path_, ignored);
}

std::string rebo_parameters() { return NANOCARBON_CH_REBO; }

std::string potential_file(const std::string& style) {
  std::string file = rebo_parameters();
  if (style.starts_with("airebo"))
    file.replace(file.rfind("CH."), std::string::npos,
                 style.starts_with("airebo/morse") ? "CH.airebo-m" : "CH.airebo");
  return file;
}

bool is_root() {
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  return rank == 0;
}

int ranks() {
  int count = 0;
  MPI_Comm_size(MPI_COMM_WORLD, &count);
  return count;
}

std::vector<std::string> lines_of(const std::string& path) {
  MPI_Barrier(MPI_COMM_WORLD);
  std::ifstream file(path);
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) lines.push_back(line);
  MPI_Barrier(MPI_COMM_WORLD);
  return lines;
}

}  // namespace nanocarbon::test
