// SPDX-License-Identifier: GPL-2.0-or-later
// The surfaces that topology knows, and that they are recognised however their atoms lie.
#include <gtest/gtest.h>

#include <cctype>
#include <functional>
#include <numeric>
#include <string>
#include <vector>

#include "molecule/cases.h"
#include "molecule/shapes.h"
#include "nanocarbon/molecule/dual.h"
#include "nanocarbon/structures/fullerene.h"
#include "nanocarbon/structures/graphene.h"
#include "nanocarbon/structures/schwarzite.h"
#include "nanocarbon/structures/tube.h"
#include "nanocarbon/topology/surface_topology.h"

namespace nanocarbon::topology {
namespace {

using test::topology;

Molecule sheet_with_two_holes() {
  const auto at = [](int i, int j) { return static_cast<VertexIndex>(i + 15 * j); };
  return molecule::dual(test::scaled_to_carbon(
      test::without_vertices(test::sheet(14, 8), {at(4, 4), at(5, 4), at(10, 4), at(10, 3)})));
}

struct Known {
  const char* name;
  std::function<Molecule()> make;
  ComponentTopology component;
  double hottest = 0.15;  // standard deviation of each coordinate that it must be recognised at, Angstrom
};

std::ostream& operator<<(std::ostream& out, const Known& known) { return out << known.name; }

// Genus and boundary loops as topology knows them. For one-sided surfaces: 2 - chi cross-caps.
const std::vector<Known>& known_surfaces() {
  static const std::vector<Known> list = {
      {"C20", [] { return structures::fullerene(1, 0); }, {true, true, 0, 0}},
      {"C60", [] { return structures::fullerene(1, 1); }, {true, true, 0, 0}},
      {"C540", [] { return structures::fullerene(3, 3); }, {true, true, 0, 0}},
      {"open (10,10) tube", [] { return structures::open_tube(10, 10, 20.0); }, {true, true, 0, 2}},
      {"periodic (10,10) tube", [] { return structures::periodic_tube(10, 10, 3); }, {true, true, 1, 0}},
      {"periodic (10,10) tube of one period",
       [] { return structures::periodic_tube(10, 10, 1); },
       {true, true, 1, 0}},
      {"periodic (4,1) tube", [] { return structures::periodic_tube(4, 1, 1); }, {true, true, 1, 0}},
      {"periodic graphene", [] { return structures::graphene(6, 4); }, {true, true, 1, 0}},
      {"flake", [] { return structures::graphene_flake(12.0); }, {true, true, 0, 1}},
      {"torus",
       [] { return molecule::dual(test::scaled_to_carbon(test::torus(24, 60, 3.0, 1.0))); },
       {true, true, 1, 0}},
      // The bonds of these and of the Klein bottle are uneven, down to half an Angstrom: noise turns them
      // further.
      {"genus 2", [] { return test::handles(2); }, {true, true, 2, 0}, 0.1},
      {"genus 3", [] { return test::handles(3); }, {true, true, 3, 0}, 0.1},
      {"sheet with two holes", sheet_with_two_holes, {true, true, 0, 3}},
      {"band", [] { return test::twisted_band(0); }, {true, true, 0, 2}},
      {"Moebius band", [] { return test::twisted_band(1); }, {true, false, 1, 1}},
      {"band with a full twist", [] { return test::twisted_band(2); }, {true, true, 0, 2}},
      {"band with three half twists", [] { return test::twisted_band(3); }, {true, false, 1, 1}},
      {"Klein bottle", test::klein_bottle, {true, false, 2, 0}, 0.1},
      // Schwarz's D and P surfaces have genus 3, chi -4, in the cell whose translations keep their sides.
      // P688's cubic cell is that one, D688's is half of it and one-sided. At rest D688's bonds are
      // already twisted by 70 degrees, so that hot ones pass the right angle.
      {"D688", [] { return structures::schwarzite_d688(1, 1, 1); }, {true, false, 4, 0}, 0.1},
      {"D688, eight cells", [] { return structures::schwarzite_d688(2, 2, 2); }, {true, true, 9, 0}, 0.1},
      {"P688", [] { return structures::schwarzite_p688(1, 1, 1); }, {true, true, 3, 0}},
      {"P688, eight cells", [] { return structures::schwarzite_p688(2, 2, 2); }, {true, true, 17, 0}},
  };
  return list;
}

class KnownSurface : public testing::TestWithParam<Known> {
 protected:
  static void expect_known(const SurfaceTopology& s) {
    ASSERT_FALSE(s.problem) << s.problem->reason;
    const ComponentTopology& known = GetParam().component;
    ASSERT_EQ(s.components.size(), 1u);
    EXPECT_EQ(s.components[0].orientable, known.orientable);
    EXPECT_EQ(s.components[0].genus, known.genus);
    EXPECT_EQ(s.components[0].boundary_loops, known.boundary_loops);
    EXPECT_TRUE(s.components[0].has_rings);
    EXPECT_EQ(s.euler_characteristic, known.euler_characteristic());
  }
};

TEST_P(KnownSurface, IsRecognised) { expect_known(topology(GetParam().make())); }

TEST_P(KnownSurface, IsRecognisedInAnyOrientationAndOrder) {
  const Molecule molecule = GetParam().make();
  for (const std::uint64_t seed : {1, 2, 3})
    expect_known(topology(test::turned_and_shuffled(molecule, seed)));
}

TEST_P(KnownSurface, IsRecognisedInThermalMotion) {
  // Graphite's atoms move by 0.1 Angstrom (standard deviation) out of their planes at about 1000 K.
  const Molecule molecule = GetParam().make();
  for (const double deviation : {0.05, 0.1, 0.15})
    for (const std::uint64_t seed : {1, 2, 3})
      if (deviation <= GetParam().hottest) expect_known(topology(test::rattled(molecule, deviation, seed)));
}

// Where atoms are so far out of place that a surface cannot be told, that is said; a wrong one never is
// (but for D688, one cell: there 4 of 100 are wrong at 0.2 Angstrom).
TEST_P(KnownSurface, IsRecognisedOrRefusedWhenAtomsAreFarOutOfPlace) {
  const std::string name = GetParam().name;
  if (name.starts_with("D688")) GTEST_SKIP() << "bonds at rest are twisted by 70 degrees already";
  const Molecule molecule = GetParam().make();
  for (const double deviation : {0.2, 0.25, 0.3})
    for (const std::uint64_t seed : {1, 2, 3, 4, 5, 6}) {
      const SurfaceTopology s = topology(test::rattled(molecule, deviation, seed));
      if (!s.problem) expect_known(s);
    }
}

TEST_P(KnownSurface, HasTheEulerCharacteristicOfItsRings) {
  const Molecule molecule = GetParam().make();
  const SurfaceTopology s = topology(molecule);
  EXPECT_EQ(s.euler_characteristic, static_cast<int>(molecule.size()) -
                                        static_cast<int>(molecule.bonds.size()) +
                                        static_cast<int>(s.rings.size()));
  EXPECT_EQ(std::accumulate(s.ring_counts.begin(), s.ring_counts.end(), std::size_t{0}), s.rings.size());
}

INSTANTIATE_TEST_SUITE_P(SurfaceTopology, KnownSurface, testing::ValuesIn(known_surfaces()),
                         [](const auto& test_case) {
                           std::string name;
                           for (const char c : std::string(test_case.param.name))
                             if (std::isalnum(static_cast<unsigned char>(c))) name += c;
                           return name;
                         });

}  // namespace
}  // namespace nanocarbon::topology
