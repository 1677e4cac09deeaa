// SPDX-License-Identifier: GPL-2.0-or-later
// The loops of lj_kernel.h for vectors of NANOCARBON_LANES doubles. Included once by each lj_kernel_*.cpp,
// inside whose unnamed namespace everything stays. Written with the vector types of GCC and Clang.

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

struct Pair {
  Real scale, strength, steepness, slope, offset;  // as LjPairLanes
};

#if NANOCARBON_LANES == 8

// Two clusters side by side.
struct Neighbours {
  double* a;
  double* b;
  __mmask8 kept;
  __mmask8 hydrogen;

  Neighbours(LjCluster* clusters, const LjEntry* entries, int)
      : a(clusters[entries[0] >> lj_number_bit].position[0]),
        b(clusters[entries[1] >> lj_number_bit].position[0]),
        kept(static_cast<__mmask8>((entries[0] & 15) | (entries[1] & 15) << 4)),
        hydrogen(static_cast<__mmask8>((entries[0] >> lj_kind_bit & 15) | (entries[1] & 0xf0))) {}

  // Component 0 to 2 of the positions, 3 to 5 of the forces.
  Real get(int component) const {
    const int at = component * lj_lanes;
    const __m512d low = _mm512_castpd256_pd512(_mm256_load_pd(a + at));
    return (Real)_mm512_maskz_insertf64x4(0xff, low, _mm256_load_pd(b + at), 1);
  }
  void set(int component, Real value) const {
    const int at = component * lj_lanes;
    _mm256_store_pd(a + at, _mm512_maskz_extractf64x4_pd(0xf, (__m512d)value, 0));
    _mm256_store_pd(b + at, _mm512_maskz_extractf64x4_pd(0xf, (__m512d)value, 1));
  }
  Real only(Real value) const { return (Real)_mm512_maskz_mov_pd(kept, (__m512d)value); }
  void drop_from(Real x, double limit) {
    kept = _mm512_mask_cmp_pd_mask(kept, (__m512d)x, _mm512_set1_pd(limit), _CMP_NGE_UQ);
  }
};

// The parameters with carbon and with hydrogen; lanes choose between them.
template <bool mixed>
struct PairTable {
  Pair carbon, hydrogen;

  PairTable(const LjConstants& constants, std::uint32_t element)
      : carbon(every(constants.pair[element][0])), hydrogen(every(constants.pair[element][15])) {}

  static Pair every(const LjPairLanes& p) {
    return {all(p.scale[0]), all(p.strength[0]), all(p.steepness[0]), all(p.slope[0]), all(p.offset[0])};
  }
  static Real choose(const Neighbours& n, Real c, Real h) {
    return (Real)_mm512_mask_blend_pd(n.hydrogen, (__m512d)c, (__m512d)h);
  }
  Pair get(const Neighbours& n, const LjEntry*) const {
    if constexpr (!mixed) return carbon;
    return {choose(n, carbon.scale, hydrogen.scale), choose(n, carbon.strength, hydrogen.strength),
            choose(n, carbon.steepness, hydrogen.steepness), choose(n, carbon.slope, hydrogen.slope),
            choose(n, carbon.offset, hydrogen.offset)};
  }
};

#else

// One cluster, or a part of one.
struct Neighbours {
  double* a;
  Mask kept;

  Neighbours(LjCluster* clusters, const LjEntry* entries, int part)
      : a(clusters[*entries >> lj_number_bit].position[0] + part * part_lanes) {
    __builtin_memcpy(&kept, lane_masks[*entries & 15] + part * part_lanes, sizeof kept);
  }

  Real get(int component) const { return load(a + component * lj_lanes); }
  void set(int component, Real value) const { store(a + component * lj_lanes, value); }
  Real only(Real value) const {
#if NANOCARBON_LANES == 4
    return (Real)_mm256_and_pd((__m256d)value, (__m256d)kept);
#else
    return (Real)((Mask)value & kept);
#endif
  }
  void drop_from(Real x, double limit) { kept &= ~(x >= limit); }
};

