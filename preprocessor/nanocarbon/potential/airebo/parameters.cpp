// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/potential/airebo/parameters.h"

namespace nanocarbon::airebo {

namespace {

using rebo2::BicubicTable;
using rebo2::CoordinationTables;
using rebo2::PairParameters;
using rebo2::Rebo2Parameters;

// Rows are [N_C][N_H].
constexpr BicubicTable::Knots p_cc_knots = {{
    {0.0, 0.0, -0.00050, 0.0161253646, 0.0},
    {0.0, -0.010960, 0.00632624824, 0.0, 0.0},
    {-0.0276030, 0.00317953083, 0.0, 0.0, 0.0},
    {0.0, 0.0, 0.0, 0.0, 0.0},
    {0.0, 0.0, 0.0, 0.0, 0.0},
}};

constexpr PairParameters carbon_carbon = {
    .cutoff_begin = 1.7,
    .cutoff_end = 2.0,
    .dihedral_cutoff_end = 2.0,
    .screening = 0.3134602960832605,
    .repulsion = 10953.54416216992,
    .repulsion_decay = 4.746539060659529,
    .attraction = {12388.79197798375, 17.56740646508968, 30.71493208065162},
    .attraction_decay = {4.720452312717397, 1.433213249951261, 1.382691250599169},
    .equilibrium = 0.0,
};

constexpr PairParameters carbon_hydrogen = {
    .cutoff_begin = 1.3,
    .cutoff_end = 1.8,
    .dihedral_cutoff_end = 1.6,
    .screening = 0.3407757282257080,
    .repulsion = 149.940987228812,
    .repulsion_decay = 4.102549828548784,
    .attraction = {32.35518665873256, 0.0, 0.0},
    .attraction_decay = {1.434458059249837, 0.0, 0.0},
    .equilibrium = 1.09,
};

constexpr PairParameters hydrogen_hydrogen = {
    .cutoff_begin = 1.1,
    .cutoff_end = 1.7,
    .dihedral_cutoff_end = 1.7,
    .screening = 0.370,
    .repulsion = 31.6731,
    .repulsion_decay = 3.536,
    .attraction = {28.2297, 0.0, 0.0},
    .attraction_decay = {1.708, 1.0, 1.0},
    .equilibrium = 0.7415887,
};

constexpr std::array<LongRangeParameters, 3> lennard_jones = {{
    {3.4, 3.816370964, 0.77, 0.81, {.epsilon = 0.002843732471143, .sigma = 3.4}},
    {3.025, 3.395447696, 0.75, 0.9, {.epsilon = 0.002064935027177, .sigma = 3.025}},
    {2.65, 2.974524428, 0.32, 0.42, {.epsilon = 0.001499422575693, .sigma = 2.65}},
}};

//! S(t_r) begins where Morse is zero, and ends at its minimum (for C-H at that of Lennard-Jones).
constexpr std::array<LongRangeParameters, 3> morse = {{
    {3.30759, 3.6891063, 0.77, 0.81, {0.002843732471143, 3.4, 0.0028437, 1.8168084, 3.6891063}},
    {2.94296, 3.395447696, 0.75, 0.9, {0.002064935027177, 3.025, 0.0020649, 1.53168632129, 3.3955}},
    {2.57806, 2.97452, 0.32, 0.42, {0.001499422575693, 2.65, 0.0014994, 1.74844310191, 2.9745}},
}};

//! The angular splines and the switches over coordination numbers are those of REBO2, to the last digit.
Rebo2Parameters rebo_part() {
  Rebo2Parameters rebo = rebo2::rebo2_parameters();
  rebo.pairs = {carbon_carbon, carbon_hydrogen, hydrogen_hydrogen};
  rebo.tables = airebo_tables();
  return rebo;
}

constexpr rebo2::TorsionBarriers torsion_barriers = {{0.3078851086, 0.1786600912, 0.1249753356}};

}  // namespace

const CoordinationTables& airebo_tables() {
  static const CoordinationTables tables = [] {
    CoordinationTables t = rebo2::rebo2_tables();
    t.p_cc = BicubicTable(p_cc_knots);
    return t;
  }();
  return tables;
}

LjParameters lj_parameters(const AireboParameters& parameters, const AireboTerms& terms) {
  LjParameters lj;
  for (int p = 0; p < 3; ++p) lj.pairs[p] = parameters.long_range[p].potential;
  lj.form = parameters.form;
  lj.switch_begin = terms.switch_begin;
  lj.switch_end = terms.switch_end;
  lj.cutoff = terms.cutoff;
  return lj;
}

const AireboParameters& airebo_parameters() {
  static const AireboParameters parameters = {LjForm::lennard_jones, rebo_part(),   lennard_jones,
                                              torsion_barriers,      -7.4265837613, -59.0751381406};
  return parameters;
}

const AireboParameters& airebo_m_parameters() {
  static const AireboParameters parameters = {LjForm::morse,    rebo_part(),   morse,
                                              torsion_barriers, -7.4179729649, -59.0751924458};
  return parameters;
}

}  // namespace nanocarbon::airebo
