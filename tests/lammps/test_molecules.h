// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>

#include "nanocarbon/molecule/molecule.h"

namespace nanocarbon::test {

//! Bonds by distance, 1.7 Angstrom, without rings.
void bond_by_distance(Molecule& molecule);

//! A periodic (n, n) tube bent into a ring: a torus molecule, genus 1, all hexagons.
Molecule torus_molecule(int n, int periods);

//! A ribbon of graphene, zigzag edges along it, closed on itself with half a turn.
//! \param chains zigzag
//! chains side by side, an even number
//! \param hexagons along the band
Molecule moebius_band(int chains, int hexagons);

//! A flake of graphene with two holes, each where a ring of six and the six around it were.
Molecule flake_with_two_holes();

//! \brief Two copies of a flat flake, one above the other, joined by a bond between each pair of edge atoms:
//! a closed surface whose genus is one less than the flake's boundary loops.
//! \pre the flake lies in a plane
//! of constant z
Molecule doubled(const Molecule& flake);

//! Both molecules in free space, the second moved.
Molecule together(const Molecule& first, const Molecule& second, const Vec3& move);

//! The place of a bond's two atoms after a turn by 90 degrees around the axis through its middle.
std::array<Vec3, 2> turned(const Vec3& first, const Vec3& second, const Vec3& axis);

}  // namespace nanocarbon::test
