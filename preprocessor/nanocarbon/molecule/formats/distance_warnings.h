// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "nanocarbon/molecule/formats/molecule_frame.h"

namespace nanocarbon::molecule {

//! Two atoms that are too close, by indices, first below second; equal for an atom that is close to its own
//! image.
struct ClosePair {
  AtomIndex first, second;
  double distance;  //!< Angstrom, to the nearest image
};

struct CloseAtoms {
  std::vector<ClosePair> pairs;  //!< nearest first
  bool all = true;               //!< whether these are all there are
};

//! \brief Atoms closer to each other than a distance, also through the periodic boundary.
//! \details Linear in atoms: the search ends after some pairs for each atom, so that a file whose atoms are all
//! in one place is told as quickly.
//! \param distance Angstrom, above zero; no two bonded atoms of carbon or hydrogen are within 0.5 of each other
CloseAtoms find_close_atoms(const Molecule& molecule, double distance);

//! \brief What distances say against a structure: that its file was not read as it was meant, or is not whole.
//! \details Atoms closer than 0.5 Angstrom; a cell so thin that each atom lies beside its own image; atoms so far
//! apart that hardly any has a neighbour, as where lengths are in Bohr. Linear in atoms.
//! \param name of the file, for the error
//! \throw UserError (unsuitable) where nearly all atoms lie on top of others
std::vector<std::string> distance_warnings(const MoleculeFrame& frame, const std::string& name);

//! \brief What says that a direction which the file calls open is periodic: bonds that would lead through it.
//! \details For programs that write pbc="F F F" unless they are told. Takes as long as there are atoms at the faces.
//! \param cell the file's, with the directions that are periodic for it
std::optional<std::string> bonds_through_open_faces(const Molecule& molecule, const Cell& cell);

}  // namespace nanocarbon::molecule
