// SPDX-License-Identifier: GPL-2.0-or-later
// The numbers of coordination_tables.h. Rows are [N_C][N_H] for P; F and T are given for N_ij >= N_ji and
// mirrored.
#include "nanocarbon/potential/rebo2/coordination_tables.h"

namespace nanocarbon::rebo2 {

namespace {

constexpr BicubicTable::Knots p_cc_knots = {{
    {0.0, 0.0, 0.007860700254745, 0.016125364564267, 0.0},
    {0.0, 0.003026697473481, 0.006326248241119, 0.0, 0.0},
    {0.0, 0.003179530830731, 0.0, 0.0, 0.0},
    {0.0, 0.0, 0.0, 0.0, 0.0},
    {0.0, 0.0, 0.0, 0.0, 0.0},
}};

constexpr BicubicTable::Knots p_ch_knots = {{
    {0.0, 0.2093367328250380, -0.064449615432525, -0.303927546346162, 0.0},
    {0.010, -0.1251234006287090, -0.298905245783, 0.0, 0.0},
    {-0.1220421462782555, -0.3005291724067579, 0.0, 0.0, 0.0},
    {-0.307584705066, 0.0, 0.0, 0.0, 0.0},
    {0.0, 0.0, 0.0, 0.0, 0.0},
}};

//! Sets the value at (i, j, k) and (j, i, k) for k in a range.
void set(TricubicTable& table, int i, int j, int k_first, int k_last, double value) {
  for (int k = k_first; k <= k_last; ++k) table.at(i, j, k).value = table.at(j, i, k).value = value;
}

//! Sets the derivative by the first argument at (i, j, k), and by the second at (j, i, k).
void set_slope(TricubicTable& table, int i, int j, int k_first, int k_last, double slope) {
  for (int k = k_first; k <= k_last; ++k) table.at(i, j, k).slope[0] = table.at(j, i, k).slope[1] = slope;
}

//! Sets the derivative by N_conj at (i, j, k) and (j, i, k).
void set_conjugation_slope(TricubicTable& table, int i, int j, int k_first, int k_last, double slope) {
  for (int k = k_first; k <= k_last; ++k) table.at(i, j, k).slope[2] = table.at(j, i, k).slope[2] = slope;
}

//! Coordination 4 has the values of coordination 3; the derivatives stay zero there, as in LAMMPS.
void flatten_top(TricubicTable& table) {
  for (int k = 1; k <= 9; ++k) {
    for (int n = 0; n < 4; ++n) table.at(4, n, k).value = table.at(n, 4, k).value = table.at(3, n, k).value;
    table.at(4, 4, k).value = table.at(3, 3, k).value;
  }
}

TricubicTable make_f_cc() {
  TricubicTable f;
  set(f, 0, 0, 3, 9, 0.0049586079);
  set(f, 1, 0, 1, 1, 0.021693495);
  set(f, 1, 0, 2, 9, 0.0049586079);
  set(f, 1, 1, 1, 1, 0.05250);
  set(f, 1, 1, 2, 2, -0.002088750);
  set(f, 1, 1, 3, 9, -0.00804280);
  set(f, 2, 0, 1, 1, 0.024698831850);
  set(f, 2, 0, 2, 2, -0.00597133450);
  set(f, 2, 0, 3, 9, 0.0049586079);
  set(f, 2, 1, 1, 1, 0.00482478490);
  set(f, 2, 1, 2, 2, 0.0150);
  set(f, 2, 1, 3, 3, -0.010);
  set(f, 2, 1, 4, 4, -0.01168893870);
  set(f, 2, 1, 5, 5, -0.013377877400);
  set(f, 2, 1, 6, 9, -0.015066816000);
  set(f, 2, 2, 1, 1, 0.0472247850);
  set(f, 2, 2, 2, 2, 0.0110);
  set(f, 2, 2, 3, 3, 0.0198529350);
  set(f, 2, 2, 4, 4, 0.01654411250);
  set(f, 2, 2, 5, 5, 0.013235290);
  set(f, 2, 2, 6, 6, 0.00992646749999);
  set(f, 2, 2, 7, 7, 0.006617644999);
  set(f, 2, 2, 8, 8, 0.00330882250);
  set(f, 3, 0, 1, 2, -0.05989946750);
  set(f, 3, 0, 3, 9, 0.0049586079);
  set(f, 3, 1, 2, 9, -0.0624183760);
  set(f, 3, 2, 1, 9, -0.02235469150);
  flatten_top(f);
  set_slope(f, 2, 1, 1, 1, -0.026250);
  set_slope(f, 2, 1, 5, 9, -0.0271880);
  set_slope(f, 1, 3, 2, 2, 0.0187723882);
  set_slope(f, 2, 3, 2, 9, 0.031209);
  set_conjugation_slope(f, 1, 1, 2, 2, -0.0302715);
  set_conjugation_slope(f, 2, 1, 4, 5, -0.0100220);
  set_conjugation_slope(f, 2, 2, 4, 8, -0.0033090);
  return f;
}

TricubicTable make_f_ch() {
  TricubicTable f;
  set(f, 1, 1, 1, 2, -0.050);
  set(f, 1, 1, 3, 3, -0.30);
  set(f, 1, 1, 4, 9, -0.050);
  set(f, 2, 0, 5, 9, -0.004523893758064);
  set(f, 2, 1, 2, 3, -0.250);
  set(f, 3, 1, 1, 1, -0.10);
  set(f, 3, 1, 2, 3, -0.125);
  set(f, 3, 1, 4, 9, -0.10);
  flatten_top(f);
  return f;
}

TricubicTable make_f_hh() {
  TricubicTable f;
  set(f, 1, 1, 1, 1, 0.124915958);
  return f;
}

TricubicTable make_t_cc() {
  TricubicTable t;
  set(t, 2, 2, 1, 1, -0.035140);
  set(t, 2, 2, 2, 9, -0.0040480);
  return t;
}

}  // namespace

const CoordinationTables& rebo2_tables() {
  static const CoordinationTables tables = {
      BicubicTable(p_cc_knots), BicubicTable(p_ch_knots), make_f_cc(), make_f_ch(), make_f_hh(), make_t_cc()};
  return tables;
}

}  // namespace nanocarbon::rebo2
