// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "nanocarbon/topology/bonds.h"

namespace nanocarbon::topology {

//! Takes every atom once, and none that there is not.
class FirstTime {
 public:
  //! \param taken one for each atom, true where it has been taken
  explicit FirstTime(std::vector<bool>& taken) : taken_(taken) {}
  bool operator()(AtomIndex atom) const {
    if (atom >= taken_.size() || taken_[atom]) return false;
    taken_[atom] = true;
    return true;
  }

 private:
  std::vector<bool>& taken_;
};

//! \brief Appends the atoms one bond farther: a step of a search breadth first.
//! \param neighbours_of called with an atom: its neighbours, any number for a missing one
//! \param shell where the last shell begins in `atoms`; becomes where the new one does
//! \param take called with every neighbour of the last shell, the missing ones too: whether to append it
template <typename NeighboursOf, typename Take>
void add_bond_shell(const NeighboursOf& neighbours_of, std::vector<AtomIndex>& atoms, std::size_t& shell,
                    const Take& take) {
  for (const std::size_t end = atoms.size(); shell < end; ++shell)
    for (const AtomIndex n : neighbours_of(atoms[shell]))
      if (take(n)) atoms.push_back(n);
}

}  // namespace nanocarbon::topology
