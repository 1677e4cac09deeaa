// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

namespace nanocarbon {

//! How much time may be spent on a molecule. CPU on one core, for each atom.
enum class Quality {
  draft,  //!< no annealing of defects: below 1 ms, of which remeshing takes 0.1
  good,   //!< defects annealed: 8 to 20 ms, up to 40 below 500 atoms, of which remeshing takes 1
  best    //!< several attempts and slower cooling: below 100 ms, of which remeshing takes 4
};

}  // namespace nanocarbon
