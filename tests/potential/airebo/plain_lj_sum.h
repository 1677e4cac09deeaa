// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "nanocarbon/core/cell.h"
#include "nanocarbon/core/neighbours_within.h"
#include "nanocarbon/potential/airebo/lj/lj_parameters.h"

namespace nanocarbon::airebo::test {

//! Atoms, and pairs of them that do not count.
struct LjSystem {
  std::string name;
  std::vector<Vec3> positions;
  std::vector<Element> elements;
  std::optional<Cell> cell;
  NeighbourList exclusions;

  const Cell* cell_or_none() const { return cell ? &*cell : nullptr; }
  std::size_t size() const { return positions.size(); }
};

//! What the sum is, by the formulas as they are printed.
struct PlainSum {
  double energy = 0.0;
  Mat3 virial = Mat3::Zero();
  std::vector<Vec3> forces;
  std::vector<double> atom_energies;
  std::vector<Mat3> atom_virials;
  double largest_pair_force = 0.0;
  double sum_of_magnitudes = 0.0;  //!< of the pairs' energies
};

//! Over all atoms, all atoms and as many images as the longest reach needs.
PlainSum plain_sum(const LjSystem& system, const LjParameters& parameters);

//! The parameters of LAMMPS's CH.airebo and CH.airebo-m.
LjParameters published_parameters(LjForm form);

//! \brief Carbon and hydrogen at random, no two closer than 1 Angstrom, pairs within 2.5 Angstrom excluded.
//! \param cell nothing for a ball in free space
LjSystem random_system(std::size_t atoms, std::optional<Cell> cell, double share_of_hydrogen, unsigned seed);

//! Every atom moved by the distance given, in a direction at random.
LjSystem shaken(LjSystem system, double distance, unsigned seed);

}  // namespace nanocarbon::airebo::test
