#include "nanocarbon/relaxation/cost_of_distance.h"

#include <gtest/gtest.h>

#include "nanocarbon/relaxation/anneal_recipe.h"

namespace nanocarbon {
namespace {

// The promise to users: below 1 Angstrom energy alone counts.
TEST(CostOfDistance, BelowOneAngstromTheLeastEnergyIsBest) {
  EXPECT_LT(cost_of(-7.36, 0.99, default_tether), cost_of(-7.359, 0.1, default_tether));
}

TEST(CostOfDistance, AnAngstromMoreIsWorthThirtyMillielectronvolts) {
  EXPECT_LT(cost_of(-7.371, 2, default_tether), cost_of(-7.34, 1, default_tether));
  EXPECT_GT(cost_of(-7.369, 2, default_tether), cost_of(-7.34, 1, default_tether));
}

TEST(CostOfDistance, AStifferTetherPrefersWhatIsNearer) {
  EXPECT_LT(distance_for_nothing(0.2), distance_for_nothing(default_tether));
  EXPECT_LT(cost_of(-7.36, 0.9, default_tether), cost_of(-7.34, 0.5, default_tether));
  EXPECT_GT(cost_of(-7.36, 0.9, 0.2), cost_of(-7.34, 0.5, 0.2));
}

// A soft tether asks for low energy, but not for any distance.
TEST(CostOfDistance, ASofterTetherChangesNothing) {
  for (const double distance : {0.5, 1.5})
    EXPECT_EQ(cost_of(-7.36, distance, 0.01), cost_of(-7.36, distance, default_tether));
}

}  // namespace
}  // namespace nanocarbon
