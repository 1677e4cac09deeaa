// SPDX-License-Identifier: GPL-2.0-or-later
// Vectors of NANOCARBON_LANES doubles for the bodies of kernels, inside whose unnamed namespace everything stays.
// Written with the vector types of GCC and Clang.

constexpr int lanes = NANOCARBON_LANES;
using Real = double __attribute__((vector_size(8 * lanes)));
using Mask = long long __attribute__((vector_size(8 * lanes)));

struct Vector {
  Real x, y, z;
};

inline Real all(double value) { return Real{} + value; }

inline Real load(const double* from) {
  Real value;
  __builtin_memcpy(&value, from, sizeof value);
  return value;
}

inline void store(double* to, Real value) { __builtin_memcpy(to, &value, sizeof value); }

inline Real square_root(Real x) {
#if defined(__AVX512F__) && NANOCARBON_LANES == 8
  return (Real)_mm512_maskz_sqrt_pd(0xff, (__m512d)x);
#elif defined(__AVX__) && NANOCARBON_LANES == 4
  return (Real)_mm256_sqrt_pd((__m256d)x);
#elif defined(__SSE2__) && NANOCARBON_LANES == 2
  return (Real)_mm_sqrt_pd((__m128d)x);
#elif defined(__aarch64__) && NANOCARBON_LANES == 2
  return (Real)vsqrtq_f64((float64x2_t)x);
#else
  for (int l = 0; l < lanes; ++l) x[l] = __builtin_sqrt(x[l]);
  return x;
#endif
}

// 1 / sqrt(x) and 1 / x. Of eight lanes by estimates good to 14 bits and the series in their errors: the divider works on
// them for longer than everything else takes.
inline Real inverse_square_root(Real x) {
#if defined(__AVX512F__) && NANOCARBON_LANES == 8
  const Real estimate = (Real)_mm512_maskz_rsqrt14_pd(0xff, (__m512d)x);
  const Real error = 1.0 - x * estimate * estimate;
  return estimate + estimate * (error * (0.5 + error * (0.375 + error * 0.3125)));
#else
  return 1.0 / square_root(x);
#endif
}

inline Real inverse(Real x) {
#if defined(__AVX512F__) && NANOCARBON_LANES == 8
  const Real estimate = (Real)_mm512_maskz_rcp14_pd(0xff, (__m512d)x);
  const Real error = 1.0 - x * estimate;
  return estimate + estimate * (error + error * error * (1.0 + error));
#else
  return 1.0 / x;
#endif
}

inline Real larger(Real a, Real b) { return a > b ? a : b; }
inline Real smaller(Real a, Real b) { return a < b ? a : b; }
inline Real dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vector scaled(const Vector& a, Real f) { return {a.x * f, a.y * f, a.z * f}; }

inline void add(Vector& a, const Vector& b, Real f) {
  a.x += b.x * f;
  a.y += b.y * f;
  a.z += b.z * f;
}

struct ValueAndSlope {
  Real value, slope;
};

template <int degree>
inline ValueAndSlope polynomial(const double* coefficients, Real x) {
  Real value = all(coefficients[degree]);
  Real slope = Real{};
  for (int power = degree - 1; power >= 0; --power) {
    slope = slope * x + value;
    value = value * x + coefficients[power];
  }
  return {value, slope};
}
