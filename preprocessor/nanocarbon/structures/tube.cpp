// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/structures/tube.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "nanocarbon/core/error.h"
#include "nanocarbon/structures/close_bonds.h"
#include "nanocarbon/structures/honeycomb.h"

namespace nanocarbon::structures {
namespace {

//! A place on the rolled sheet as exact fractions: turn / turns of the circumference, rise / rises of the
//! period.
struct Unrolled {
  std::int64_t turn;
  std::int64_t rise;
};

//! The circumference vector (n, m) and the axis vector (t1, t2) in lattice coordinates; |(i, j)|^2 = i^2 + i
//! j + j^2.
class RolledSheet {
 public:
  RolledSheet(int n, int m) : n_(n), m_(m) {
    const std::int64_t divisor = std::gcd(2 * n_ + m_, 2 * m_ + n_);
    t1_ = (2 * m_ + n_) / divisor;
    t2_ = -(2 * n_ + m_) / divisor;
    // Three times, so that the second atom of a cell, at (1/3, 1/3), also has whole numbers.
    turns_ = 6 * (n_ * n_ + n_ * m_ + m_ * m_);
    rises_ = 6 * (t1_ * t1_ + t1_ * t2_ + t2_ * t2_);
  }

  std::int64_t turns() const { return turns_; }
  std::int64_t rises() const { return rises_; }
  double period() const { return graphene_lattice_constant * std::sqrt(static_cast<double>(rises_) / 6.0); }
  double radius() const {
    return graphene_lattice_constant * std::sqrt(static_cast<double>(turns_) / 6.0) /
           (2.0 * std::numbers::pi);
  }

  //! Atom 0 or 1 of the lattice cell (i, j): projections on the circumference and on the axis.
  Unrolled place(std::int64_t i, std::int64_t j, int atom) const {
    const std::int64_t x = 3 * i + atom, y = 3 * j + atom;
    return {x * (2 * n_ + m_) + y * (n_ + 2 * m_), x * (2 * t1_ + t2_) + y * (t1_ + 2 * t2_)};
  }

  //! All atoms whose turn is in [0, turns) and whose rise is in [0, rises), each once, by rise.
  std::vector<Unrolled> one_period() const {
    const auto [i_min, i_max] = std::minmax({std::int64_t{0}, n_, t1_, n_ + t1_});
    const auto [j_min, j_max] = std::minmax({std::int64_t{0}, m_, t2_, m_ + t2_});
    std::vector<Unrolled> atoms;
    for (std::int64_t i = i_min - 1; i <= i_max; ++i)
      for (std::int64_t j = j_min - 1; j <= j_max; ++j)
        for (const int atom : {0, 1}) {
          const Unrolled p = place(i, j, atom);
          if (p.turn >= 0 && p.turn < turns_ && p.rise >= 0 && p.rise < rises_) atoms.push_back(p);
        }
    std::sort(atoms.begin(), atoms.end(), [](const Unrolled& a, const Unrolled& b) {
      return a.rise != b.rise ? a.rise < b.rise : a.turn < b.turn;
    });
    return atoms;
  }

  Vec3 rolled(const Unrolled& p, std::int64_t period_number) const {
    const double angle = 2.0 * std::numbers::pi * static_cast<double>(p.turn) / static_cast<double>(turns_);
    const double z =
        (static_cast<double>(period_number) + static_cast<double>(p.rise) / static_cast<double>(rises_)) *
        period();
    return {radius() * std::cos(angle), radius() * std::sin(angle), z};
  }

 private:
  std::int64_t n_, m_, t1_ = 0, t2_ = 0, turns_ = 0, rises_ = 0;
};

void check_indices(int n, int m) {
  if (n < 0 || m < 0 || (n == 0 && m == 0))
    throw UserError(Failure::usage,
                    fmt::format("({}, {}) is not a tube: both indices must be 0 or more, not both 0", n, m));
  if (n > 10000 || m > 10000)
    throw UserError(Failure::usage, fmt::format("({}, {}) is too wide: indices go up to 10000", n, m));
  if (n * n + n * m + m * m < 9)
    throw UserError(
        Failure::usage,
        fmt::format("a ({}, {}) tube is too thin to hold together; the thinnest are (3, 0) and (2, 2)", n,
                    m));
}

void add_bonds_and_rings(Molecule& tube) {
  tube.elements.assign(tube.size(), Element::carbon);
  add_bonds(tube);
  if (!tube.cell) tube = without_dangling_atoms(tube);
  add_rings(tube, 6);
}

}  // namespace

TubeGeometry tube_geometry(int n, int m) {
  const RolledSheet sheet(n, m);
  const auto squares = static_cast<std::size_t>(sheet.turns() / 6);
  return {sheet.radius(), sheet.period(),
          4 * squares / static_cast<std::size_t>(std::gcd(2 * n + m, 2 * m + n))};
}

Molecule periodic_tube(int n, int m, int periods) {
  check_indices(n, m);
  if (periods < 1) throw UserError(Failure::usage, "a periodic tube needs at least one period");
  const RolledSheet sheet(n, m);
  const double across = 2.0 * (sheet.radius() + 10.0);
  Molecule tube;
  tube.cell = orthogonal_cell(Vec3(across, across, periods * sheet.period()), {false, false, true});
  tube.cell->origin = Vec3(-0.5 * across, -0.5 * across, 0.0);
  const std::vector<Unrolled> atoms = sheet.one_period();
  for (int k = 0; k < periods; ++k)
    for (const Unrolled& atom : atoms) tube.positions.push_back(sheet.rolled(atom, k));
  add_bonds_and_rings(tube);
  return tube;
}

Molecule open_tube(int n, int m, double length) {
  check_indices(n, m);
  if (!(length >= 4.0))
    throw UserError(Failure::usage, fmt::format("a tube of {} Angstrom is too short; use 4 or more", length));
  const RolledSheet sheet(n, m);
  const std::vector<Unrolled> atoms = sheet.one_period();
  Molecule tube;
  for (std::int64_t k = 0; static_cast<double>(k) * sheet.period() <= length; ++k)
    for (const Unrolled& atom : atoms) {
      const Vec3 position = sheet.rolled(atom, k);
      if (position.z() <= length) tube.positions.push_back(position - Vec3(0.0, 0.0, 0.5 * length));
    }
  add_bonds_and_rings(tube);
  return tube;
}

}  // namespace nanocarbon::structures