template <bool mixed>
struct PairTable {
  const LjPairLanes* pairs;
  int part = 0;

  PairTable(const LjConstants& constants, std::uint32_t element) : pairs(constants.pair[element]) {}

  Pair get(const Neighbours&, const LjEntry* entry) const {
    const LjPairLanes& p = pairs[mixed ? *entry >> lj_kind_bit & 15 : 0];
    const int l = part * part_lanes;
    return {load(p.scale + l), load(p.strength + l), load(p.steepness + l), load(p.slope + l),
            load(p.offset + l)};
  }
};

#endif

#if NANOCARBON_LANES == 8

// An estimate of 1 / sqrt(X) good to 14 bits, and the series in its error to the last bits: faster than the divider on
// Intel's processors. On Zen 5 an earlier form of this took longer than the divider; this one was not measured there.
inline Roots roots(Real x) {
  const Real estimate = (Real)_mm512_maskz_rsqrt14_pd(0xff, (__m512d)x);
  const Real product = x * estimate;
  const Real error = 1.0 - product * estimate;
  const Real rest = error * (0.5 + error * (0.375 + error * 0.3125));
  const Real inverse = estimate + estimate * rest;
  return {product + product * rest, inverse, inverse * inverse};
}

#else

// Refined estimates take longer than the divider here.
inline Roots roots(Real x) {
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
  const Real inverse_square = 1.0 / x;
  return {root, root * inverse_square, inverse_square};
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

// The sums over lanes go to one lane of a cluster's components. Whole vectors are written, as whole vectors are
// read again soon: a processor hands over what it has just written only in one piece.
inline void add_to_lane(double (*force)[lj_lanes], std::uint32_t lane, Real x, Real y, Real z) {
  const std::uint32_t part = lane / part_lanes * part_lanes;
  PartMask mask;
  __builtin_memcpy(&mask, lane_masks[1u << lane] + part, sizeof mask);
  const double sums[3] = {sum(x), sum(y), sum(z)};
  for (int d = 0; d < 3; ++d) {
    const Part value = (Part)((PartMask)(Part{} + sums[d]) & mask);
    store(force[d] + part, load<Part>(force[d] + part) + value);
  }
}

template <bool morse, bool energy, bool hard_cutoff, bool mixed>
double evaluate_rows(const LjData& data) {
  const LjConstants& c = *data.constants;
  const Real begin = all(c.begin), slope_to_a = all(c.slope_to_a);
  LjCluster* clusters = data.clusters;
  Real energies = Real{};
  for (std::size_t r = 0; r < data.row_count; ++r) {
    const LjRow row = data.rows[r];
    LjCluster& own = clusters[row.place / lj_lanes];
    const std::uint32_t lane = row.place % lj_lanes;
    const Real own_x = all(own.position[0][lane]);
    const Real own_y = all(own.position[1][lane]);
    const Real own_z = all(own.position[2][lane]);
    PairTable<mixed> table(c, mixed ? row.element : 0);
    Real force_x = Real{}, force_y = Real{}, force_z = Real{};
    const LjEntry* end = data.entries + row.end;
    for (const LjEntry* entry = data.entries + row.begin; entry != end; entry += group)
      for (int part = 0; part < parts; ++part) {
#if NANOCARBON_LANES < 8
        table.part = part;
#endif
        Neighbours n(clusters, entry, part);
        const Pair pair = table.get(n, entry);
        const Real x = own_x - n.get(0), y = own_y - n.get(1), z = own_z - n.get(2);
        const Real squared = x * x + y * y + z * z;
        const Real scaled = squared * pair.scale;
        if (hard_cutoff) n.drop_from(scaled, c.cutoff_squared);
        const Roots s = roots(scaled);
        const Real t = larger(smaller(s.root - begin, all(1.0)), all(0.0));
        const Real rest = 1.0 - t;
        const Real cubic = rest * (1.0 + 2.0 * t);
        Real force;
        if (morse) {
          const Real y2 = power_of_two(s.root * pair.slope + pair.offset);
          const Real front = pair.strength * (s.inverse * y2) * rest;
          force = n.only(front * ((pair.slope * slope_to_a) * (y2 - 1.0) * cubic + (y2 - 2.0) * t));
          if (energy) energies += n.only(front * s.inverse * (y2 - 2.0) * cubic * squared);
        } else {
          const Real q2 = s.inverse_square * s.inverse_square;
          const Real q3 = q2 * s.inverse_square;
          const Real well = q3 * pair.steepness - pair.strength;
          const Real steep = q3 * pair.steepness + well;
          const Real front = q2 * q2 * rest;
          force = n.only(front * (steep * cubic + well * t * s.root));
          if (energy) energies += n.only(front * well * cubic * squared);
        }
        force_x = multiply_add(force, x, force_x);
        force_y = multiply_add(force, y, force_y);
        force_z = multiply_add(force, z, force_z);
        n.set(3, multiply_subtract(force, x, n.get(3)));
        n.set(4, multiply_subtract(force, y, n.get(4)));
        n.set(5, multiply_subtract(force, z, n.get(5)));
      }
    add_to_lane(own.force, lane, force_x, force_y, force_z);
  }
  return sum(energies) / 6.0;
}

double evaluate(const LjData& data, LjVariant variant) {
  using Loop = double (*)(const LjData&);
  static constexpr Loop loops[2][2][2][2] = {
      {{{evaluate_rows<false, false, false, false>, evaluate_rows<false, false, false, true>},
        {evaluate_rows<false, false, true, false>, evaluate_rows<false, false, true, true>}},
       {{evaluate_rows<false, true, false, false>, evaluate_rows<false, true, false, true>},
        {evaluate_rows<false, true, true, false>, evaluate_rows<false, true, true, true>}}},
      {{{evaluate_rows<true, false, false, false>, evaluate_rows<true, false, false, true>},
        {evaluate_rows<true, false, true, false>, evaluate_rows<true, false, true, true>}},
       {{evaluate_rows<true, true, false, false>, evaluate_rows<true, true, false, true>},
        {evaluate_rows<true, true, true, false>, evaluate_rows<true, true, true, true>}}}};
  return loops[variant.morse][variant.energy][variant.hard_cutoff][variant.mixed](data);
}

LjCounts search(const LjSearch& data, LjRow* rows, LjEntry* entries) {
  LjCounts counts = {0, 0};
  for (std::size_t r = 0; r < data.row_count; ++r) {
    const LjRow row = data.rows[r];
    const LjCluster& own = data.clusters[row.place / lj_lanes];
    const std::uint32_t lane = row.place % lj_lanes;
    Part at[3];
    for (int d = 0; d < 3; ++d) at[d] = Part{} + own.position[d][lane];
    const std::size_t begin = counts.entries;
    for (std::uint32_t k = row.begin; k < row.end; ++k) {
      const LjEntry entry = data.entries[k];
      const LjCluster& cluster = data.clusters[entry >> lj_number_bit];
      const double* reach = data.reach_squared[row.element][entry >> lj_kind_bit & 15];
      std::uint32_t beyond = 0;
      for (int part = 0; part < parts; ++part) {
        const int l = part * part_lanes;
        const Part x = at[0] - load<Part>(cluster.position[0] + l);
        const Part y = at[1] - load<Part>(cluster.position[1] + l);
        const Part z = at[2] - load<Part>(cluster.position[2] + l);
        beyond |= bits(x * x + y * y + z * z > load<Part>(reach + l)) << l;
      }
      const LjEntry left = entry & ~beyond;
      entries[counts.entries] = left;
      counts.entries += (left & 15) != 0;
    }
    if (counts.entries == begin) continue;
    while ((counts.entries - begin) % group != 0) entries[counts.entries++] = data.padding;
    rows[counts.rows++] = {row.place, row.element, static_cast<std::uint32_t>(begin),
                           static_cast<std::uint32_t>(counts.entries)};
  }
  return counts;
}
