// SPDX-License-Identifier: GPL-2.0-or-later
// Molecules that are large enough for the work on them to be shared out.
#include <gtest/gtest.h>

#include "nanocarbon/building/build_molecule.h"
#include "nanocarbon/shapes/shapes.h"

namespace nanocarbon::building {
namespace {

BuildResult build(const TriangleMesh& surface, std::size_t atoms, Quality quality, Boundary boundary,
                  unsigned threads) {
  BuildOptions options;
  options.size = AtomCount{atoms};
  options.quality = quality;
  options.boundary = boundary;
  options.threads = threads;
  return build_molecule(surface, options);
}

void expect_same_bits(const TriangleMesh& surface, std::size_t atoms, Quality quality,
                      Boundary boundary = Boundary::bare) {
  const BuildResult one = build(surface, atoms, quality, boundary, 1);
  EXPECT_TRUE(one.rest->intact);
  for (const unsigned threads : {2u, 3u}) {
    const BuildResult other = build(surface, atoms, quality, boundary, threads);
    EXPECT_EQ(one.molecule.positions, other.molecule.positions);
    EXPECT_EQ(one.molecule.bonds, other.molecule.bonds);
    EXPECT_EQ(one.rest->energy, other.rest->energy);
  }
}

TEST(LargeBuild, AnyNumberOfThreadsGivesTheSameBitsOfADraft) {
  expect_same_bits(shapes::make_torus(3, 1.2, 0.15), 9000, Quality::draft);
}

// From 20,000 atoms on places are relaxed on their own.
TEST(LargeBuild, AnyNumberOfThreadsGivesTheSameBitsOfALargeDraft) {
  expect_same_bits(shapes::make_torus(3, 1.2, 0.15), 21000, Quality::draft);
}

TEST(LargeBuild, AnyNumberOfThreadsGivesTheSameBitsOfAGoodMolecule) {
  expect_same_bits(shapes::make_torus(3, 1.2, 0.15), 3000, Quality::good);
}

// Boundaries are evaluated apart from the loops.
TEST(LargeBuild, AnyNumberOfThreadsGivesTheSameBitsOfAnOpenShape) {
  expect_same_bits(shapes::make_cylinder(1, 4, 0.1), 5000, Quality::draft, Boundary::hydrogen);
}

// Beyond 20,000 atoms triangulations are refined in order along the surface and mended piece by piece.
TEST(LargeBuild, ATorusOfThirtyThousandAtomsIsOne) {
  const BuildResult built = build(shapes::make_torus(3, 1.2, 0.1), 30000, Quality::draft, Boundary::bare, 2);
  EXPECT_EQ(built.molecule.size(), 30000u);
  EXPECT_TRUE(built.rest->intact);
  for (std::size_t r = 0; r < built.molecule.rings.size(); ++r) {
    EXPECT_GE(built.molecule.rings[r].size(), 5u);
    EXPECT_LE(built.molecule.rings[r].size(), 7u);
  }
  // Bending of a torus of this shape is 17 eV by its mean curvature (1.4 eV of rigidity); what defects cost beyond
  // falls with the size.
  EXPECT_LT(built.rest->energy, -7.375);
}

}  // namespace
}  // namespace nanocarbon::building
