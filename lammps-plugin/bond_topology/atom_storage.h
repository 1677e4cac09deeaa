// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "bond_topology/local_bonds.h"

namespace nanocarbon {

//! \brief What the fix keeps of each atom of a rank, moving with it between ranks and places.
//! \details Grown by LAMMPS to hold ghosts as well; of these only the ID is ever set.
class AtomStorage {
 public:
  static constexpr int columns = 3;                                 //!< state, coordination, smallest ring
  static constexpr int most_packed = 2 + columns + Partners::most;  //!< values

  void grow(int atoms);
  void copy(int from, int to);
  void clear(int atom);  //!< as of an atom that is new: not watched

  //! Writes an atom to a buffer, and reads one from it; both return the number of values.
  int pack(int atom, double* buffer) const;
  int unpack(int atom, const double* buffer);

  std::vector<std::int64_t> ids;  //!< when the watch began; 0: not watched
  std::vector<Partners> partners;

  double** output() { return rows_.data(); }  //!< [atom][column], for LAMMPS; moves when grown
  double bytes() const;

 private:
  std::vector<double> values_;
  std::vector<double*> rows_;
};

}  // namespace nanocarbon
