// SPDX-License-Identifier: GPL-2.0-or-later
// Records of numbers, one for each atom, to vectors of one number for each lane and back.

#if NANOCARBON_LANES == 8

using Quad = double __attribute__((vector_size(32)));
using Two = double __attribute__((vector_size(16)));

template <class Row>
inline Row load_row(const double* from) {
  Row row;
  __builtin_memcpy(&row, from, sizeof row);
  return row;
}

inline Real joined(Quad low, Quad high) { return __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7); }
inline Quad joined(Two low, Two high) { return __builtin_shufflevector(low, high, 0, 1, 2, 3); }

inline Real even(Real a, Real b) { return __builtin_shufflevector(a, b, 0, 8, 2, 10, 4, 12, 6, 14); }
inline Real odd(Real a, Real b) { return __builtin_shufflevector(a, b, 1, 9, 3, 11, 5, 13, 7, 15); }

//! Six numbers of each record, which begin at base + 6 index.
inline void load_sixes(const double* base, const std::uint32_t* index, Real (&to)[6]) {
  Quad row[8];
  Two end[8];
  for (int l = 0; l < 8; ++l) {
    const double* record = base + 6 * std::size_t{index[l]};
    row[l] = load_row<Quad>(record);
    end[l] = load_row<Two>(record + 4);
  }
  const Real p = joined(row[0], row[2]), q = joined(row[1], row[3]);
  const Real s = joined(row[4], row[6]), t = joined(row[5], row[7]);
  const Real pq0 = even(p, q), pq1 = odd(p, q), st0 = even(s, t), st1 = odd(s, t);
  to[0] = __builtin_shufflevector(pq0, st0, 0, 1, 4, 5, 8, 9, 12, 13);
  to[1] = __builtin_shufflevector(pq1, st1, 0, 1, 4, 5, 8, 9, 12, 13);
  to[2] = __builtin_shufflevector(pq0, st0, 2, 3, 6, 7, 10, 11, 14, 15);
  to[3] = __builtin_shufflevector(pq1, st1, 2, 3, 6, 7, 10, 11, 14, 15);
  const Real first = joined(joined(end[0], end[2]), joined(end[4], end[6]));
  const Real second = joined(joined(end[1], end[3]), joined(end[5], end[7]));
  to[4] = even(first, second);
  to[5] = odd(first, second);
}

inline void store_row(double* to, Quad row) { __builtin_memcpy(to, &row, sizeof row); }
inline void store_row(double* to, Two row) { __builtin_memcpy(to, &row, sizeof row); }

//! Records of 18 numbers, one after the other.
inline void store_eighteens(double* to, const Real (&made)[18]) {
  for (int k = 0; k < 16; k += 4) {
    const Real ab0 = even(made[k], made[k + 1]), ab1 = odd(made[k], made[k + 1]);
    const Real cd0 = even(made[k + 2], made[k + 3]), cd1 = odd(made[k + 2], made[k + 3]);
    store_row(to + k, __builtin_shufflevector(ab0, cd0, 0, 1, 8, 9));
    store_row(to + 18 + k, __builtin_shufflevector(ab1, cd1, 0, 1, 8, 9));
    store_row(to + 36 + k, __builtin_shufflevector(ab0, cd0, 2, 3, 10, 11));
    store_row(to + 54 + k, __builtin_shufflevector(ab1, cd1, 2, 3, 10, 11));
    store_row(to + 72 + k, __builtin_shufflevector(ab0, cd0, 4, 5, 12, 13));
    store_row(to + 90 + k, __builtin_shufflevector(ab1, cd1, 4, 5, 12, 13));
    store_row(to + 108 + k, __builtin_shufflevector(ab0, cd0, 6, 7, 14, 15));
    store_row(to + 126 + k, __builtin_shufflevector(ab1, cd1, 6, 7, 14, 15));
  }
  const Real first = even(made[16], made[17]), second = odd(made[16], made[17]);
  store_row(to + 16, __builtin_shufflevector(first, first, 0, 1));
  store_row(to + 34, __builtin_shufflevector(second, second, 0, 1));
  store_row(to + 52, __builtin_shufflevector(first, first, 2, 3));
  store_row(to + 70, __builtin_shufflevector(second, second, 2, 3));
  store_row(to + 88, __builtin_shufflevector(first, first, 4, 5));
  store_row(to + 106, __builtin_shufflevector(second, second, 4, 5));
  store_row(to + 124, __builtin_shufflevector(first, first, 6, 7));
  store_row(to + 142, __builtin_shufflevector(second, second, 6, 7));
}

#else

//! Six numbers of each record, which begin at base + 6 index.
inline void load_sixes(const double* base, const std::uint32_t* index, Real (&to)[6]) {
  alignas(64) double rows[6][lanes];
  for (int l = 0; l < lanes; ++l)
    for (int k = 0; k < 6; ++k) rows[k][l] = base[6 * std::size_t{index[l]} + k];
  for (int k = 0; k < 6; ++k) to[k] = load(rows[k]);
}

//! Records of 18 numbers, one after the other.
inline void store_eighteens(double* to, const Real (&made)[18]) {
  alignas(64) double rows[18][lanes];
  for (int k = 0; k < 18; ++k) store(rows[k], made[k]);
  for (int l = 0; l < lanes; ++l)
    for (int k = 0; k < 18; ++k) to[18 * l + k] = rows[k][l];
}

#endif
