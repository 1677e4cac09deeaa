// SPDX-License-Identifier: GPL-2.0-or-later
// For the bodies of the lane loops: records to lanes and back, and functions of one variable.

inline bool any(Mask m) {
#if defined(__AVX512DQ__) && NANOCARBON_LANES == 8
  return _mm512_movepi64_mask((__m512i)m) != 0;
#elif defined(__AVX__) && NANOCARBON_LANES == 4
  return _mm256_movemask_pd((__m256d)m) != 0;
#else
  long long found = 0;
  for (int l = 0; l < lanes; ++l) found |= m[l];
  return found != 0;
#endif
}

inline double sum_of(Real x) {
  double sum = 0.0;
  for (int l = 0; l < lanes; ++l) sum += x[l];
  return sum;
}

inline Real clamped(Real x, double low, double high) { return smaller(larger(x, all(low)), all(high)); }

// Too large for compilers to inline by themselves, and slow through memory.
#define NANOCARBON_INLINE __attribute__((always_inline)) inline

using Index = std::uint32_t[lanes];

//! Four numbers of one thing for each lane.
struct Records {
  Real a, b, c, d;
};

#if NANOCARBON_LANES == 2

NANOCARBON_INLINE Records load_records(const double* base, const Index& index) {
  const double* p = base + 4 * std::size_t{index[0]};
  const double* q = base + 4 * std::size_t{index[1]};
  const Real p0 = load(p), p1 = load(p + 2), q0 = load(q), q1 = load(q + 2);
  return {__builtin_shufflevector(p0, q0, 0, 2), __builtin_shufflevector(p0, q0, 1, 3),
          __builtin_shufflevector(p1, q1, 0, 2), __builtin_shufflevector(p1, q1, 1, 3)};
}

template <class Put>
NANOCARBON_INLINE void put_records(double* base, const Index& index, const Records& r, const Put& put) {
  double* p = base + 4 * std::size_t{index[0]};
  put(p, __builtin_shufflevector(r.a, r.b, 0, 2));
  put(p + 2, __builtin_shufflevector(r.c, r.d, 0, 2));
  double* q = base + 4 * std::size_t{index[1]};
  put(q, __builtin_shufflevector(r.a, r.b, 1, 3));
  put(q + 2, __builtin_shufflevector(r.c, r.d, 1, 3));
}

using Quad = Real;

#else

using Quad = double __attribute__((vector_size(32)));

inline Quad load_quad(const double* from) {
  Quad value;
  __builtin_memcpy(&value, from, sizeof value);
  return value;
}

#if NANOCARBON_LANES == 4

NANOCARBON_INLINE Records load_records(const double* base, const Index& index) {
  Quad row[4];
  for (int l = 0; l < 4; ++l) row[l] = load_quad(base + 4 * std::size_t{index[l]});
  const Quad p = __builtin_shufflevector(row[0], row[1], 0, 4, 2, 6);
  const Quad q = __builtin_shufflevector(row[0], row[1], 1, 5, 3, 7);
  const Quad s = __builtin_shufflevector(row[2], row[3], 0, 4, 2, 6);
  const Quad t = __builtin_shufflevector(row[2], row[3], 1, 5, 3, 7);
  return {__builtin_shufflevector(p, s, 0, 1, 4, 5), __builtin_shufflevector(q, t, 0, 1, 4, 5),
          __builtin_shufflevector(p, s, 2, 3, 6, 7), __builtin_shufflevector(q, t, 2, 3, 6, 7)};
}

template <class Put>
NANOCARBON_INLINE void put_records(double* base, const Index& index, const Records& r, const Put& put) {
  const Quad p = __builtin_shufflevector(r.a, r.b, 0, 4, 2, 6);
  const Quad q = __builtin_shufflevector(r.a, r.b, 1, 5, 3, 7);
  const Quad s = __builtin_shufflevector(r.c, r.d, 0, 4, 2, 6);
  const Quad t = __builtin_shufflevector(r.c, r.d, 1, 5, 3, 7);
  put(base + 4 * std::size_t{index[0]}, __builtin_shufflevector(p, s, 0, 1, 4, 5));
  put(base + 4 * std::size_t{index[1]}, __builtin_shufflevector(q, t, 0, 1, 4, 5));
  put(base + 4 * std::size_t{index[2]}, __builtin_shufflevector(p, s, 2, 3, 6, 7));
  put(base + 4 * std::size_t{index[3]}, __builtin_shufflevector(q, t, 2, 3, 6, 7));
}

