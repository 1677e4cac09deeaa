// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/molecule/ring_mesh.h"

namespace nanocarbon::molecule {

TriangleMesh ring_mesh(const Molecule& molecule) {
  TriangleMesh mesh{molecule.positions, {}};
  mesh.space = Space(molecule.cell);
  mesh.triangles.reserve(molecule.rings.atoms.size());
  for (std::size_t r = 0; r < molecule.rings.size(); ++r) {
    const auto ring = molecule.rings[r];
    const Vec3& first = molecule.positions[ring[0]];
    Vec3 sum = Vec3::Zero();
    for (const AtomIndex a : ring) sum += mesh.space.beside(molecule.positions[a], first);
    const auto centre = static_cast<VertexIndex>(mesh.points.size());
    mesh.points.push_back(sum / static_cast<double>(ring.size()));
    for (std::size_t k = 0; k < ring.size(); ++k)
      mesh.triangles.push_back({centre, ring[k], ring[(k + 1) % ring.size()]});
  }
  return mesh;
}

}  // namespace nanocarbon::molecule
