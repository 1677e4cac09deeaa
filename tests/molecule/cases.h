// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>

#include "nanocarbon/molecule/molecule.h"
#include "nanocarbon/topology/surface_topology.h"

namespace nanocarbon::test {

//! A molecule whose bonds are those of its distances.
Molecule with_bonds_by_distance(Molecule molecule);

//! The bonds as the tracking would have them: by distance, with hysteresis from the molecule's bonds before.
Molecule with_updated_bonds(Molecule molecule);

//! Each coordinate moved by a normal deviate of the given standard deviation (Angstrom), bonds kept.
Molecule rattled(Molecule molecule, double deviation, std::uint64_t seed);

//! Turned in space, and the atoms in another order.
Molecule turned_and_shuffled(const Molecule& molecule, std::uint64_t seed);

//! Both molecules, the second's atoms after the first's. Free space.
Molecule together(Molecule first, const Molecule& second);

//! Without one atom and its bonds.
Molecule without_atom(const Molecule& molecule, AtomIndex atom);

//! Two bonded atoms turned by 90 degrees about the middle of their bond in the plane of their neighbours;
//! bonds updated.
Molecule stone_wales(const Molecule& molecule, AtomIndex first, AtomIndex second);

//! A carbon strip glued to a ring with so many half twists, as wide as three zigzag rows; bonds are the
//! dual's.
Molecule twisted_band(int half_twists);

//! A Klein bottle in the figure-8 immersion. It passes through itself, where atoms come close: only the bonds
//! say what it is.
Molecule klein_bottle();

//! A closed surface with as many handles as blocks with a hole stand in a row.
Molecule handles(int genus);

topology::SurfaceTopology topology(const Molecule& molecule, int max_ring = 12);

}  // namespace nanocarbon::test