#else

inline Real joined(Quad low, Quad high) { return __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7); }

NANOCARBON_INLINE Records load_records(const double* base, const Index& index) {
  Quad row[8];
  for (int l = 0; l < 8; ++l) row[l] = load_quad(base + 4 * std::size_t{index[l]});
  const Real p = joined(row[0], row[2]), q = joined(row[1], row[3]);
  const Real s = joined(row[4], row[6]), t = joined(row[5], row[7]);
  const Real pq0 = __builtin_shufflevector(p, q, 0, 8, 2, 10, 4, 12, 6, 14);
  const Real pq1 = __builtin_shufflevector(p, q, 1, 9, 3, 11, 5, 13, 7, 15);
  const Real st0 = __builtin_shufflevector(s, t, 0, 8, 2, 10, 4, 12, 6, 14);
  const Real st1 = __builtin_shufflevector(s, t, 1, 9, 3, 11, 5, 13, 7, 15);
  return {__builtin_shufflevector(pq0, st0, 0, 1, 4, 5, 8, 9, 12, 13),
          __builtin_shufflevector(pq1, st1, 0, 1, 4, 5, 8, 9, 12, 13),
          __builtin_shufflevector(pq0, st0, 2, 3, 6, 7, 10, 11, 14, 15),
          __builtin_shufflevector(pq1, st1, 2, 3, 6, 7, 10, 11, 14, 15)};
}

template <class Put>
NANOCARBON_INLINE void put_records(double* base, const Index& index, const Records& r, const Put& put) {
  const Real ab0 = __builtin_shufflevector(r.a, r.b, 0, 8, 2, 10, 4, 12, 6, 14);
  const Real ab1 = __builtin_shufflevector(r.a, r.b, 1, 9, 3, 11, 5, 13, 7, 15);
  const Real cd0 = __builtin_shufflevector(r.c, r.d, 0, 8, 2, 10, 4, 12, 6, 14);
  const Real cd1 = __builtin_shufflevector(r.c, r.d, 1, 9, 3, 11, 5, 13, 7, 15);
  const auto at = [&](int l) { return base + 4 * std::size_t{index[l]}; };
  put(at(0), __builtin_shufflevector(ab0, cd0, 0, 1, 8, 9));
  put(at(1), __builtin_shufflevector(ab1, cd1, 0, 1, 8, 9));
  put(at(2), __builtin_shufflevector(ab0, cd0, 2, 3, 10, 11));
  put(at(3), __builtin_shufflevector(ab1, cd1, 2, 3, 10, 11));
  put(at(4), __builtin_shufflevector(ab0, cd0, 4, 5, 12, 13));
  put(at(5), __builtin_shufflevector(ab1, cd1, 4, 5, 12, 13));
  put(at(6), __builtin_shufflevector(ab0, cd0, 6, 7, 14, 15));
  put(at(7), __builtin_shufflevector(ab1, cd1, 6, 7, 14, 15));
}

#endif
#endif

NANOCARBON_INLINE void store_records(double* base, const Index& index, const Records& r) {
  put_records(base, index, r, [](double* to, Quad row) { __builtin_memcpy(to, &row, sizeof row); });
}

//! One lane after the other: lanes may have the same record.
NANOCARBON_INLINE void add_records(double* base, const Index& index, const Records& r) {
  put_records(base, index, r, [](double* to, Quad row) {
    Quad sum;
    __builtin_memcpy(&sum, to, sizeof sum);
    sum += row;
    __builtin_memcpy(to, &sum, sizeof sum);
  });
}

