#include "nanocarbon/relaxation/cost_of_distance.h"

#include <algorithm>

#include "nanocarbon/relaxation/anneal_recipe.h"

namespace nanocarbon {

namespace {

// Angstrom; eV for each atom and Angstrom; more of the latter for each eV/Angstrom^2 above the default
// tether. At 0.05 and 10,000 atoms the Stanford bunny would be 0.3 Angstrom nearer, at half as much energy
// again.
constexpr double kForNothing = 1, kPrice = 0.03, kTetherPrice = 1.0 / 3;

}  // namespace

double distance_for_nothing(double tether) { return kForNothing * std::min(1.0, default_tether / tether); }

double cost_of(double energy, double mean_distance, double tether) {
  const double price = kPrice + kTetherPrice * std::max(0.0, tether - default_tether);
  return energy + price * std::max(mean_distance, distance_for_nothing(tether));
}

}  // namespace nanocarbon
