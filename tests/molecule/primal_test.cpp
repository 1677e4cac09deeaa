#include "nanocarbon/molecule/primal.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "nanocarbon/core/error.h"
#include "nanocarbon/molecule/dual.h"
#include "shapes.h"

namespace nanocarbon {
namespace {

Triangle from_lowest(Triangle t) {
  std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  return t;
}

TEST(Primal, UndoesTheDualOfAClosedMesh) {
  const TriangleMesh mesh = test::torus(12, 8, 3.0, 1.0);
  const TriangleMesh back = primal(dual(mesh));
  ASSERT_EQ(back.points.size(), mesh.points.size());
  ASSERT_EQ(back.triangles.size(), mesh.triangles.size());
  // Triangle i is atom i is triangle i, wound the same way.
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    EXPECT_EQ(from_lowest(back.triangles[t]), from_lowest(mesh.triangles[t]));
}

TEST(Primal, VerticesLieAtTheMeansOfRings) {
  const Molecule molecule = dual(test::torus(12, 8, 3.0, 1.0));
  const TriangleMesh mesh = primal(molecule);
  for (std::size_t r = 0; r < molecule.rings.size(); ++r) {
    Vec3 offset = Vec3::Zero();
    for (const AtomIndex atom : molecule.rings[r]) offset += molecule.positions[atom] - mesh.points[r];
    EXPECT_LT(offset.norm(), 1e-12);
  }
}

TEST(Primal, AnAtomInFourRingsIsRefused) {
  Molecule molecule = dual(test::torus(12, 8, 3.0, 1.0));
  const auto extra = molecule.rings[0];
  molecule.rings.atoms.insert(molecule.rings.atoms.end(), extra.begin(), extra.end());
  molecule.rings.offsets.push_back(static_cast<std::uint32_t>(molecule.rings.atoms.size()));
  EXPECT_THROW(primal(molecule), UserError);
}

}  // namespace
}  // namespace nanocarbon
