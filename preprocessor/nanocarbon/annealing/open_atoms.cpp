// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/annealing/open_atoms.h"

#include <algorithm>
#include <cmath>

#include "nanocarbon/potential/rebo2/angular_spline.h"
#include "nanocarbon/potential/rebo2/coordination_tables.h"
#include "nanocarbon/potential/rebo2/pair_terms.h"

namespace nanocarbon::annealing {

namespace {

// Between nearly straight bonds hydrogen has no direction; keeps slopes finite.
constexpr double least_half_square = 1e-4;

struct Constants {
  double p_cc, p_ch, pi_ch;      // splines at whole coordination numbers
  double repulsion, attraction;  // of the bond to hydrogen, eV
};

double angular(double cosine) {
  return rebo2::angular_carbon_few(rebo2::rebo2_parameters().carbon, cosine).value;
}

double half_order(double sum) { return 1 / std::sqrt(1 + sum); }

// A hydrogen's own half of the bond order is 1: it has no other neighbour.
double order_of_hydrogen(const Constants& c, double sum) {
  return 0.5 * (half_order(sum + c.p_ch) + 1) + c.pi_ch;
}

Constants make_constants() {
  const rebo2::Rebo2Parameters& parameters = rebo2::rebo2_parameters();
  const rebo2::CoordinationTables& tables = parameters.tables;
  // N_conj = 1 + 2^2: two unsaturated carbons on one side, none on the other.
  Constants c = {tables.p_cc.evaluate(1, 1).value, tables.p_ch.evaluate(2, 0).value,
                 tables.f_ch.evaluate(2, 0, 5).value, 0, 0};
  const rebo2::PairParameters& pair = parameters.pairs[rebo2::pair_index(Element::carbon, Element::hydrogen)];
  const double order = order_of_hydrogen(c, 2 * angular(-0.5));
  // The length at rest where all angles are 120 degrees, by bisection.
  double low = 0.9, high = 1.3;
  for (int k = 0; k < 60; ++k) {
    const double r = 0.5 * (low + high);
    const double slope = rebo2::pair_repulsion(pair, r).slope + order * rebo2::pair_attraction(pair, r).slope;
    (slope < 0 ? low : high) = r;
  }
  c.repulsion = rebo2::pair_repulsion(pair, low).value;
  c.attraction = rebo2::pair_attraction(pair, low).value;
  return c;
}

const Constants& constants() {
  static const Constants c = make_constants();
  return c;
}

}  // namespace

OpenAtom open_atom(double cosine) {
  const Constants& c = constants();
  const rebo2::CarbonAngles& carbon = rebo2::rebo2_parameters().carbon;
  const rebo2::ValueSlope between = rebo2::angular_carbon_few(carbon, cosine);
  const double to_hydrogen = -std::sqrt(std::max(0.5 * (1 + cosine), least_half_square));
  const rebo2::ValueSlope beside = rebo2::angular_carbon_few(carbon, to_hydrogen);
  const double beside_slope = beside.slope / (4 * to_hydrogen);
  OpenAtom atom;
  atom.angular_sum = between.value + beside.value + c.p_cc;
  atom.by_cosine = between.slope + beside_slope;
  const double p = half_order(2 * beside.value + c.p_ch);
  atom.hydrogen =
      c.repulsion + c.attraction * order_of_hydrogen(c, 2 * beside.value) - rebo2::hydrogen_energy;
  atom.hydrogen_slope = c.attraction * 0.5 * -0.5 * p * p * p * 2 * beside_slope;
  return atom;
}

double pi_of_open_bond(std::size_t open_ends) {
  static const double pi[] = {rebo2::rebo2_parameters().tables.f_cc.evaluate(2, 2, 6).value,
                              rebo2::rebo2_parameters().tables.f_cc.evaluate(2, 2, 3).value};
  return pi[open_ends - 1];
}

}  // namespace nanocarbon::annealing
