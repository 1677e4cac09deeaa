// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

//! \file
//! \brief LAMMPS's base class of commands, which installed headers leave out: the same virtual functions in
//! the same order.

#include "pointers.h"

namespace LAMMPS_NS {

class Command : protected Pointers {
 public:
  explicit Command(LAMMPS* lammps) : Pointers(lammps) {}
  virtual void command(int narg, char** arg) = 0;
};

}  // namespace LAMMPS_NS
