// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

//! \file
//! \brief The places where LAMMPS's C++ interface has changed since 29Sep2021, each as one function that asks
//! the headers which form they have. A header that LAMMPS leaves out is found in stand-in/.

#include "neigh_request.h"

namespace nanocarbon {

//! \brief Asks for a full neighbour list at every reneighbouring.
//! \param neighbor LAMMPS's Neighbor
//! \param style a Pair
//! \param instance that style's instance_me
//! \param ghosts also the neighbours of ghost atoms
//! \param cutoff of this list alone, skin included; 0 for the pair style's cut-off and the skin
template <typename Neighbor, typename Style>
void request_full_list(Neighbor& neighbor, Style* style, int instance, bool ghosts, double cutoff = 0.0) {
  if constexpr (requires { neighbor.add_request(style); }) {
    auto* const request = neighbor.add_request(style);
    request->enable_full();
    if (ghosts) request->enable_ghost();
    if (cutoff > 0.0) request->set_cutoff(cutoff);
  } else {
    const int index = neighbor.request(style, instance);  // may move the array of requests
    auto* const request = neighbor.requests[index];
    request->half = 0;
    request->full = 1;
    request->ghost = ghosts ? 1 : 0;
    request->cut = cutoff > 0.0 ? 1 : 0;
    request->cutoff = cutoff;
  }
}

//! \brief Asks for a half neighbour list of the pair style's cut-off, each pair once, at every reneighbouring.
//! \param id what the style's init_list() is given with the list
template <typename Neighbor, typename Style>
void request_half_list(Neighbor& neighbor, Style* style, int instance, int id) {
  if constexpr (requires { neighbor.add_request(style); })
    neighbor.add_request(style)->set_id(id);
  else {
    const int index = neighbor.request(style, instance);
    neighbor.requests[index]->id = id;
  }
}

//! Carries a fix's per-atom values from owners to ghost atoms, by its pack_forward_comm and
//! unpack_forward_comm.
template <typename Comm, typename Fix>
void forward_comm_of_fix(Comm& comm, Fix* fix) {
  if constexpr (requires { comm.forward_comm(fix); })
    comm.forward_comm(fix);
  else
    comm.forward_comm_fix(fix);
}

//! The same for a pair style.
template <typename Comm, typename Pair>
void forward_comm_of_pair(Comm& comm, Pair* pair) {
  if constexpr (requires { comm.forward_comm(pair); })
    comm.forward_comm(pair);
  else
    comm.forward_comm_pair(pair);
}

//! Adds a pair style's values on ghost atoms up at their owners, by its pack_reverse_comm and
//! unpack_reverse_comm.
template <typename Comm, typename Pair>
void reverse_comm_of_pair(Comm& comm, Pair* pair) {
  if constexpr (requires { comm.reverse_comm(pair); })
    comm.reverse_comm(pair);
  else
    comm.reverse_comm_pair(pair);
}

}  // namespace nanocarbon
