// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/building/likeness.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "nanocarbon/building/build_molecule.h"
#include "nanocarbon/mesh/measures.h"
#include "nanocarbon/mesh/triangulate.h"
#include "nanocarbon/shapes/periodic_shapes.h"
#include "nanocarbon/structures/fullerene.h"
#include "remeshing/shapes.h"
#include "support/small_meshes.h"

namespace nanocarbon::building {
namespace {

constexpr double area_per_atom = 2.6195;  // square Angstrom

// A (10,10) tube has a radius of 6.78 Angstrom and 0.039 eV an atom above graphene under REBO2.
TEST(Likeness, ATubeCostsWhatItsCurvatureDoes) {
  const TriangleMesh tube = test::open_tube(6.78, 100, 60, 140);
  const double atoms = mesh::area(tube) / area_per_atom;
  const double ends = 1.2 * 2 * 2 * std::numbers::pi * 6.78;
  EXPECT_NEAR(expected_energy(tube, static_cast<std::size_t>(atoms), Boundary::bare) - ends / atoms, 0.039,
              0.004);
}

// Whole energies above graphene, eV, under REBO2: of C240, C540 and a cage of 9,920 atoms (8.4 meV each).
TEST(Likeness, ASphereCostsWhatFullerenesDo) {
  struct Known {
    double atoms, energy;
  };
  for (const auto& [atoms, energy] : {Known{240, 48}, {540, 54}, {9920, 83}}) {
    const double radius = std::sqrt(atoms * area_per_atom / (4 * std::numbers::pi));
    EXPECT_NEAR(expected_energy(test::sphere(radius, 5), 1), energy, 0.2 * energy) << atoms;
  }
}

// Schwarz's P surface, nearly, with the lattice constants and energies of P192, P432 and P768, eV an atom.
TEST(Likeness, ASaddleCostsWhatSchwarzitesDo) {
  struct Known {
    double atoms, edge, energy;
  };
  for (const auto& [atoms, edge, energy] :
       {Known{192, 14.9113, 0.11566}, {432, 21.9941, 0.07719}, {768, 29.0204, 0.05666}}) {
    const TriangleMesh surface = shapes::make_minimal_surface(
        {.kind = shapes::MinimalSurface::Kind::schwarz_p, .period = edge, .edge = 1.0});
    EXPECT_NEAR(expected_energy(surface, static_cast<std::size_t>(atoms)), energy, 0.3 * energy) << atoms;
  }
}

// A sheet that is bent by next to nothing both ways is stretched by less than a pentagon costs.
TEST(Likeness, AShallowCapCostsLessThanTheShareOfAPentagon) {
  const double a = 12, radius = 60;
  TriangleMesh cap = test::sheet(2 * a, 2 * a, 24, 24);
  for (Vec3& p : cap.points)
    p.z() = std::sqrt(radius * radius - std::pow(p.x() - a, 2) - std::pow(p.y() - a, 2));
  const double share = 4 * a * a / (radius * radius) / (std::numbers::pi / 3);
  EXPECT_LT(expected_energy(cap, 1) - 0.01 * 8 * a, 0.3 * share * 5);
}

TEST(Likeness, AMoleculeOnItsSurfaceIsLikeIt) {
  const Molecule molecule = structures::fullerene(3, 3);  // C540, 0.100 eV an atom above graphene
  double radius = 0;
  for (const Vec3& p : molecule.positions) radius += p.norm() / static_cast<double>(molecule.size());
  const Likeness like = likeness(molecule, test::sphere(radius, 4), 0.100);
  EXPECT_LT(like.distance_share, 0.05);
  EXPECT_NEAR(like.shape_radius, radius, 0.01 * radius);
  EXPECT_GT(like.energy_share, 0.3);
  EXPECT_LT(like.energy_share, 1.5);
  EXPECT_FALSE(like.far() || like.strained());
  EXPECT_THAT(like.warnings(), testing::IsEmpty());
}

TEST(Likeness, OneThatIsFarOrStrainedIsTold) {
  const Molecule molecule = structures::fullerene(3, 3);
  const Likeness far = likeness(molecule, test::sphere(16, 4), 0.1);
  EXPECT_TRUE(far.far());
  EXPECT_THAT(far.warnings(), testing::ElementsAre(testing::HasSubstr("only roughly")));
  const Likeness strained = likeness(molecule, test::sphere(10.5, 4), 1.6);
  EXPECT_TRUE(strained.strained());
  EXPECT_THAT(strained.warnings(), testing::ElementsAre(testing::HasSubstr("1600 meV per atom")));
}

// A ball with a thin finger, and a molecule of the ball alone: no atom is far from the surface.
TEST(Likeness, WhatTheMoleculeLeavesOutOfTheSurfaceIsTold) {
  const Molecule molecule = structures::fullerene(3, 3);
  double radius = 0;
  for (const Vec3& p : molecule.positions) radius += p.norm() / static_cast<double>(molecule.size());
  TriangleMesh surface = test::sphere(radius, 4);
  for (Vec3& p : surface.points)
    if (p.z() > 0.9 * radius) p.z() += 25 * radius * (p.z() / radius - 0.9);
  const Likeness like = likeness(molecule, surface, 0.1);
  EXPECT_LT(like.distance_there, 0.5);
  EXPECT_GT(like.distance_back, 2);
  EXPECT_EQ(like.distance(), like.distance_back);
  EXPECT_THAT(like.warnings(), testing::ElementsAre(testing::HasSubstr("the surface lies")));
}

// A cage of so few atoms that it is as round whatever it was to be.
TEST(Likeness, AShapeThatIsRoundedOffIsTold) {
  const Molecule cage = structures::fullerene(1, 1);  // C60
  const double area = 60 * area_per_atom;
  TriangleMesh cube = mesh::triangulate(test::cube(Vec3::Zero())).mesh;
  for (Vec3& p : cube.points) p = (p - Vec3::Constant(0.5)) * std::sqrt(area / 6);
  const Likeness rounded = likeness(cage, cube, 0.4);
  EXPECT_NEAR(rounded.from_sphere, 0.12 * rounded.shape_radius, 0.03 * rounded.shape_radius);
  EXPECT_TRUE(rounded.rounded());
  EXPECT_THAT(rounded.warnings(), testing::ElementsAre(testing::HasSubstr("rounded off")));
  const Likeness ball = likeness(cage, test::sphere(std::sqrt(area / (4 * std::numbers::pi)), 3), 0.4);
  EXPECT_LT(ball.from_sphere, 0.01 * ball.shape_radius);
  EXPECT_THAT(ball.warnings(), testing::IsEmpty());
}

//! A gear about the z axis: so many teeth that reach out from the radius by the depth.
TriangleMesh gear(int teeth, double radius, double depth, double height) {
  mesh::PolygonSoup soup;
  std::vector<Vec3> outline;
  for (int tooth = 0; tooth < teeth; ++tooth)
    for (const auto& [turn, reach] : {std::pair{0.0, 0.0}, {0.45, 0.0}, {0.5, depth}, {0.95, depth}}) {
      const double angle = 2 * std::numbers::pi * (tooth + turn) / teeth, r = radius + reach;
      outline.emplace_back(r * std::cos(angle), r * std::sin(angle), 0);
    }
  const auto around = static_cast<VertexIndex>(outline.size());
  for (const double z : {-0.5 * height, 0.5 * height})
    for (const Vec3& p : outline) soup.points.push_back(p + Vec3(0, 0, z));
  soup.points.insert(soup.points.end(), {Vec3(0, 0, -0.5 * height), Vec3(0, 0, 0.5 * height)});
  for (VertexIndex i = 0; i < around; ++i) {
    const VertexIndex next = (i + 1) % around;
    for (const Triangle& t : {Triangle{i, next, around + next},
                              {i, around + next, around + i},
                              {2 * around, next, i},
                              {2 * around + 1, around + i, around + next}}) {
      soup.corners.insert(soup.corners.end(), t.begin(), t.end());
      soup.close_face();
    }
  }
  return mesh::triangulate(soup).mesh;
}

BuildResult draft(const TriangleMesh& surface, std::size_t atoms) {
  BuildOptions options;
  options.size = AtomCount{atoms};
  options.quality = Quality::draft;
  options.force = true;
  return build_molecule(surface, options);
}

// Its atoms lie near the surface and its distance from a sphere is a cylinder's; but the teeth are gone.
TEST(Likeness, AGearThatLostItsTeethIsTold) {
  const Likeness smooth = *draft(gear(12, 0.8, 0.2, 0.5), 240).likeness;
  EXPECT_GT(smooth.turned_away, turned_away_to_warn);
  EXPECT_THAT(smooth.warnings(), testing::Not(testing::IsEmpty()));
  // Larger, it would not be told by the distance, nor by how near a sphere is.
  Likeness larger = smooth;
  larger.from_sphere *= 2;
  EXPECT_THAT(larger.warnings(), testing::ElementsAre(testing::HasSubstr("detail of the shape")));
  larger.turned_away = turned_away_to_warn;
  EXPECT_THAT(larger.warnings(), testing::IsEmpty());
  // Of four wide teeth with as many atoms as it takes.
  const Likeness toothed = *draft(gear(4, 0.6, 0.4, 0.8), 1500).likeness;
  EXPECT_LT(toothed.turned_away, turned_away_to_warn);
  EXPECT_THAT(toothed.warnings(), testing::Not(testing::Contains(testing::HasSubstr("detail of the shape"))));
}

// Edges that are rounded, as all are, turn by half their angle.
TEST(Likeness, ARoundedBoxLacksNoDetail) {
  const double area = 60 * area_per_atom;
  TriangleMesh cube = mesh::triangulate(test::cube(Vec3::Zero())).mesh;
  for (Vec3& p : cube.points) p = (p - Vec3::Constant(0.5)) * std::sqrt(area / 6);
  EXPECT_LT(likeness(structures::fullerene(1, 1), cube, 0.4).turned_away, 0.02);
}

}  // namespace
}  // namespace nanocarbon::building
