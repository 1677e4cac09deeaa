// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>

#include "nanocarbon/core/element.h"

namespace nanocarbon::rebo2 {

//! P over (N_C, N_H): value and derivatives.
struct BicubicValue {
  double value;
  std::array<double, 2> slope;
};

//! F or T over (N_ij, N_ji, N_conj): value and derivatives.
struct TricubicValue {
  double value;
  std::array<double, 3> slope;
};

//! \brief A bicubic spline over whole coordination numbers 0..4 that is flat at every knot.
//! \details P_CC and P_CH are of this kind: between knots the value blends as 3t^2 - 2t^3 in each direction.
class BicubicTable {
 public:
  using Knots = std::array<std::array<double, 5>, 5>;
  BicubicTable() = default;  //!< zero everywhere
  explicit BicubicTable(const Knots& values) : values_(values) {}
  //! Arguments outside [0, 4] are moved to the nearest end.
  BicubicValue evaluate(double n_carbon, double n_hydrogen) const;

 private:
  Knots values_ = {};
};

//! \brief A tricubic Hermite spline over whole N_ij, N_ji in 0..4 and N_conj in 1..9, mixed derivatives zero.
class TricubicTable {
 public:
  struct Knot {
    double value = 0.0;
    std::array<double, 3> slope = {0.0, 0.0, 0.0};
  };
  //! The knot at whole coordination numbers, to be filled in.
  Knot& at(int n_ij, int n_ji, int n_conj) { return knots_[n_ij][n_ji][n_conj - 1]; }
  const Knot& at(int n_ij, int n_ji, int n_conj) const { return knots_[n_ij][n_ji][n_conj - 1]; }
  //! Arguments outside the table are moved to its nearest end.
  TricubicValue evaluate(double n_ij, double n_ji, double n_conj) const;

 private:
  std::array<std::array<std::array<Knot, 9>, 5>, 5> knots_;
};

//! The splines over coordination numbers: part of a model's parameters.
struct CoordinationTables {
  BicubicTable p_cc;
  BicubicTable p_ch;
  TricubicTable f_cc;
  TricubicTable f_ch;
  TricubicTable f_hh;
  TricubicTable t_cc;

  //! F for a bond between these elements.
  const TricubicTable& f(Element a, Element b) const {
    if (a != b) return f_ch;
    return a == Element::carbon ? f_cc : f_hh;
  }
};

//! \brief The tables of REBO2 that are built into LAMMPS's `pair_style rebo`.
//! \details Tables 3, 5, 7, 8 and 9 of Brenner et al. 2002 with the later corrections that LAMMPS carries: in
//! F_CC the entries (0,0..3,k) and a derivative at (1,3,2), all of F_CH, and T(2,2,k) for every k from 2 on.
const CoordinationTables& rebo2_tables();

}  // namespace nanocarbon::rebo2