//! exp(x) for arguments between about -700 and 700, to a unit in the last place or two.
NANOCARBON_INLINE Real exponential(Real x) {
  const Real magic = all(0x1.8p52);
  const Real shifted = x * 1.4426950408889634 + magic;
  const Real n = shifted - magic;
  const Real r = (x - n * 6.93147180369123816490e-01) - n * 1.90821492927058770002e-10;
  constexpr double inverse_factorials[] = {1.0,
                                           1.0,
                                           1.0 / 2,
                                           1.0 / 6,
                                           1.0 / 24,
                                           1.0 / 120,
                                           1.0 / 720,
                                           1.0 / 5040,
                                           1.0 / 40320,
                                           1.0 / 362880,
                                           1.0 / 3628800,
                                           1.0 / 39916800,
                                           1.0 / 479001600,
                                           1.0 / 6227020800};
  Real value = all(inverse_factorials[13]);
  for (int power = 12; power >= 0; --power) value = value * r + inverse_factorials[power];
  return value * (Real)(((Mask)shifted + 1023) << 52);
}

//! 1 for t <= 0, 0 for t >= 1, half a cosine wave between them, and its slope over t.
NANOCARBON_INLINE ValueAndSlope cosine_switch(Real t) {
  constexpr double pi = 3.14159265358979323846;
  const Mask inside = (t > 0.0) & (t < 1.0);
  const Real x = (clamped(t, 0.0, 1.0) - 0.5) * pi;
  const Real x2 = x * x;
  Real sine = all(1.0), cosine = all(1.0);
  // Taylor series: x is within a quarter turn.
  for (int k = 20; k >= 2; k -= 2) {
    cosine = 1.0 - x2 * cosine * (1.0 / (k * (k - 1)));
    sine = 1.0 - x2 * sine * (1.0 / (k * (k + 1)));
  }
  // Exact outside, where weights are compared with 0 and 1.
  return {inside ? 0.5 - 0.5 * x * sine : (t > 0.0 ? Real{} : all(1.0)),
          inside ? -0.5 * pi * cosine : Real{}};
}

//! Coefficients of a quintic by piece, [power][piece]; at most four pieces.
struct Quintics {
  Real k[6];
};

// Those of a piece, by its number, which is whole.
NANOCARBON_INLINE Quintics choose(const double (*table)[8], Mask piece) {
  Quintics chosen;
  for (int power = 0; power < 6; ++power) {
#if NANOCARBON_LANES == 8 && defined(__AVX512F__)
    chosen.k[power] = (Real)_mm512_maskz_permutexvar_pd(0xff, (__m512i)piece, (__m512d)load(table[power]));
#else
    const Real low = piece > 0 ? all(table[power][1]) : all(table[power][0]);
    const Real high = piece > 2 ? all(table[power][3]) : all(table[power][2]);
    chosen.k[power] = piece > 1 ? high : low;
#endif
  }
  return chosen;
}

NANOCARBON_INLINE ValueAndSlope evaluate(const Quintics& q, Real x) {
  Real value = q.k[5];
  Real slope = Real{};
  for (int power = 4; power >= 0; --power) {
    slope = slope * x + value;
    value = value * x + q.k[power];
  }
  return {value, slope};
}

//! V_R and V_A, and their slopes.
struct PairTerms {
  ValueAndSlope repulsion, attraction;
};

NANOCARBON_INLINE ValueAndSlope attraction(const LanePair& p, Real r) {
  Real value = Real{}, slope = Real{};
  for (int n = 0; n < 3; ++n) {
    if (p.attraction[n] == 0.0) continue;
    const Real term = p.attraction[n] * exponential(-p.attraction_decay[n] * r);
    value -= term;
    slope += p.attraction_decay[n] * term;
  }
  return {value, slope};
}

NANOCARBON_INLINE PairTerms pair_terms(const LanePair& p, Real r) {
  const Real decay = p.repulsion * exponential(-p.repulsion_decay * r);
  const Real inverse_r = inverse(r);
  const Real screened = 1.0 + p.screening * inverse_r;
  return {{screened * decay, -decay * (p.repulsion_decay * screened + p.screening * inverse_r * inverse_r)},
          attraction(p, r)};
}
