// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/building/facing_sheets.h"

#include <gtest/gtest.h>

#include <cmath>

#include "nanocarbon/structures/fullerene.h"
#include "nanocarbon/structures/graphene.h"
#include "nanocarbon/structures/graphite.h"
#include "nanocarbon/structures/onion.h"
#include "nanocarbon/structures/tube.h"

namespace nanocarbon::building {
namespace {

TEST(FacingSheets, TellTheirDistance) {
  const Molecule flake = structures::graphene_flake(8.0);
  Molecule two = flake;
  structures::append(two, flake);
  for (std::size_t a = flake.size(); a < two.size(); ++a) two.positions[a].z() += 2.6;
  EXPECT_NEAR(closest_of_facing_sheets(two, 3.0), 2.6, 1e-9);
  EXPECT_TRUE(std::isinf(closest_of_facing_sheets(two, 2.5)));
}

TEST(FacingSheets, AreNotThereWithinOneSheet) {
  for (const Molecule& m : {structures::graphene_flake(12.0), structures::fullerene(1, 0),
                            structures::fullerene(1, 1), structures::open_tube(5, 5, 20.0)})
    EXPECT_TRUE(std::isinf(closest_of_facing_sheets(m, 3.0)));
}

TEST(FacingSheets, FaceEachOtherAcrossTheCellToo) {
  Molecule m = structures::graphite({5, 3, 2}, structures::Stacking::aa, {1.42, 3.4}, false);
  EXPECT_TRUE(std::isinf(closest_of_facing_sheets(m, 3.0)));
  m.cell->vectors(2, 2) -= 0.7;  // from the upper layer to the image of the lower one
  EXPECT_NEAR(closest_of_facing_sheets(m, 3.0), 2.7, 1e-9);
}

}  // namespace
}  // namespace nanocarbon::building
