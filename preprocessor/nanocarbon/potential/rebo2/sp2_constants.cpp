// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/potential/rebo2/sp2_constants.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "nanocarbon/potential/rebo2/pair_terms.h"

namespace nanocarbon::rebo2 {

namespace {

constexpr double shortest_bond = 1.2;  // Angstrom; shorter ones are rare even at thousands of kelvin

//! Ascending coefficients of the polynomial through a function's values at the Chebyshev points of [-1, 1].
template <class Function>
void interpolate(const Function& function, double (&coefficients)[sp2_degree + 1]) {
  constexpr std::size_t n = sp2_degree + 1;
  constexpr long double pi = std::numbers::pi_v<long double>;
  long double values[n];
  for (std::size_t k = 0; k < n; ++k) values[k] = function(std::cos(pi * (k + 0.5L) / n));
  // T_m by its recurrence, as ascending coefficients.
  long double previous[n] = {}, current[n] = {1.0L}, sum[n] = {};
  for (std::size_t m = 0; m < n; ++m) {
    long double weight = 0.0L;
    for (std::size_t k = 0; k < n; ++k) weight += values[k] * std::cos(pi * m * (k + 0.5L) / n);
    weight *= (m == 0 ? 1.0L : 2.0L) / n;
    for (std::size_t p = 0; p < n; ++p) sum[p] += weight * current[p];
    long double next[n] = {};
    for (std::size_t p = 0; p < n; ++p)
      next[p] = (p > 0 ? (m == 0 ? 1.0L : 2.0L) * current[p - 1] : 0.0L) - (m == 0 ? 0.0L : previous[p]);
    std::copy(current, current + n, previous);
    std::copy(next, next + n, current);
  }
  std::copy(sum, sum + n, coefficients);
}

long double repulsion(const PairParameters& p, long double r) {
  return (1.0L + p.screening / r) * p.repulsion * std::exp(-p.repulsion_decay * r);
}

long double attraction(const PairParameters& p, long double r) {
  long double sum = 0.0L;
  for (int n = 0; n < 3; ++n) sum -= p.attraction[n] * std::exp(-p.attraction_decay[n] * r);
  return sum;
}

}  // namespace

Sp2Constants make_sp2_constants(const Rebo2Parameters& parameters) {
  const PairParameters& pair = parameters.pairs[pair_index(Element::carbon, Element::carbon)];
  return make_sp2_constants(parameters, shortest_bond, pair.cutoff_begin);
}

Sp2Constants make_sp2_constants(const Rebo2Parameters& parameters, double shortest, double longest) {
  const PairParameters& pair = parameters.pairs[pair_index(Element::carbon, Element::carbon)];
  Sp2Constants c = {};
  c.shortest = shortest;
  c.longest = longest;
  // Away from straight and folded angles, where the dihedrals' switch acts or their sines vanish.
  c.lowest_cosine = linear_angle_end;
  c.highest_cosine = 0.99;
  c.middle = 0.5 * (c.shortest + c.longest);
  c.inverse_half_width = 2.0 / (c.longest - c.shortest);
  const auto length = [&](long double x) { return c.middle + x / c.inverse_half_width; };
  interpolate([&](long double x) { return repulsion(pair, length(x)); }, c.repulsion);
  interpolate([&](long double x) { return attraction(pair, length(x)); }, c.attraction);
  c.one_plus_p = 1.0 + parameters.tables.p_cc.evaluate(2.0, 0.0).value;
  std::copy_n(parameters.carbon.knots.begin() + 1, 3, c.knots);
  for (int piece = 0; piece < 4; ++piece)
    std::copy(parameters.carbon.few[piece].begin(), parameters.carbon.few[piece].end(), c.angular[piece]);
  return c;
}

Sp2BondConstants sp2_bond_constants(const CoordinationTables& tables, double n_conj) {
  const double torsion = tables.t_cc.evaluate(2.0, 2.0, n_conj).value;
  return {std::abs(torsion) > negligible ? torsion : 0.0, tables.f_cc.evaluate(2.0, 2.0, n_conj).value};
}

bool sp2_case_applies(const Rebo2Parameters& parameters) {
  return parameters.conjugation_begin >= 2.0 && parameters.carbon.few_end >= 2.0 &&
         parameters.pairs[0].cutoff_begin > shortest_bond &&
         parameters.pairs[0].dihedral_cutoff_end >= parameters.pairs[0].cutoff_begin;
}

}  // namespace nanocarbon::rebo2
