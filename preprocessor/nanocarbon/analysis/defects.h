// SPDX-License-Identifier: GPL-2.0-or-later
// Where a molecule differs from a sheet of hexagons, and what such places are called.
#pragma once

#include <string>
#include <vector>

#include "nanocarbon/analysis/components.h"

namespace nanocarbon::analysis {

//! One defect, at one place.
struct Defect {
  std::string kind;  //!< "5-7 pair", "Stone-Wales", "vacancy", "adatom", ...: see find_defects
  std::vector<std::uint32_t>
      rings;  //!< those that are no hexagons, ascending; indices into MoleculeComponents::rings
  std::vector<std::uint32_t> ring_sizes;  //!< of these rings, ascending
  std::vector<AtomIndex> atoms;           //!< ascending
  Vec3 position = Vec3::Zero();           //!< middle of its atoms, Angstrom; in the cell where there is one
};

//! \brief The defects of all components, sorted by kind and lowest atom.
//! \details Rings that are no hexagons and share a bond belong to one defect. It is named by their sizes:
//!   - one ring: "square", "pentagon", "heptagon", "octagon", else "ring of N"
//!   - 5, 7: "5-7 pair", a dislocation
//!   - 5, 5, 7, 7: "Stone-Wales" where the heptagons share the bond that both pentagons end at (one bond of four
//!     hexagons, turned: A. J. Stone and D. J. Wales, Chem. Phys. Lett. 128, 501 (1986)), else "two 5-7 pairs"
//!   - 5, 9 with one carbon of two bonds, or 12 with three: "vacancy" (one atom is missing)
//!   - 5, 5, 8: "divacancy 5-8-5"; 5, 5, 5, 7, 7, 7: "divacancy 555-777"; four 5 and four 7 around a hexagon:
//!     "divacancy 5555-6-7777" (F. Banhart et al., ACS Nano 5, 26 (2011))
//!   - else "cluster of N rings"
//! A hole in a sheet, a boundary loop that the sheet is around, is a defect as well: "open divacancy" where it is
//! of 14 atoms and four of them have two bonds, else "hole of N atoms". Ends of tubes and edges of flakes are not.
//! Other defects are single atoms and bonds:
//!   - "adatom": a carbon with two bonds, to atoms that are bonded to each other
//!   - "crosslink": a bond of two carbons with four bonds each that lies on no ring of at most eight
//!   - "carbon with one bond", "carbon with five bonds" or more: chains' ends, and what no carbon should have
//! Rings share a bond where they share its two atoms: in a cell of a few atoms that may be another image of the bond.
//! Linear.
std::vector<Defect> find_defects(const Molecule& molecule, const BondRows& rows,
                                 const MoleculeComponents& components);

}  // namespace nanocarbon::analysis
