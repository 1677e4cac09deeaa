// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/potential/rebo2/parameters.h"

#include "nanocarbon/core/bond_cutoffs.h"

namespace nanocarbon::rebo2 {

namespace {

constexpr PairParameters carbon_carbon = {
    .cutoff_begin = rebo_bond_cutoffs.carbon_carbon.begin,
    .cutoff_end = rebo_bond_cutoffs.carbon_carbon.end,
    .dihedral_cutoff_end = 2.0,
    .screening = 0.3134602960833,
    .repulsion = 10953.544162170,
    .repulsion_decay = 4.7465390606595,
    .attraction = {12388.79197798, 17.56740646509, 30.71493208065},
    .attraction_decay = {4.7204523127, 1.4332132499, 1.3826912506},
    .equilibrium = 0.0,
};

constexpr PairParameters carbon_hydrogen = {
    .cutoff_begin = rebo_bond_cutoffs.carbon_hydrogen.begin,
    .cutoff_end = rebo_bond_cutoffs.carbon_hydrogen.end,
    .dihedral_cutoff_end = 1.6,
    .screening = 0.340775728,
    .repulsion = 149.94098723,
    .repulsion_decay = 4.10254983,
    .attraction = {32.3551866587, 0.0, 0.0},
    .attraction_decay = {1.434458059249837, 0.0, 0.0},
    .equilibrium = 1.09,
};

constexpr PairParameters hydrogen_hydrogen = {
    .cutoff_begin = rebo_bond_cutoffs.hydrogen_hydrogen.begin,
    .cutoff_end = rebo_bond_cutoffs.hydrogen_hydrogen.end,
    .dihedral_cutoff_end = 1.7,
    .screening = 0.370471487045,
    .repulsion = 32.817355747,
    .repulsion_decay = 3.536298648,
    .attraction = {29.632593, 0.0, 0.0},
    .attraction_decay = {1.71589217, 1.0, 1.0},
    .equilibrium = 0.7415887,
};

// The two branches differ only beyond 109.47 degrees' cosine.
constexpr Quintic carbon_straight = {0.2816950000, 1.0627430000, 2.1363075000,
                                     2.5334145000, 1.5544035000, 0.3862485000};
constexpr Quintic carbon_wide = {0.2827390000, 1.0718770000, 2.1681365000,
                                 2.5885710000, 1.6019100000, 0.4025160000};
constexpr Quintic carbon_trigonal = {0.6900250000,  5.4601600000,  23.0108000000,
                                     54.9086400000, 68.6124000000, 34.7051520000};
constexpr Quintic carbon_sharp_few = {0.2718560918,  0.4892740137, -0.4328177539,
                                      -0.5616817383, 1.2708702246, -0.0375008379};
constexpr Quintic carbon_sharp_many = {0.3754514434, 1.4072691309, 2.2551320117,
                                       2.0288747461, 1.4269207324, 0.5063519355};

constexpr CarbonAngles carbon_angles = {
    .knots = {-1.0, -0.6666666667, -0.5, -0.3333333333, 1.0},
    .many = {carbon_straight, carbon_wide, carbon_trigonal, carbon_sharp_many},
    .few = {carbon_straight, carbon_wide, carbon_trigonal, carbon_sharp_few},
    .few_end = 3.2,
    .many_begin = 3.7,
};

constexpr HydrogenAngles hydrogen_angles = {
    .knots = {-1.0, -0.8333333333, -0.5, 1.0},
    .pieces = {Quintic{270.4568000026, 1549.6358000143, 3781.7719000316, 4582.1544000348, 2721.4308000191,
                       630.6336000042},
               Quintic{16.9534406250, -21.0823875000, -102.4683000000, -210.6432299999, -229.8471299999,
                       -94.9946400000},
               Quintic{19.0650249321, 2.0177562840, -2.5664219198, 3.2913322346, -2.6535615062,
                       0.8376699753}},
};

}  // namespace

const Rebo2Parameters& rebo2_parameters() {
  static const Rebo2Parameters published = {
      .pairs = {carbon_carbon, carbon_hydrogen, hydrogen_hydrogen},
      .conjugation_begin = 2.0,
      .conjugation_end = 3.0,
      .carbon = carbon_angles,
      .hydrogen = hydrogen_angles,
      .tables = rebo2_tables(),
  };
  return published;
}

}  // namespace nanocarbon::rebo2
