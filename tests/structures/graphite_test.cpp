// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/structures/graphite.h"

#include <gmock/gmock.h>

#include "nanocarbon/core/error.h"
#include "nanocarbon/potential/airebo/airebo.h"
#include "structures/facts.h"

namespace nanocarbon::structures {
namespace {

using test::facts;
using test::Facts;
using testing::ElementsAre;
using testing::Pair;

// LAMMPS's pair_style airebo and airebo/morse, minimised with fix box/relax; eV/atom.
TEST(Graphite, IsAtTheMinimumOfAireboAsLammpsHasIt) {
  struct Case {
    Stacking stacking;
    bool morse;
    double energy;
  };
  for (const Case& c : {Case{Stacking::ab, false, -7.4771092196},
                        {Stacking::ab, true, -7.4506152157},
                        {Stacking::aa, false, -7.4761901320},
                        {Stacking::aa, true, -7.4497028479}}) {
    const Molecule m = graphite({2, 2, 2}, c.stacking, graphite_lattice(c.stacking, c.morse), false);
    airebo::Airebo airebo(c.morse ? airebo::airebo_m_parameters() : airebo::airebo_parameters());
    const airebo::AireboResult& r = airebo.evaluate(m.positions, m.elements, &*m.cell);
    const auto atoms = static_cast<double>(m.size());
    EXPECT_NEAR(r.energy / atoms, c.energy, 1e-9);
    for (const Vec3& f : r.forces) EXPECT_LT(f.norm(), 1e-6);
    EXPECT_LT(r.virial.cwiseAbs().maxCoeff() / atoms, 1e-5);
  }
}

TEST(Graphite, LayersAreSheetsOfHexagonsThatAreNotBonded) {
  for (const bool slab : {false, true})
    for (const Stacking stacking : {Stacking::ab, Stacking::aa}) {
      const GraphiteLattice lattice = graphite_lattice(stacking, false);
      const Molecule m = graphite({3, 2, 4}, stacking, lattice, slab);
      const Facts f = facts(m);
      EXPECT_EQ(m.size(), 4u * 3 * 2 * 4);
      EXPECT_THAT(f.coordination, ElementsAre(Pair(3, m.size())));
      EXPECT_THAT(f.rings, ElementsAre(Pair(6, m.size() / 2)));
      EXPECT_NEAR(f.longest_bond, lattice.bond, 1e-9);
      EXPECT_EQ(m.cell->periodic[2], !slab);
    }
}

TEST(Graphite, TakesTheNearestNumberOfCells) {
  const GraphiteSize size = graphite_size(24.0, 42.0, 6, {1.4, 3.4});
  EXPECT_EQ(size.cells_x, 10);
  EXPECT_EQ(size.cells_y, 10);
  EXPECT_EQ(size.layers, 6);
}

TEST(Graphite, OddLayersAbDoNotRepeat) {
  const GraphiteLattice lattice = graphite_lattice(Stacking::ab, false);
  EXPECT_THROW(graphite({1, 1, 3}, Stacking::ab, lattice, false), UserError);
  EXPECT_EQ(graphite({1, 1, 3}, Stacking::ab, lattice, true).size(), 12u);
  EXPECT_EQ(graphite({1, 1, 3}, Stacking::aa, lattice, false).size(), 12u);
  EXPECT_THROW(graphite({1, 0, 2}, Stacking::ab, lattice, false), UserError);
}

}  // namespace
}  // namespace nanocarbon::structures
