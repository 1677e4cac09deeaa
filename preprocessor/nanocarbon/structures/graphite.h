// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "nanocarbon/molecule/molecule.h"

namespace nanocarbon::structures {

enum class Stacking {
  ab,  //!< Bernal: every other layer is shifted by a bond
  aa   //!< atoms above atoms
};

//! Distances in graphite, Angstrom.
struct GraphiteLattice {
  double bond;
  double layer;  //!< from one layer to the next
};

//! \brief Where AIREBO or AIREBO-M has its least energy, by LAMMPS.
//! \param morse AIREBO-M, else AIREBO
GraphiteLattice graphite_lattice(Stacking stacking, bool morse);

struct GraphiteSize {
  int cells_x = 1;  //!< rectangular cells of 4 atoms a layer, zigzag along x
  int cells_y = 1;  //!< armchair along y
  int layers = 2;
};

//! \brief Layers of graphene on each other, periodic along x, y and z; or a slab, not periodic along z.
//! \details A slab has 10 Angstrom to spare on both sides.
//! \throw UserError (usage) for a count below 1, or an odd number of AB layers that are to be periodic
Molecule graphite(const GraphiteSize& size, Stacking stacking, const GraphiteLattice& lattice, bool slab);

//! The counts of cells whose sides are closest to the lengths asked for (Angstrom), at least one each way.
GraphiteSize graphite_size(double length_x, double length_y, int layers, const GraphiteLattice& lattice);

}  // namespace nanocarbon::structures
