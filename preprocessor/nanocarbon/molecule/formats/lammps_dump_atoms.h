// SPDX-License-Identifier: GPL-2.0-or-later
// What all text dumps of LAMMPS have in common, whatever stands around it: boxes, columns and atoms.
#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "nanocarbon/molecule/formats/read_settings.h"

namespace nanocarbon::molecule {

//! A box as a dump has it. Without letters it is taken as periodic.
struct DumpBox {
  Cell cell;
  bool says_boundary = false;
};

//! \brief Takes a boundary, one word of one or two letters each way: p or pp, ff, fs, ...
//! \throw UserError (malformed)
void take_boundary(const TextInput& input, std::span<const std::string_view> letters, DumpBox& box);

//! \brief Makes the cell of the bounds of a box, which LAMMPS writes around the box where it is tilted.
//! \param bounds low and high along x, y and z, Angstrom
//! \param tilts xy, xz, yz
//! \throw UserError (malformed) where a direction has no extent
void take_bounds(const TextInput& input, const double (&bounds)[3][2], const Vec3& tilts, DumpBox& box);

//! \brief Reads the atoms of one frame, each from the words of a line, into a frame.
//! \details Positions: xu yu zu, x y z, xsu ysu zsu or xs ys zs, the first of these that is there; image flags
//! ix iy iz unwrap x and xs. Elements: --types by type, else the columns element (or typelabel), else mass.
class DumpAtoms {
 public:
  //! \param names of the columns, in order
  //! \throw UserError (malformed; unsuitable where no column says what the atoms are)
  DumpAtoms(const TextInput& input, std::span<const std::string_view> names, std::size_t atoms,
            const DumpBox& box, ReadSettings& settings, MoleculeFrame& frame);
  ~DumpAtoms();

  //! The atom of the current line.
  void add(const TextInput& input, std::span<const std::string_view> words);
  //! After the last: puts the atoms in order and warns of what is in doubt.
  void finish(const TextInput& input);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace nanocarbon::molecule
