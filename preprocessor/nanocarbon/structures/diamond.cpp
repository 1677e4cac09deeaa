// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/structures/diamond.h"

#include "nanocarbon/core/error.h"
#include "nanocarbon/structures/close_bonds.h"

namespace nanocarbon::structures {

Molecule diamond(int cells_x, int cells_y, int cells_z) {
  if (cells_x < 1 || cells_y < 1 || cells_z < 1)
    throw UserError(Failure::usage, "a diamond crystal needs at least one cell along each edge");
  // Two face-centred lattices, a quarter of the diagonal apart.
  const Vec3 face_centred[4] = {{0.0, 0.0, 0.0}, {0.0, 0.5, 0.5}, {0.5, 0.0, 0.5}, {0.5, 0.5, 0.0}};
  Molecule crystal;
  crystal.cell = orthogonal_cell(diamond_lattice_constant * Vec3(cells_x, cells_y, cells_z));
  for (int k = 0; k < cells_z; ++k)
    for (int j = 0; j < cells_y; ++j)
      for (int i = 0; i < cells_x; ++i)
        for (const Vec3& site : face_centred)
          for (const double shift : {0.0, 0.25})
            crystal.positions.push_back(diamond_lattice_constant *
                                        (Vec3(i, j, k) + site + Vec3::Constant(shift)));
  crystal.elements.assign(crystal.size(), Element::carbon);
  add_bonds(crystal);
  return crystal;
}

}  // namespace nanocarbon::structures
