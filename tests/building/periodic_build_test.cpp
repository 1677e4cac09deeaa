// SPDX-License-Identifier: GPL-2.0-or-later
// Molecules on surfaces in a periodic cell, made by the annealed recipe.
#include <gtest/gtest.h>

#include <algorithm>

#include "nanocarbon/building/build_molecule.h"
#include "nanocarbon/core/error.h"
#include "nanocarbon/mesh/join_points.h"
#include "nanocarbon/mesh/mesh_topology.h"
#include "nanocarbon/mesh/periodic_mesh.h"
#include "nanocarbon/molecule/molecule_graph.h"
#include "nanocarbon/potential/rebo2/rebo2.h"
#include "nanocarbon/shapes/formula_surface.h"
#include "nanocarbon/shapes/periodic_shapes.h"
#include "nanocarbon/structures/schwarzite_family.h"
#include "nanocarbon/structures/tube.h"
#include "nanocarbon/topology/surface_topology.h"

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

double energy_of(const Molecule& m) {
  rebo2::Rebo2 potential;
  return potential.evaluate(m.positions, m.elements, &*m.cell, {}).energy / static_cast<double>(m.size());
}

// What has no defects is the same in several cells as in one.
TEST(PeriodicBuild, SeveralCellsAsOneGiveWhatOneGives) {
  struct Case {
    std::string surface;
    Vec3 period;
    std::array<bool, 3> periodic;
    std::array<int, 3> cells;
  };
  for (const Case& c : {Case{"z", Vec3(22, 25, 20), {true, true, false}, {2, 2, 1}},
                        {"sqrt(x^2 + y^2) - 6.785", Vec3(30, 30, 12.3), {false, false, true}, {1, 1, 2}}}) {
    SCOPED_TRACE(c.surface);
    const TriangleMesh one = formula(c.surface, c.period, c.periodic);
    const TriangleMesh several = mesh::repeated(one, c.cells);
    const auto copies = static_cast<std::size_t>(c.cells[0] * c.cells[1] * c.cells[2]);
    BuildOptions options = drafts(200);
    options.relax_cell = minimisation::CellRelaxation::triclinic;
    const Molecule in_one = build_molecule(one, options).molecule;
    options.size = AtomCount{copies * in_one.size()};
    const Molecule in_several = build_molecule(several, options).molecule;
    EXPECT_EQ(in_several.size(), copies * in_one.size());
    expect_hexagons(in_several);
    EXPECT_NEAR(energy_of(in_several), energy_of(in_one), 1e-5);
    // By coordinates, beside each other.
    const Molecule copied = structures::repeated(in_one, c.cells);
    EXPECT_EQ(copied.bonds.size(), copies * in_one.bonds.size());
    EXPECT_NEAR(energy_of(copied), energy_of(in_one), 1e-9);
  }
}

TEST(PeriodicBuild, ASheetInASkewedCellBecomesGraphene) {
  shapes::FormulaSurface surface;
  surface.formula = "z";
  surface.cell.vectors << 31, 12, 0, 0, 29, 0, 0, 0, 20;
  surface.cell.periodic = {true, true, false};
  surface.edge = 1;
  BuildOptions options = drafts(340);
  options.relax_cell = minimisation::CellRelaxation::triclinic;
  const Molecule sheet = build_molecule(shapes::make_formula_surface(surface), options).molecule;
  expect_hexagons(sheet);
  EXPECT_NEAR(energy_of(sheet), graphene, 1e-4);
}

TriangleMesh sheet_with_a_hole() {
  TriangleMesh sheet = formula("z", Vec3(36, 36, 20), {true, true, false});
  const Vec3 middle = sheet.space.cell()->origin;  // the hole is cut by the corners of the cell
  std::erase_if(sheet.triangles, [&](const Triangle& t) {
    const auto [a, b, c] = corners_of(sheet, t);
    return sheet.space.displacement(middle, (a + b + c) / 3).head<2>().norm() < 7;
  });
  mesh::drop_unused_points(sheet);
  return sheet;
}

// A torus with a hole, which counts one ring fewer than closed.
void expect_holed_torus(const Molecule& m) {
  const auto topology = topology::surface_topology(molecule::embedded_graph(m));
  EXPECT_FALSE(topology.problem);
  EXPECT_EQ(topology.genus, 1);
  EXPECT_EQ(topology.boundary_loops, 1);
}

std::vector<int> degrees(const Molecule& m) {
  std::vector<int> degree(m.size(), 0);
  for (const Bond& bond : m.bonds) ++degree[bond.first], ++degree[bond.second];
  return degree;
}

TEST(PeriodicBuild, AHoleInASheetKeepsItsBoundaryBare) {
  ASSERT_EQ(mesh::mesh_topology(sheet_with_a_hole()).boundary_loops, 1u);
  BuildOptions options = drafts(450);
  options.boundary = Boundary::bare;
  const BuildResult result = build_molecule(sheet_with_a_hole(), options);
  const Molecule& m = result.molecule;
  EXPECT_TRUE(result.rest->intact);
  const std::vector<int> degree = degrees(m);
  EXPECT_EQ(std::count(degree.begin(), degree.end(), 3) + std::count(degree.begin(), degree.end(), 2),
            static_cast<long>(m.size()));
  EXPECT_GT(std::count(degree.begin(), degree.end(), 2), 10);
  expect_holed_torus(m);
  EXPECT_LT(1e3 * (energy_of(m) - graphene), 600) << "a dangling bond costs 2.5 eV or so";
}

TEST(PeriodicBuild, AHoleInASheetTakesHydrogen) {
  BuildOptions options = drafts(450);
  options.boundary = Boundary::hydrogen;
  const BuildResult result = build_molecule(sheet_with_a_hole(), options);
  const Molecule& m = result.molecule;
  EXPECT_TRUE(result.rest->intact);
  const std::vector<int> degree = degrees(m);
  for (AtomIndex a = 0; a < m.size(); ++a)
    EXPECT_EQ(degree[a], m.elements[a] == Element::hydrogen ? 1 : 3);
  EXPECT_GT(std::count(m.elements.begin(), m.elements.end(), Element::hydrogen), 10);
  expect_holed_torus(m);
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
