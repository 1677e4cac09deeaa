// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/potential/rebo2/lane_constants.h"

#include <algorithm>

namespace nanocarbon::rebo2 {

namespace {

constexpr int most_neighbours = 4;  // knots of the tables run from 0 to this
constexpr int conjugation_knots = 9;

LanePair lane_pair(const PairParameters& p) {
  LanePair pair = {};
  pair.cutoff_begin = p.cutoff_begin;
  pair.inverse_window = 1.0 / (p.cutoff_end - p.cutoff_begin);
  pair.dihedral_inverse_window = 1.0 / (p.dihedral_cutoff_end - p.cutoff_begin);
  pair.screening = p.screening;
  pair.repulsion = p.repulsion;
  pair.repulsion_decay = p.repulsion_decay;
  pair.equilibrium = p.equilibrium;
  std::copy(p.attraction.begin(), p.attraction.end(), pair.attraction);
  std::copy(p.attraction_decay.begin(), p.attraction_decay.end(), pair.attraction_decay);
  return pair;
}

template <std::size_t pieces>
void copy_quintics(const std::array<Quintic, pieces>& from, double (&to)[6][8]) {
  for (std::size_t piece = 0; piece < pieces; ++piece)
    for (int power = 0; power < 6; ++power) to[power][piece] = from[piece][power];
}

void copy_table(const TricubicTable& from, double (&to)[225][4]) {
  for (int i = 0; i <= most_neighbours; ++i)
    for (int j = 0; j <= most_neighbours; ++j)
      for (int k = 1; k <= conjugation_knots; ++k) {
        const TricubicTable::Knot& knot = from.at(i, j, k);
        double(&record)[4] = to[(i * (most_neighbours + 1) + j) * conjugation_knots + k - 1];
        record[0] = knot.value;
        std::copy(knot.slope.begin(), knot.slope.end(), record + 1);
      }
}

}  // namespace

LaneConstants make_lane_constants(const Rebo2Parameters& parameters,
                                  const std::optional<TorsionBarriers>& torsion) {
  LaneConstants c = {};
  for (int pair = 0; pair < 3; ++pair) c.pairs[pair] = lane_pair(parameters.pairs[pair]);
  std::copy_n(parameters.carbon.knots.begin() + 1, 3, c.carbon_knots);
  std::copy_n(parameters.hydrogen.knots.begin() + 1, 2, c.hydrogen_knots);
  copy_quintics(parameters.carbon.few, c.few);
  copy_quintics(parameters.carbon.many, c.many);
  copy_quintics(parameters.hydrogen.pieces, c.hydrogen);
  c.few_end = parameters.carbon.few_end;
  c.many_begin = parameters.carbon.many_begin;
  const CoordinationTables& tables = parameters.tables;
  for (const int other : {0, 1}) {
    const BicubicTable& p = other == 0 ? tables.p_cc : tables.p_ch;
    for (int n_c = 0; n_c <= most_neighbours; ++n_c)
      for (int n_h = 0; n_h <= most_neighbours; ++n_h) c.p[other][n_c][n_h] = p.evaluate(n_c, n_h).value;
    for (int n_c = 0; n_c < most_neighbours; ++n_c)
      for (int n_h = 0; n_h < most_neighbours; ++n_h)
        for (int corner = 0; corner < 4; ++corner)
          c.p_cells[other][most_neighbours * n_c + n_h][corner] =
              c.p[other][n_c + corner / 2][n_h + corner % 2];
  }
  copy_table(tables.f_cc, c.f[0]);
  copy_table(tables.f_ch, c.f[1]);
  copy_table(tables.f_hh, c.f[2]);
  copy_table(tables.t_cc, c.t);
  c.torsion = torsion.has_value();
  if (torsion) std::copy(torsion->barriers.begin(), torsion->barriers.end(), c.barriers);
  return c;
}

bool lane_loops_apply(const Rebo2Parameters& parameters) {
  const auto window_is_open = [](const PairParameters& p) {
    return p.cutoff_begin < p.cutoff_end && p.cutoff_begin < p.dihedral_cutoff_end;
  };
  return parameters.carbon.few_end >= 3.0 && parameters.carbon.few_end < parameters.carbon.many_begin &&
         std::all_of(parameters.pairs.begin(), parameters.pairs.end(), window_is_open);
}

}  // namespace nanocarbon::rebo2
