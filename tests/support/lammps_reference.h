// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "nanocarbon/core/cell.h"
#include "nanocarbon/core/element.h"
#include "nanocarbon/core/vec3.h"

namespace nanocarbon::test {

//! What LAMMPS says of a structure, metal units.
struct LammpsEnergy {
  double energy;  //!< eV
  std::vector<Vec3> forces;
  Mat3 virial;  //!< pressure times volume, eV
  std::vector<double> atom_energies;
  std::vector<Mat3> atom_virials;  //!< minus compute stress/atom, eV
  std::array<double, 3> parts = {};  //!< compute pair: of REBO, Lennard-Jones (or Morse) and torsion, eV
};

//! A LAMMPS on this rank alone that evaluates structures, with the plugin loaded if asked for.
class LammpsReference {
 public:
  explicit LammpsReference(bool with_plugin = false);
  ~LammpsReference();
  LammpsReference(const LammpsReference&) = delete;
  LammpsReference& operator=(const LammpsReference&) = delete;

  //! Runs a command, or several on lines of their own.
  //! \throw std::runtime_error with LAMMPS's message
  void command(const std::string& text);
  //! Forgets everything and puts these atoms into a cell, or into a large box without periodicity; types C,
  //! H.
  void place(std::span<const Vec3> positions, std::span<const Element> elements, const Cell* cell);
  //! `pair_style <style>` with CH.rebo, CH.airebo or CH.airebo-m, as the style needs.
  void potential(const std::string& style);
  //! Energy and derivatives of the atoms where they are.
  //! \param atom_virials also those (they make rebo slower)
  //! \param atom_energies also those
  LammpsEnergy evaluate(bool atom_virials = true, bool atom_energies = true);
  //! The current positions, by atom.
  std::vector<Vec3> positions();
  double variable(const std::string& expression);

 private:
  void* lammps_;
  bool with_plugin_;
  std::string style_;
  std::size_t atoms_ = 0;
  double volume_ = 0.0;
};

//! place, potential, evaluate
LammpsEnergy lammps_energy(LammpsReference& lammps, const std::string& style, std::span<const Vec3> positions,
                           std::span<const Element> elements, const Cell* cell);

}  // namespace nanocarbon::test
