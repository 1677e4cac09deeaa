// SPDX-License-Identifier: GPL-2.0-or-later
// The comment line of extended XYZ: https://github.com/libAtoms/extxyz
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "nanocarbon/molecule/formats/read_settings.h"

namespace nanocarbon::molecule {

//! Where a line of an atom has what, from 0.
struct XyzColumns {
  std::size_t species = 0;
  std::size_t position = 1;  //!< of x; y and z follow
  std::size_t least = 4;     //!< columns that each line must have
  std::optional<std::size_t> id = {};
  bool atomic_numbers = false;  //!< species are those
};

struct XyzComment {
  std::optional<Cell> cell;
  //! The whole Lattice, where pbc leaves directions of it open: programs write F unless they are told.
  std::optional<Cell> lattice;
  XyzColumns columns;
  std::optional<std::int64_t> step;
};

//! \brief What the current line says, as the comment of a frame.
//! \details Lattice, Origin, pbc, Properties, Timestep and Step as in files of ASE, OVITO, QUIP and GPUMD, in any
//! case; LAMMPS's "Timestep: N". A Lattice without pbc is periodic in all directions, as ASE and OVITO have it.
//! \throw UserError (malformed)
//! \throw UserError (unsuitable) where pbc says that it is periodic but there is no Lattice
XyzComment parse_xyz_comment(const TextInput& input, const ReadSettings& settings);

}  // namespace nanocarbon::molecule
