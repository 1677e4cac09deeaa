// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/building/start_choice.h"

#include <algorithm>

#include "nanocarbon/building/annealed_options.h"

namespace nanocarbon::building {

namespace {

constexpr double near_enough = 1;  // Angstrom

// eV for each atom and Angstrom; more of it for each eV/Angstrom^2 above the default tether. At 0.05 and
// 10,000 atoms the Stanford bunny would be 0.3 Angstrom nearer, at half as much energy again.
constexpr double price_of_distance = 0.03, price_of_tether = 1.0 / 3;

}  // namespace

double cost(const Released& molecule, double tether) {
  const double price = price_of_distance + price_of_tether * std::max(0.0, tether - default_tether);
  const double for_nothing = near_enough * default_tether / tether;
  return molecule.energy + price * std::max(molecule.distance() - for_nothing, 0.0);
}

double Released::distance() const { return std::max(mean_distance, left_out); }

bool is_near(const Released& molecule, double tether) {
  return molecule.distance() * std::min(tether, default_tether) < near_enough * default_tether;
}

bool is_better(const Released& one, const Released& other, double tether) {
  const bool near = is_near(one, tether);
  if (near != is_near(other, tether)) return near;
  return cost(one, tether) < cost(other, tether);
}

}  // namespace nanocarbon::building
