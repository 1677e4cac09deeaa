// SPDX-License-Identifier: GPL-2.0-or-later
// Vectors of NANOCARBON_LANES doubles, and what lj_kernel_body.h computes with them. Written with the vector types of GCC
// and Clang.

constexpr int lanes = NANOCARBON_LANES;
constexpr int part_lanes = lanes < lj_lanes ? lanes : lj_lanes;
constexpr int parts = lj_lanes / part_lanes;                              // of a cluster
constexpr std::uint32_t group = lanes > lj_lanes ? lanes / lj_lanes : 1;  // clusters at once
using Real = double __attribute__((vector_size(8 * lanes)));
using Mask = long long __attribute__((vector_size(8 * lanes)));
using Part = double __attribute__((vector_size(8 * part_lanes)));
using PartMask = long long __attribute__((vector_size(8 * part_lanes)));

inline Real all(double value) { return Real{} + value; }

template <class Vector = Real>
inline Vector load(const double* from) {
  Vector value;
  __builtin_memcpy(&value, from, sizeof value);
  return value;
}

template <class Vector>
inline void store(double* to, Vector value) {
  __builtin_memcpy(to, &value, sizeof value);
}

// Comparisons followed by blends would do the same, in two instructions each.
inline Real larger(Real a, Real b) {
#if defined(__AVX512F__) && NANOCARBON_LANES == 8
  return (Real)_mm512_maskz_max_pd(0xff, (__m512d)a, (__m512d)b);
#elif defined(__AVX__) && NANOCARBON_LANES == 4
  return (Real)_mm256_max_pd((__m256d)a, (__m256d)b);
#elif defined(__SSE2__) && NANOCARBON_LANES == 2
  return (Real)_mm_max_pd((__m128d)a, (__m128d)b);
#else
  return a > b ? a : b;
#endif
}

inline Real smaller(Real a, Real b) {
#if defined(__AVX512F__) && NANOCARBON_LANES == 8
  return (Real)_mm512_maskz_min_pd(0xff, (__m512d)a, (__m512d)b);
#elif defined(__AVX__) && NANOCARBON_LANES == 4
  return (Real)_mm256_min_pd((__m256d)a, (__m256d)b);
#elif defined(__SSE2__) && NANOCARBON_LANES == 2
  return (Real)_mm_min_pd((__m128d)a, (__m128d)b);
#else
  return a < b ? a : b;
#endif
}

inline double sum(Real value) {
#if NANOCARBON_LANES == 8
  value += __builtin_shufflevector(value, value, 4, 5, 6, 7, 0, 1, 2, 3);
  value += __builtin_shufflevector(value, value, 2, 3, 0, 1, 6, 7, 4, 5);
#elif NANOCARBON_LANES == 4
  value += __builtin_shufflevector(value, value, 2, 3, 0, 1);
#endif
  return value[0] + value[1];
}

#if NANOCARBON_LANES >= 4
// The vector's halves on top of each other until a cluster's lanes are left.
inline Part folded(const double* from) {
#if NANOCARBON_LANES == 8
  return load<Part>(from) + load<Part>(from + 4);
#else
  return load<Part>(from);
#endif
}

// The sum over each of four vectors in a lane of its own.
inline Part sums(Part a, Part b, Part c, Part d) {
  const Part ab = __builtin_shufflevector(a, b, 0, 4, 2, 6) + __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const Part cd = __builtin_shufflevector(c, d, 0, 4, 2, 6) + __builtin_shufflevector(c, d, 1, 5, 3, 7);
  return __builtin_shufflevector(ab, cd, 0, 1, 4, 5) + __builtin_shufflevector(ab, cd, 2, 3, 6, 7);
}
#endif

// a b + c and c - a b. Compilers make a product of its own where both are wanted of one.
inline Real multiply_add(Real a, Real b, Real c) {
#if NANOCARBON_LANES == 8
  return (Real)_mm512_maskz_fmadd_pd(0xff, (__m512d)a, (__m512d)b, (__m512d)c);
#elif defined(__FMA__) && NANOCARBON_LANES == 4
  return (Real)_mm256_fmadd_pd((__m256d)a, (__m256d)b, (__m256d)c);
#else
  return a * b + c;
#endif
}

