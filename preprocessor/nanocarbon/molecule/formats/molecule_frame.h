// SPDX-License-Identifier: GPL-2.0-or-later
// What is read from a file of atoms, and what can be said about how to read it.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "nanocarbon/molecule/molecule.h"

namespace nanocarbon::molecule {

//! What a file does not say, or says wrongly. Everything has a default: what the file says.
struct MoleculeReadOptions {
  //! \brief Elements of atom types: of types 1, 2, ... ({"C", "H"}), or of types and names ({"1=C", "CA=C"}).
  //! \details They go before what the file says.
  std::vector<std::string> types = {};
  //! LAMMPS's name of the columns of a data file's Atoms section (atomic, full, sphere, hybrid, ...).
  std::string atom_style = {};
  //! Which of the cell's directions are periodic; without a cell none can be.
  std::optional<std::array<bool, 3>> periodic = {};
  //! Of XYZ files that give none.
  std::optional<Cell> cell = {};
};

//! One structure of a file: all of a data file, a time step of a trajectory.
struct MoleculeFrame {
  //! In ascending order of IDs where the file has them. Bonds where the file has them; rings are not known.
  Molecule molecule;
  std::vector<std::int64_t> ids;      //!< what the file calls each atom, or 1, 2, ...
  bool has_ids = true;                //!< whether the file says them
  std::optional<std::int64_t> step;   //!< the time step, where the file says it
  std::vector<std::string> warnings;  //!< what a user should know before trusting the numbers
};

}  // namespace nanocarbon::molecule
