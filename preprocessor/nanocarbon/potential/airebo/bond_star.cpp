// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/potential/airebo/bond_star.h"

#include <algorithm>
#include <cmath>

#include "nanocarbon/potential/rebo2/angular_spline.h"

namespace nanocarbon::airebo {

using potential::AtomsView;
using rebo2::TricubicTable;

namespace {

constexpr double lambda_slope = 4.0;

//! Not below a table's value at these coordinations and any N_conj: between two knots the slopes add at most
//! a quarter of the steeper one.
double largest_over_conjugation(const TricubicTable& table, int n_i, int n_j) {
  double value = -std::numeric_limits<double>::infinity();
  double slope = 0.0;
  for (int k = 1; k <= 9; ++k) {
    value = std::max(value, table.at(n_i, n_j, k).value);
    slope = std::max(slope, std::abs(table.at(n_i, n_j, k).slope[2]));
  }
  return value + 0.25 * slope;
}

//! Not below a table's value anywhere.
double largest(const TricubicTable& table) {
  double value = -std::numeric_limits<double>::infinity();
  std::array<double, 3> slope = {0.0, 0.0, 0.0};
  for (int i = 0; i <= 4; ++i)
    for (int j = 0; j <= 4; ++j)
      for (int k = 1; k <= 9; ++k) {
        value = std::max(value, table.at(i, j, k).value);
        for (int d = 0; d < 3; ++d) slope[d] = std::max(slope[d], std::abs(table.at(i, j, k).slope[d]));
      }
  return value + 0.25 * (slope[0] + slope[1] + slope[2]);
}

//! As evaluate_quintic(spline_piece()) of angular_spline.h, without branches.
template <std::size_t knots, std::size_t pieces>
double piecewise(const std::array<double, knots>& at, const std::array<rebo2::Quintic, pieces>& quintics,
                 double x) {
  std::size_t piece = 0;
  for (std::size_t k = 1; k + 1 < knots; ++k) piece += x >= at[k];
  const rebo2::Quintic& c = quintics[piece];
  return c[0] + x * (c[1] + x * (c[2] + x * (c[3] + x * (c[4] + x * c[5]))));
}

}  // namespace

BondStars::BondStars(const AireboModel& model) : model_(model) {
  const rebo2::Rebo2Parameters& rebo = model.parameters.rebo;
  using enum Element;
  for (const auto& [a, b] : {std::pair{carbon, carbon}, {carbon, hydrogen}, {hydrogen, hydrogen}})
    for (int i = 0; i <= static_cast<int>(BondStar::most_bonds); ++i)
      for (int j = 0; j <= static_cast<int>(BondStar::most_bonds); ++j) {
        double& most = most_[rebo2::pair_index(a, b)][i][j];
        // Two hydrogens of a CH2 group may have a fractional bond that no star holds.
        most = b == hydrogen ? largest(rebo.tables.f(a, b))
                             : largest_over_conjugation(rebo.tables.f(a, b), i, j);
        if (a == carbon && b == carbon && largest_over_conjugation(rebo.tables.t_cc, i, j) > 0.0)
          most = std::numeric_limits<double>::infinity();
      }
  for (const Element other : {carbon, hydrogen}) {
    const rebo2::PairParameters& pair = rebo.pairs[rebo2::pair_index(hydrogen, other)];
    fictitious_[static_cast<std::size_t>(other)] =
        std::exp(-lambda_slope * (pair.equilibrium - pair.cutoff_begin));
  }
}

std::uint32_t BondStars::add(std::uint32_t atom, const AtomsView& atoms,
                             const potential::NearPairs& whole_bonds) {
  const auto bonds = whole_bonds.of(atom);
  if (bonds.size() > BondStar::most_bonds) return none;
  BondStar star = {};
  star.atom = atom;
  star.bonds = static_cast<std::uint32_t>(bonds.size());
  std::copy(bonds.begin(), bonds.end(), star.neighbours.begin());
  star.stretch.fill(1.0);
  star.base = {1.0, 1.0};
  if (atoms.elements[atom] == Element::carbon) {
    double carbons = 0.0, hydrogens = 0.0;
    for (const std::uint32_t n : bonds) (atoms.elements[n] == Element::carbon ? carbons : hydrogens) += 1.0;
    const rebo2::CoordinationTables& tables = model_.parameters.rebo.tables;
    star.base = {1.0 + tables.p_cc.evaluate(carbons, hydrogens).value,
                 1.0 + tables.p_ch.evaluate(carbons, hydrogens).value};
  }
  stars_.push_back(star);
  return static_cast<std::uint32_t>(stars_.size() - 1);
}

void BondStars::place_star(BondStar& star, const AtomsView& atoms) {
  const double* from = atoms.positions + 3 * std::size_t{star.atom};
  const bool hydrogen = atoms.elements[star.atom] == Element::hydrogen;
  for (std::uint32_t b = 0; b < star.bonds; ++b) {
    const double* to = atoms.positions + 3 * std::size_t{star.neighbours[b]};
    const double x = to[0] - from[0], y = to[1] - from[1], z = to[2] - from[2];
    const double length = std::sqrt(x * x + y * y + z * z);
    const double inverse = 1.0 / length;
    star.along[b] = {x * inverse, y * inverse, z * inverse};
    if (hydrogen) {
      const Element other = atoms.elements[star.neighbours[b]];
      const auto& pair = model_.parameters.rebo.pairs[rebo2::pair_index(Element::hydrogen, other)];
      star.stretch[b] = std::exp(lambda_slope * (pair.equilibrium - length));
    }
  }
  star.step = step_;
}

double BondStars::sum(const BondStar& star, Element element, Element other,
                      const std::array<double, 3>& along) const {
  double sum = 0.0;
  const auto cosine = [&](std::uint32_t b) {
    const auto& u = star.along[b];
    return std::clamp(u[0] * along[0] + u[1] * along[1] + u[2] * along[2], -1.0, 1.0);
  };
  if (element == Element::carbon) {
    const rebo2::CarbonAngles& carbon = model_.parameters.rebo.carbon;
    if (star.bonds <= carbon.few_end)
      for (std::uint32_t b = 0; b < star.bonds; ++b) sum += piecewise(carbon.knots, carbon.few, cosine(b));
    else
      for (std::uint32_t b = 0; b < star.bonds; ++b)
        sum += rebo2::angular_carbon(carbon, cosine(b), star.bonds).value;
  } else {
    const rebo2::HydrogenAngles& hydrogen = model_.parameters.rebo.hydrogen;
    for (std::uint32_t b = 0; b < star.bonds; ++b)
      sum += star.stretch[b] * piecewise(hydrogen.knots, hydrogen.pieces, cosine(b));
    sum *= fictitious_[static_cast<std::size_t>(other)];
  }
  return star.base[static_cast<std::size_t>(other)] + sum;
}

double BondStars::order_bound(std::uint32_t star_i, std::uint32_t star_j, const std::array<double, 3>& along,
                              const AtomsView& atoms) const {
  const BondStar& i = stars_[star_i];
  const BondStar& j = stars_[star_j];
  const Element element_i = atoms.elements[i.atom], element_j = atoms.elements[j.atom];
  const double at_i = sum(i, element_i, element_j, along);
  const double at_j = sum(j, element_j, element_i, {-along[0], -along[1], -along[2]});
  return 0.5 * (1.0 / std::sqrt(at_i) + 1.0 / std::sqrt(at_j)) +
         most_[rebo2::pair_index(element_i, element_j)][i.bonds][j.bonds];
}

}  // namespace nanocarbon::airebo
