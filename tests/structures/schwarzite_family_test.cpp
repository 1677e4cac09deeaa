// SPDX-License-Identifier: GPL-2.0-or-later
// Schwarzites by name: what can be counted on them, and their energies at rest by other programs.
#include "nanocarbon/structures/schwarzite_family.h"

#include <gmock/gmock.h>

#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "nanocarbon/core/error.h"
#include "nanocarbon/minimisation/cell_minimum.h"
#include "nanocarbon/potential/rebo2/rebo2.h"
#include "nanocarbon/structures/schwarzite.h"
#include "structures/facts.h"
#include "support/refusal.h"

namespace nanocarbon::structures {
namespace {

using test::facts;
using test::Facts;
using testing::HasSubstr;

constexpr double graphene = -7.394997;  // eV for each atom

// Lengths of the cube's edge, Angstrom, and energies above graphene, meV an atom, from LAMMPS's pair_style rebo with
// fix box/relax tri.
struct Known {
  std::string name;
  std::size_t atoms;
  std::map<std::size_t, std::size_t> rings;
  long euler;
  double edge, energy;
};

const Known known[] = {
    {"p144", 144, {{6, 56}, {8, 12}}, -4, 12.9849, 141.64},
    {"p192", 192, {{6, 80}, {8, 12}}, -4, 14.9113, 115.66},
    {"p432", 432, {{6, 200}, {8, 12}}, -4, 21.9941, 77.19},
    {"p576", 576, {{6, 272}, {8, 12}}, -4, 25.2520, 68.47},
    {"d144", 144, {{6, 56}, {8, 12}}, -4, 14.4341, 156.56},
    {"d192", 192, {{6, 80}, {8, 12}}, -4, 16.5810, 152.57},
    {"g288", 288, {{6, 112}, {8, 24}}, -8, 16.0308, 143.06},
    {"g384", 384, {{6, 160}, {8, 24}}, -8, 18.4116, 135.82},
    {"d168", 168, {{6, 56}, {7, 24}}, -4, 21.959, 152.20},
    {"d224", 224, {{6, 84}, {7, 24}}, -4, 25.287, 127.48},
};
const Known large[] = {{"p768", 768, {{6, 368}, {8, 12}}, -4, 29.0204, 56.66},
                       {"p1728", 1728, {{6, 848}, {8, 12}}, -4, 0, 34.8},
                       {"p2304", 2304, {{6, 1136}, {8, 12}}, -4, 0, 29.3}};
// The networks that are subdivided.
const Known networks[] = {{"p48", 48, {{6, 8}, {8, 12}}, -4, 7.8006, 276.14},
                          {"d48", 48, {{6, 8}, {8, 12}}, -4, 8.5751, 149.31},
                          {"g96", 96, {{6, 16}, {8, 24}}, -8, 9.6011, 239.42},
                          {"d56", 56, {{7, 24}}, -4, 13.121, 240.59}};

void expect_counts(const Known& k, const Molecule& molecule) {
  const Facts f = facts(molecule);
  EXPECT_EQ(molecule.size(), k.atoms);
  EXPECT_EQ(f.coordination, (std::map<std::size_t, std::size_t>{{3, k.atoms}}));
  EXPECT_EQ(f.rings, k.rings);
  EXPECT_EQ(f.euler_characteristic, k.euler);
  EXPECT_TRUE(f.bonds_sorted && f.rings_follow_bonds && f.sides_agree);
}

// On D the cell is the primitive one, a quarter of the cube. (The table's length for octagons there is that of the
// primitive cell's edges.)
double edge_of(const Known& k, const Cell& cell) {
  return k.name[0] == 'd' && k.rings.contains(8) ? cell.vectors.col(0).norm()
         : k.name[0] == 'd'                      ? std::cbrt(4 * volume(cell))
                                                 : std::cbrt(volume(cell));
}

void expect_energy(const Known& k, Molecule molecule) {
  rebo2::Rebo2 potential;
  const auto relaxed =
      minimisation::minimise_in_cell(molecule, potential, minimisation::CellRelaxation::triclinic);
  EXPECT_TRUE(relaxed.minimum.converged);
  const double energy = relaxed.minimum.energy / static_cast<double>(molecule.size());
  EXPECT_NEAR(1e3 * (energy - graphene), k.energy, 0.1);
  if (k.edge > 0) {
    EXPECT_NEAR(edge_of(k, *molecule.cell), k.edge, 0.01);
  }
  EXPECT_EQ(facts(molecule).coordination, (std::map<std::size_t, std::size_t>{{3, k.atoms}}));
}

TEST(SchwarziteFamily, MembersHaveTheCountsOfTheirSurfaceAndTheKnownEnergies) {
  for (const Known& k : known) {
    SCOPED_TRACE(k.name);
    const Molecule molecule = schwarzite(k.name);
    expect_counts(k, molecule);
    expect_energy(k, molecule);
  }
}

TEST(SchwarziteFamily, LargeMembersHaveTheKnownEnergies) {
  for (const Known& k : large) {
    SCOPED_TRACE(k.name);
    const Molecule molecule = schwarzite(k.name);
    expect_counts(k, molecule);
    expect_energy(k, molecule);
  }
}

TEST(SchwarziteFamily, NetworksAreAtRest) {
  for (const Known& k : networks) {
    SCOPED_TRACE(k.name);
    const Molecule molecule = schwarzite(k.name);
    expect_counts(k, molecule);
    rebo2::Rebo2 potential;
    const auto& at = potential.evaluate(molecule.positions, molecule.elements, &*molecule.cell, {});
    for (const Vec3& force : at.forces) EXPECT_LT(force.norm(), 2e-3);
    expect_energy(k, molecule);
  }
}

TEST(SchwarziteFamily, SeveralCellsAreAsManyTimesTheSame) {
  Molecule one = schwarzite("d56");
  const Molecule eight = repeated(one, {2, 2, 2});
  EXPECT_EQ(facts(eight).rings, (std::map<std::size_t, std::size_t>{{7, 192}}));
  rebo2::Rebo2 potential;
  const double energy = potential.evaluate(one.positions, one.elements, &*one.cell, {}).energy;
  EXPECT_NEAR(potential.evaluate(eight.positions, eight.elements, &*eight.cell, {}).energy, 8 * energy, 1e-8);
}

TEST(SchwarziteFamily, OtherNamesAreRefused) {
  for (const std::string name : {"", "p", "x192", "p0", "p100", "p96", "g48", "d57", "p192x", "p-192", "192"})
    test::refusal(Failure::usage, [&] { schwarzite(name); });
  EXPECT_THAT(test::refusal(Failure::usage, [] { schwarzite("d100"); }),
              HasSubstr("48, 144, 192, 336, 432, 576, 624, ..., 56, 168, 224"));
  test::refusal(Failure::usage, [] { schwarzite("p4800000000"); });
}

}  // namespace
}  // namespace nanocarbon::structures
