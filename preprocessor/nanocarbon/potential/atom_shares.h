// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "nanocarbon/core/vec3.h"

namespace nanocarbon::potential {

//! A symmetric tensor in LAMMPS's order: xx, yy, zz, xy, xz, yz.
using Virial = std::array<double, 6>;

//! \brief Where the terms add the energy and virial of single atoms, if those are wanted.
//! \details Shared as in LAMMPS: half of a bond's energy and of a pair force's virial goes to each end, a third of
//! an angle's virial and a quarter of a dihedral's to each of its atoms. The virial is the sum of r (x) f, that is
//! pressure times volume.
struct AtomShares {
  double* energies = nullptr;  //!< eV, one for each atom, or nothing
  Virial* virials = nullptr;   //!< eV, one for each atom, or nothing

  template <std::size_t n>
  void add_energy(const std::array<std::uint32_t, n>& atoms, double energy) const {
    if (!energies) return;
    for (const std::uint32_t atom : atoms) energies[atom] += energy / n;
  }

  void add_bond_energy(std::uint32_t i, std::uint32_t j, double energy) const {
    if (!energies) return;
    energies[i] += 0.5 * energy;
    energies[j] += 0.5 * energy;
  }

  //! Adds the virial of a pull along a bond, shared equally by the given atoms. The bond has a length (Angstrom)
  //! and a direction (unit vector), as HalfEdge has; the pull, eV/Angstrom, is minus the force on its far
  //! end.
  template <std::size_t n, class BondVector>
  void add_virial(const std::array<std::uint32_t, n>& atoms, const BondVector& bond, const Vec3& pull) const {
    const Vec3 arm = (-bond.length / n) * bond.direction;
    for (const std::uint32_t atom : atoms) {
      Virial& v = virials[atom];
      v[0] += arm.x() * pull.x();
      v[1] += arm.y() * pull.y();
      v[2] += arm.z() * pull.z();
      v[3] += arm.x() * pull.y();
      v[4] += arm.x() * pull.z();
      v[5] += arm.y() * pull.z();
    }
  }
};

}  // namespace nanocarbon::potential
