// SPDX-License-Identifier: GPL-2.0-or-later
// Molecules on surfaces in a periodic cell, made by the annealed recipe.
#include <gtest/gtest.h>

#include <algorithm>

#include "nanocarbon/building/build_molecule.h"
#include "nanocarbon/core/error.h"
#include "nanocarbon/mesh/mesh_topology.h"
#include "nanocarbon/mesh/periodic_mesh.h"
#include "nanocarbon/potential/rebo2/rebo2.h"
#include "nanocarbon/shapes/formula_surface.h"
#include "nanocarbon/shapes/periodic_shapes.h"
#include "nanocarbon/structures/tube.h"

namespace nanocarbon::building {
namespace {

constexpr double graphene = -7.394997;

TriangleMesh minimal(shapes::MinimalSurface::Kind kind, bool primitive = false) {
  shapes::MinimalSurface surface;
  surface.kind = kind;
  surface.primitive = primitive;
  return shapes::make_minimal_surface(surface);
}

BuildOptions drafts(std::size_t atoms) {
  BuildOptions options;
  options.size = AtomCount{atoms};
  options.quality = Quality::draft;
  return options;
}

struct Expected {
  shapes::MinimalSurface::Kind kind;
  bool primitive;
  std::int64_t euler;
};

TEST(PeriodicBuild, KeepsTheTopologyOfTheCellAndIsStressFree) {
  using Kind = shapes::MinimalSurface::Kind;
  for (const Expected& e :
       {Expected{Kind::schwarz_p, false, -4}, {Kind::gyroid, true, -4}, {Kind::schwarz_d, true, -4}}) {
    SCOPED_TRACE(shapes::name(e.kind));
    BuildOptions options = drafts(400);
    options.relax_cell = minimisation::CellRelaxation::triclinic;
    const BuildResult result = build_molecule(minimal(e.kind, e.primitive), options);
    const Molecule& m = result.molecule;
    ASSERT_TRUE(m.cell);
    EXPECT_TRUE(result.rest->intact);
    EXPECT_EQ(static_cast<std::int64_t>(m.rings.size()) + static_cast<std::int64_t>(m.size()) -
                  static_cast<std::int64_t>(m.bonds.size()),
              e.euler);
    EXPECT_NEAR(static_cast<double>(m.size()), 400, 20);
    EXPECT_LT(result.annealed->stress.cwiseAbs().maxCoeff(), 1e-4);
    rebo2::Rebo2 potential;
    const double energy =
        potential.evaluate(m.positions, m.elements, &*m.cell, {}).energy / static_cast<double>(m.size());
    EXPECT_NEAR(energy, result.rest->energy, 1e-9);
    EXPECT_LT(1e3 * (energy - graphene), 250);
    // Each bond where it is said to be.
    for (const Bond& bond : m.bonds)
      EXPECT_LT(
          (m.positions[bond.second] + image_shift(*m.cell, bond.image) - m.positions[bond.first]).norm(),
          1.7);
    // Two cells have twice the energy.
    Molecule twice = m;
    twice.cell->vectors.col(0) *= 2;
    for (const Vec3& p : m.positions) twice.positions.push_back(p + m.cell->vectors.col(0));
    twice.elements.resize(twice.positions.size(), Element::carbon);
    EXPECT_NEAR(potential.evaluate(twice.positions, twice.elements, &*twice.cell, {}).energy /
                    static_cast<double>(m.size()),
                2 * energy, 1e-8);
  }
}

TriangleMesh formula(const std::string& text, const Vec3& period, std::array<bool, 3> periodic) {
  shapes::FormulaSurface surface;
  surface.formula = text;
  surface.cell = orthogonal_cell(period, periodic);
  surface.edge = 1;
  return shapes::make_formula_surface(surface);
}

void expect_hexagons(const Molecule& molecule) {
  for (std::size_t r = 0; r < molecule.rings.size(); ++r) EXPECT_EQ(molecule.rings[r].size(), 6u);
}

TEST(PeriodicBuild, ACylinderBecomesATubeWithoutADefect) {
  for (const Quality quality : {Quality::draft, Quality::good}) {
    BuildOptions options = drafts(400);
    options.quality = quality;
    const BuildResult result =
        build_molecule(formula("sqrt(x^2 + y^2) - 6.785", Vec3(30, 30, 24.6), {false, false, true}), options);
    EXPECT_EQ(result.molecule.size(), 400u);
    expect_hexagons(result.molecule);
    Molecule tube = structures::periodic_tube(10, 10, 10);
    rebo2::Rebo2 potential;
    const auto relaxed =
        minimisation::minimise_in_cell(tube, potential, minimisation::CellRelaxation::isotropic);
    EXPECT_NEAR(result.rest->energy, relaxed.minimum.energy / static_cast<double>(tube.size()), 1e-3);
  }
}

TEST(PeriodicBuild, ASheetBecomesGraphene) {
  BuildOptions options = drafts(400);
  options.relax_cell = minimisation::CellRelaxation::triclinic;
  const BuildResult flat = build_molecule(formula("z", Vec3(30, 33, 20), {true, true, false}), options);
  expect_hexagons(flat.molecule);
  EXPECT_NEAR(flat.rest->energy, graphene, 1e-4);
  options.relax_cell.reset();  // or the ripple would go
  const BuildResult rippled = build_molecule(
      formula("z - 1.5*sin(2*pi*x/30)*sin(2*pi*y/33)", Vec3(30, 33, 20), {true, true, false}), options);
  expect_hexagons(rippled.molecule);
  EXPECT_TRUE(rippled.rest->intact);
  double highest = 0;
  for (const Vec3& p : rippled.molecule.positions) highest = std::max(highest, std::abs(p.z()));
  EXPECT_GT(highest, 0.7);
}

TEST(PeriodicBuild, RefusesWhatItDoesNotKnow) {
  const TriangleMesh surface = minimal(shapes::MinimalSurface::Kind::schwarz_p);
  BuildOptions thesis = drafts(400);
  thesis.recipe = Recipe::thesis;
  EXPECT_THROW(build_molecule(surface, thesis), UserError);
  BuildOptions certified = drafts(400);
  certified.certify = true;
  EXPECT_THROW(build_molecule(surface, certified), UserError);
  EXPECT_THROW(build_molecule(surface, drafts(50)), UserError) << "the cell is too narrow";
}

}  // namespace
}  // namespace nanocarbon::building