inline Real multiply_subtract(Real a, Real b, Real c) {
#if NANOCARBON_LANES == 8
  return (Real)_mm512_maskz_fnmadd_pd(0xff, (__m512d)a, (__m512d)b, (__m512d)c);
#elif defined(__FMA__) && NANOCARBON_LANES == 4
  return (Real)_mm256_fnmadd_pd((__m256d)a, (__m256d)b, (__m256d)c);
#else
  return c - a * b;
#endif
}

// Bit l for each lane l.
inline std::uint32_t bits(PartMask mask) {
#if defined(__AVX__) && NANOCARBON_LANES >= 4
  return static_cast<std::uint32_t>(_mm256_movemask_pd((__m256d)mask));
#elif defined(__SSE2__) && NANOCARBON_LANES == 2
  return static_cast<std::uint32_t>(_mm_movemask_pd((__m128d)mask));
#else
  std::uint32_t value = 0;
  for (int l = 0; l < part_lanes; ++l) value |= static_cast<std::uint32_t>(mask[l] & 1) << l;
  return value;
#endif
}

alignas(32) constexpr long long lane_masks[16][lj_lanes] = {
    {0, 0, 0, 0},   {-1, 0, 0, 0},   {0, -1, 0, 0},   {-1, -1, 0, 0},  {0, 0, -1, 0},  {-1, 0, -1, 0},
    {0, -1, -1, 0}, {-1, -1, -1, 0}, {0, 0, 0, -1},   {-1, 0, 0, -1},  {0, -1, 0, -1}, {-1, -1, 0, -1},
    {0, 0, -1, -1}, {-1, 0, -1, -1}, {0, -1, -1, -1}, {-1, -1, -1, -1}};

struct Roots {
  Real root, inverse, inverse_square;  // sqrt(X), 1 / sqrt(X), 1 / X
};

#if NANOCARBON_LANES == 8

// An estimate of 1 / sqrt(X) good to 14 bits, and the series in its error to the last bits: faster than the divider on
// Intel's processors. On Zen 5 an earlier form of this took longer than the divider; this one was not measured there.
struct RootStart {
  Real x, estimate;
};

inline RootStart start_root(Real x) { return {x, (Real)_mm512_maskz_rsqrt14_pd(0xff, (__m512d)x)}; }

inline Roots roots(const RootStart& start) {
  const Real product = start.x * start.estimate;
  const Real error = 1.0 - product * start.estimate;
  const Real rest = error * (0.5 + error * (0.375 + error * 0.3125));
  const Real inverse = start.estimate + start.estimate * rest;
  return {product + product * rest, inverse, inverse * inverse};
}

#else

// Refined estimates take longer than the divider here.
struct RootStart {
  Real root, inverse_square;
};

inline RootStart start_root(Real x) {
  Real root;
#if defined(__AVX__) && NANOCARBON_LANES == 4
  root = (Real)_mm256_sqrt_pd((__m256d)x);
#elif defined(__SSE2__) && NANOCARBON_LANES == 2
  root = (Real)_mm_sqrt_pd((__m128d)x);
#elif defined(__aarch64__) && NANOCARBON_LANES == 2
  root = (Real)vsqrtq_f64((float64x2_t)x);
#else
  for (int l = 0; l < lanes; ++l) root[l] = __builtin_sqrt(x[l]);
#endif
  return {root, 1.0 / x};
}

inline Roots roots(const RootStart& start) {
  return {start.root, start.root * start.inverse_square, start.inverse_square};
}

#endif

// 2^x to the last bits, for any x below 1000; the polynomial through the Chebyshev points of [-1/2, 1/2] is
// good to 3e-17.
inline Real power_of_two(Real x) {
  constexpr double coefficients[] = {1.0,
                                     0.69314718055994529,
                                     0.24022650695910167,
                                     0.055504108664821743,
                                     0.0096181291075857021,
                                     0.0013333558146400159,
                                     0.00015403530465300797,
                                     1.5252733834921392e-05,
                                     1.3215431843664287e-06,
                                     1.0178062970211954e-07,
                                     7.0743044015368168e-09,
                                     4.4546529428165133e-10};
  constexpr double to_integer = 0x1.8p52;  // what is added to it is rounded, and stands in the last bits
  const Real bounded = larger(x, all(-1000.0));
  const Real shifted = bounded + to_integer;
  const Real rest = bounded - (shifted - to_integer);
  Real value = all(coefficients[11]);
  for (int power = 10; power >= 0; --power) value = value * rest + coefficients[power];
  return (Real)((Mask)value + ((Mask)shifted << 52));
}
