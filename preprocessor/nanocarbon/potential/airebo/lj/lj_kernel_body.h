// SPDX-License-Identifier: GPL-2.0-or-later
// The loops of lj_kernel.h for vectors of NANOCARBON_LANES doubles. Included once by each lj_kernel_*.cpp,
// inside whose unnamed namespace everything stays.

#include "nanocarbon/potential/airebo/lj/lj_lanes_kernel_body.h"

struct Pair {
  Real scale, strength, slope, offset;  // as LjPairLanes
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
    return {all(p.scale[0]), all(p.strength[0]), all(p.slope[0]), all(p.offset[0])};
  }
  static Real choose(const Neighbours& n, Real c, Real h) {
    return (Real)_mm512_mask_blend_pd(n.hydrogen, (__m512d)c, (__m512d)h);
  }
  Pair get(const Neighbours& n, const LjEntry*) const {
    if constexpr (!mixed) return carbon;
    return {choose(n, carbon.scale, hydrogen.scale), choose(n, carbon.strength, hydrogen.strength),
            choose(n, carbon.slope, hydrogen.slope), choose(n, carbon.offset, hydrogen.offset)};
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
    return {load(p.scale + l), load(p.strength + l), load(p.slope + l), load(p.offset + l)};
  }
};

#endif

// Forces on the atoms of one cluster, not yet summed over the vector's lanes: [atom][component].
struct OwnForces {
  alignas(64) double parts[lj_lanes][3][lanes];

  void clear() {
    for (auto& atom : parts)
      for (double* component : atom) store(component, Real{});
  }
  void set(std::uint32_t atom, Real x, Real y, Real z) {
    store(parts[atom][0], x);
    store(parts[atom][1], y);
    store(parts[atom][2], z);
  }
  // Whole vectors are written, as whole vectors are read again soon: a processor hands over what it has just written
  // only in one piece.
  void add_to(double (*force)[lj_lanes]) const {
    for (int d = 0; d < 3; ++d)
#if NANOCARBON_LANES >= 4
      store(force[d], load<Part>(force[d]) + sums(folded(parts[0][d]), folded(parts[1][d]),
                                                  folded(parts[2][d]), folded(parts[3][d])));
#else
      for (int l = 0; l < lj_lanes; ++l) force[d][l] += sum(load(parts[l][d]));
#endif
  }
};

// Neighbours of an atom, and where they are from it.
template <bool morse, bool hard_cutoff, bool mixed>
struct Group {
  static constexpr bool scaled = morse || mixed;
  Neighbours n;
  Pair pair;
  Real x, y, z, squared;
  RootStart start;  // of r, in units of sigma * width if scaled

  Group(const LjData& data, const LjShape& shape, const Real (&own)[3], const PairTable<mixed>& table,
        const LjEntry* entry, int part)
      : n(data.clusters, entry, part), pair(table.get(n, entry)) {
    x = own[0] - n.get(0);
    y = own[1] - n.get(1);
    z = own[2] - n.get(2);
    squared = x * x + y * y + z * z;
    const Real argument = scaled ? squared * pair.scale : squared;
    if (hard_cutoff) n.drop_from(argument, shape.cutoff_squared);
    start = start_root(argument);
  }
};

template <bool morse, bool energy, bool hard_cutoff, bool mixed>
double evaluate_rows(const LjData& data) {
  using Next = Group<morse, hard_cutoff, mixed>;
  constexpr bool scaled = Next::scaled;
  const LjConstants& c = *data.constants;
  const LjShape& shape = scaled ? c.scaled : c.carbon;
  const Real begin = all(c.begin), slope_to_a = all(c.slope_to_a), to_switch = all(shape.to_switch);
  OwnForces own_forces;
  own_forces.clear();
  Real energies = Real{};
  Real force_x = Real{}, force_y = Real{}, force_z = Real{};
  const auto finish = [&](const Next& g) __attribute__((always_inline)) {
    const Roots s = roots(g.start);
    const Real t = larger(smaller(scaled ? s.root - begin : s.root * to_switch - begin, all(1.0)), all(0.0));
    const Real rest = 1.0 - t;
    Real force;
    if (morse) {
      const Real cubic = rest * (1.0 + 2.0 * t);
      const Real y2 = power_of_two(s.root * g.pair.slope + g.pair.offset);
      const Real front = g.pair.strength * (s.inverse * y2) * rest;
      force = g.n.only(front * ((g.pair.slope * slope_to_a) * (y2 - 1.0) * cubic + (y2 - 2.0) * t));
      if (energy) energies += g.n.only(front * s.inverse * (y2 - 2.0) * cubic * g.squared);
    } else {
      const Real q2 = s.inverse_square * s.inverse_square;
      const Real q3 = q2 * s.inverse_square;
      const Real steep = shape.steep[0] + t * (shape.steep[1] + t * shape.steep[2]);
      const Real well = shape.well[0] + t * (shape.well[1] + t * shape.well[2]);
      const Real front = mixed ? q2 * q2 * rest * g.pair.strength : q2 * q2 * rest;
      force = g.n.only(front * (q3 * steep - well));
      if (energy) {
        const Real cubic = rest * (1.0 + 2.0 * t);
        energies += g.n.only(front * (q3 * (0.5 * shape.steep[0]) - shape.well[0]) * cubic * g.squared);
      }
    }
    force_x = multiply_add(force, g.x, force_x);
    force_y = multiply_add(force, g.y, force_y);
    force_z = multiply_add(force, g.z, force_z);
    g.n.set(3, multiply_subtract(force, g.x, g.n.get(3)));
    g.n.set(4, multiply_subtract(force, g.y, g.n.get(4)));
    g.n.set(5, multiply_subtract(force, g.z, g.n.get(5)));
  };
  for (std::size_t r = 0; r < data.row_count; ++r) {
    const LjRow row = data.rows[r];
    LjCluster& own = data.clusters[row.place / lj_lanes];
    const std::uint32_t lane = row.place % lj_lanes;
    const Real at[3] = {all(own.position[0][lane]), all(own.position[1][lane]), all(own.position[2][lane])};
    PairTable<mixed> table(c, mixed ? row.element : 0);
    force_x = force_y = force_z = Real{};
    const LjEntry* end = data.entries + row.end;
    if constexpr (parts == 1) {
      // The next group is begun before one is finished, for the way to a force is long.
      const LjEntry* entry = data.entries + row.begin;
      Next next(data, shape, at, table, entry, 0);
      for (entry += group; entry != end; entry += group) {
        const Next g = next;
        next = Next(data, shape, at, table, entry, 0);
        finish(g);
      }
      finish(next);
    } else {
      for (const LjEntry* entry = data.entries + row.begin; entry != end; entry += group)
        for (int part = 0; part < parts; ++part) {
#if NANOCARBON_LANES < 8
          table.part = part;
#endif
          finish(Next(data, shape, at, table, entry, part));
        }
    }
    own_forces.set(lane, force_x, force_y, force_z);
    if (r + 1 == data.row_count || data.rows[r + 1].place / lj_lanes != row.place / lj_lanes) {
      own_forces.add_to(own.force);
      own_forces.clear();
    }
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
