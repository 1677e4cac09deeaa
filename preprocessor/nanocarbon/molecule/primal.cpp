#include "nanocarbon/molecule/primal.h"

#include <fmt/format.h>

#include <array>

#include "nanocarbon/core/error.h"

namespace nanocarbon {
namespace {

// A ring at an atom, with the atoms before and after on its way round.
struct Corner {
  VertexIndex ring;
  AtomIndex before, after;
};

struct Corners {
  std::array<Corner, 3> corner;
  unsigned count = 0;
};

std::vector<Corners> corners_of_atoms(const Molecule& molecule) {
  std::vector<Corners> corners(molecule.size());
  for (std::size_t r = 0; r < molecule.rings.size(); ++r) {
    const auto ring = molecule.rings[r];
    for (std::size_t i = 0; i < ring.size(); ++i) {
      Corners& at = corners[ring[i]];
      if (at.count == 3)
        throw UserError(
            Failure::unsuitable,
            fmt::format("atom {} lies in more than three rings: not a surface of sp2 carbon", ring[i]));
      at.corner[at.count++] = {static_cast<VertexIndex>(r), ring[(i + ring.size() - 1) % ring.size()],
                               ring[(i + 1) % ring.size()]};
    }
  }
  return corners;
}

}  // namespace

TriangleMesh primal(const Molecule& molecule) {
  TriangleMesh mesh;
  mesh.points.reserve(molecule.rings.size());
  for (std::size_t r = 0; r < molecule.rings.size(); ++r) {
    Vec3 sum = Vec3::Zero();
    for (const AtomIndex atom : molecule.rings[r]) sum += molecule.positions[atom];
    mesh.points.push_back(sum / static_cast<double>(molecule.rings[r].size()));
  }
  for (const Corners& at : corners_of_atoms(molecule)) {
    if (at.count < 3) continue;
    const auto& [a, b, c] = at.corner;
    // Rings run counter-clockwise; around an atom the ring that arrives over the bond by which one leaves
    // comes next.
    const bool in_order = a.before == b.after;
    mesh.triangles.push_back(in_order ? Triangle{a.ring, b.ring, c.ring} : Triangle{a.ring, c.ring, b.ring});
  }
  return mesh;
}

}  // namespace nanocarbon
