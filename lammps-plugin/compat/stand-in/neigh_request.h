// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

//! \file
//! \brief LAMMPS's neighbour-list request, which installed headers leave out.
//! \details Only ever seen through LAMMPS's own pointer. Where Neighbor has add_request (2022 and later) the
//! request is set up by functions, and its members, which have changed since, must not be touched. Before, it
//! is set up by members: those of 2021 up to the last one set by us, in LAMMPS's order.

#include "pointers.h"

namespace LAMMPS_NS {

class NeighRequest : protected Pointers {
 public:
  int index;
  void* requestor;
  int requestor_instance;
  int id;
  int pair, fix, compute, command, neigh;  //!< which kind of style asks; one is 1
  int half, full;                          //!< which pairs the list holds; one is 1
  int occasional;                          //!< 1: built only when asked for
  int newton;
  int ghost;  //!< 1: also the neighbours of ghost atoms
  int size, history, granonesided, respainner, respamiddle, respaouter, bond;
  int omp, intel, kokkos_host, kokkos_device, ssa;  //!< for packages
  int cut;                                          //!< 1: the list has a cut-off of its own
  double cutoff;                                    //!< that cut-off, skin included

  NeighRequest() = delete;

  void enable_full();
  void enable_ghost();
  void set_cutoff(double);
  void set_id(int);
};

}  // namespace LAMMPS_NS
