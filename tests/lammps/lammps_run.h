// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "lammps.h"
#include "nanocarbon/molecule/molecule.h"

namespace nanocarbon::test {

//! \brief A LAMMPS through its C++ interface, on all ranks of the test program, with the plugin loaded.
//! \details Every call is collective and gives the same on every rank. LAMMPS's errors come as exceptions.
class LammpsRun {
 public:
  //! \param plugin false: the object is not loaded, and there is only the `plugin` command
  explicit LammpsRun(bool plugin = true);
  ~LammpsRun();

  void command(const std::string& line);
  void commands(const std::vector<std::string>& lines);

  //! units metal, the molecule from a data file (IDs are indices plus one), its periodic directions, masses,
  //! and pair_style rebo or another.
  //! \param before commands that must come before the box, such as
  //! atom_modify
  void read(const Molecule& molecule, const std::string& pair = "rebo",
            const std::vector<std::string>& before = {});

  //! Moves atoms to new places, by index; they may be anywhere.
  void place(const std::map<AtomIndex, Vec3>& places);

  double fix_scalar(const std::string& id);
  double fix_vector(const std::string& id, int index);  //!< from 1, as in input scripts

  //! Column (from 0) of a fix's per-atom array by atom ID.
  std::map<std::int64_t, double> fix_column(const std::string& id, int column);
  std::vector<Vec3> positions();  //!< of all atoms in the order of their IDs
  long step() const;

  LAMMPS_NS::LAMMPS& lammps() { return *lammps_; }

 private:
  std::unique_ptr<LAMMPS_NS::LAMMPS> lammps_;
};

//! An empty folder of this test's own, the same on every rank, gone with the object.
class SharedFolder {
 public:
  SharedFolder();
  ~SharedFolder();
  std::string operator/(const std::string& name) const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_;
};

//! The path of LAMMPS's CH.rebo.
std::string rebo_parameters();
//! The path of the file that pair_style rebo, airebo or airebo/morse (with or without /opt) wants.
std::string potential_file(const std::string& style);

bool is_root();
int ranks();

//! The lines of a file, after all ranks have come here.
std::vector<std::string> lines_of(const std::string& path);

}  // namespace nanocarbon::test
