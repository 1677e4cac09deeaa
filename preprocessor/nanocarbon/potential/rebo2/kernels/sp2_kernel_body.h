// SPDX-License-Identifier: GPL-2.0-or-later
// The loops of sp2_kernel.h for vectors of NANOCARBON_LANES doubles. Included once by each sp2_kernel_*.cpp,
// inside whose unnamed namespace everything stays. Written with the vector types of GCC and Clang.

#include "nanocarbon/potential/rebo2/kernels/lanes_kernel_body.h"
#include "nanocarbon/potential/rebo2/kernels/sp2_records_kernel_body.h"

static_assert(sp2_block % lanes == 0 && sp2_block <= 32);

inline void put(Real* to, const Vector& v) {
  to[0] = v.x;
  to[1] = v.y;
  to[2] = v.z;
}

// The sine of an angle outside the fast case must not make infinities: such lanes are multiplied by zero.
inline Real sine_squared(Real cosine) { return larger(1.0 - cosine * cosine, all(1e-3)); }

struct Tensor {
  Real xx, yy, zz, xy, xz, yz;
};

inline Vector times(const Tensor& t, const Vector& v) {
  return {t.xx * v.x + t.xy * v.y + t.xz * v.z, t.xy * v.x + t.yy * v.y + t.yz * v.z,
          t.xz * v.x + t.yz * v.y + t.zz * v.z};
}

// Adds a a^T / |a|^2 of the part of arm across the axis.
inline void add_projected(Tensor& t, const Vector& axis, const Vector& arm, Real cosine, Real inverse_sine2) {
  const Vector a = {arm.x - cosine * axis.x, arm.y - cosine * axis.y, arm.z - cosine * axis.z};
  const Vector b = scaled(a, inverse_sine2);
  t.xx += a.x * b.x;
  t.yy += a.y * b.y;
  t.zz += a.z * b.z;
  t.xy += a.x * b.y;
  t.xz += a.x * b.z;
  t.yz += a.y * b.z;
}

// The unit vector along the part of an arm across the axis.
inline Vector across(const Vector& axis, const Vector& arm, Real cosine, Real inverse_sine) {
  return {(arm.x - cosine * axis.x) * inverse_sine, (arm.y - cosine * axis.y) * inverse_sine,
          (arm.z - cosine * axis.z) * inverse_sine};
}

// An arm of a dihedral and the angle between it and the axis.
struct Arm {
  int arm, angle;
};

//! Coefficients of g_C, by power; four pieces.
struct Angular {
  alignas(64) double table[6][8];

  inline explicit Angular(const Sp2Constants& c) {
    for (int power = 0; power < 6; ++power)
      for (int piece = 0; piece < 8; ++piece) table[power][piece] = c.angular[piece < 4 ? piece : 3][power];
  }
};

inline ValueAndSlope angular(const Sp2Constants& c, const Angular& a, Real x) {
  const Mask in1 = x >= c.knots[0], in2 = x >= c.knots[1], in3 = x >= c.knots[2];
  Real k[6];
#if NANOCARBON_LANES == 8
  const __m512i piece = (__m512i)(-(in1 + in2 + in3));
  for (int power = 0; power < 6; ++power)
    k[power] = (Real)_mm512_maskz_permutexvar_pd(0xff, piece, (__m512d)load(a.table[power]));
#else
  for (int power = 0; power < 6; ++power) {
    const Real low = in1 ? all(a.table[power][1]) : all(a.table[power][0]);
    const Real high = in3 ? all(a.table[power][3]) : all(a.table[power][2]);
    k[power] = in2 ? high : low;
  }
#endif
  Real value = k[5];
  Real slope = Real{};
  for (int power = 4; power >= 0; --power) {
    slope = slope * x + value;
    value = value * x + k[power];
  }
  return {value, slope};
}

// Fetches the positions of a block's atoms and their neighbours: [3 (1 + s) + d][lane].
inline void fetch_positions(const Sp2Data& data, std::size_t block, double (*to)[sp2_block]) {
  const std::uint32_t* atoms = data.atoms + block * sp2_block;
  const std::uint32_t* neighbours = data.neighbours + block * 3 * sp2_block;
  for (std::size_t l = 0; l < sp2_block; ++l) {
    const double* p = data.positions + 3 * std::size_t{atoms[l]};
    for (int d = 0; d < 3; ++d) to[d][l] = p[d];
  }
  for (int s = 0; s < 3; ++s)
    for (std::size_t l = 0; l < sp2_block; ++l) {
      const double* p = data.positions + 3 * std::size_t{neighbours[s * sp2_block + l]};
      for (int d = 0; d < 3; ++d) to[3 + 3 * s + d][l] = p[d];
    }
}

template <bool torsion_energy>
void first(const Sp2Data& data, std::size_t begin_block, std::size_t end_block) {
  const Sp2Constants& c = *data.constants;
  alignas(64) double positions[12][sp2_block];
  for (std::size_t block = begin_block; block < end_block; ++block) {
    fetch_positions(data, block, positions);
    double* geometry = data.geometry + std::size_t{data.slots[block]} * 12 * sp2_block;
    double* records = data.tensors + std::size_t{data.slots[block]} * 18 * sp2_block;
    std::uint32_t outside = 0;
    for (std::size_t l = 0; l < sp2_block; l += lanes) {
      Vector u[3];
      Mask bad = Mask{};
      for (int s = 0; s < 3; ++s) {
        const Vector delta = {load(&positions[3 + 3 * s][l]) - load(&positions[0][l]),
                              load(&positions[4 + 3 * s][l]) - load(&positions[1][l]),
                              load(&positions[5 + 3 * s][l]) - load(&positions[2][l])};
        const Real squared = larger(dot(delta, delta), all(1e-2));
        const Real inverse_r = inverse_square_root(squared);
        const Real r = squared * inverse_r;
        u[s] = scaled(delta, inverse_r);
        bad |= (r < c.shortest) | (r > c.longest);
        store(geometry + (4 * s) * sp2_block + l, u[s].x);
        store(geometry + (4 * s + 1) * sp2_block + l, u[s].y);
        store(geometry + (4 * s + 2) * sp2_block + l, u[s].z);
        store(geometry + (4 * s + 3) * sp2_block + l, r);
      }
      Tensor tensors[3] = {};
      Real made[18];
      for (int s = 0; s < 3; ++s) {
        const int k = (s + 1) % 3;
        const Real cosine = dot(u[s], u[k]);
        bad |= (cosine < c.lowest_cosine) | (cosine > c.highest_cosine);
        if constexpr (torsion_energy) {
          const Real inverse_sine = inverse_square_root(sine_squared(cosine));
          put(&made[6 * s], across(u[s], u[k], cosine, inverse_sine));
          put(&made[6 * k + 3], across(u[k], u[s], cosine, inverse_sine));
        } else {
          const Real inverse_sine2 = inverse(sine_squared(cosine));
          add_projected(tensors[s], u[s], u[k], cosine, inverse_sine2);
          add_projected(tensors[k], u[k], u[s], cosine, inverse_sine2);
        }
      }
      if constexpr (!torsion_energy)
        for (int s = 0; s < 3; ++s) {
          made[6 * s] = tensors[s].xx;
          made[6 * s + 1] = tensors[s].yy;
          made[6 * s + 2] = tensors[s].zz;
          made[6 * s + 3] = tensors[s].xy;
          made[6 * s + 4] = tensors[s].xz;
          made[6 * s + 5] = tensors[s].yz;
        }
      store_eighteens(records + 18 * l, made);
      for (int m = 0; m < lanes; ++m) outside |= static_cast<std::uint32_t>(bad[m] & 1) << (l + m);
    }
    data.outside[block] = outside;
  }
}

inline void scatter_forces(const Sp2Data& data, std::size_t block, const double (*pulls)[sp2_block]) {
  const std::uint32_t* atoms = data.atoms + block * sp2_block;
  const std::uint32_t* neighbours = data.neighbours + block * 3 * sp2_block;
  for (std::size_t l = 0; l < sp2_block; ++l) {
    double* f = data.forces + 3 * std::size_t{atoms[l]};
    for (int d = 0; d < 3; ++d) f[d] += pulls[d][l] + pulls[3 + d][l] + pulls[6 + d][l];
    for (int s = 0; s < 3; ++s) {
      double* g = data.forces + 3 * std::size_t{neighbours[s * sp2_block + l]};
      for (int d = 0; d < 3; ++d) g[d] -= pulls[3 * s + d][l];
    }
  }
}

// Of the four dihedrals around a bond: S, and the sum of 256/405 ((1 + cos)/2)^5 - 1/10.
struct Dihedrals {
  Real sum = all(4.0);
  Real torsion = all(-0.4);
};

// Takes the other end's unit vectors, and adds derivatives: of the sum of squared cosines by_square / 2, of
// the torsion sum by_torsion.
inline Dihedrals add_dihedrals(const Vector (&other)[2], const Arm (&arms)[2], const Vector* u,
                               const Real* cosine, const Real* inverse_sines, Real by_square, Real by_torsion,
                               Vector* by_direction, Vector& by_axis, Real* by_angle) {
  Dihedrals made;
  for (int n = 0; n < 2; ++n) {
    const auto [arm, angle] = arms[n];
    const Real inverse_sine = inverse_sines[angle];
    Vector y = {};
    Real q = Real{};
    for (const Vector& e : other) {
      const Real x = dot(u[arm], e) * inverse_sine;
      const Real half = 0.5 + 0.5 * x;
      const Real fourth = half * half * half * half;
      made.sum -= x * x;
      made.torsion += (256.0 / 405.0) * fourth * half;
      const Real by_x = by_square * x + by_torsion * (2.5 * 256.0 / 405.0) * fourth;
      add(y, e, by_x);
      q += by_x * x;
    }
    by_angle[angle] += q * cosine[angle] * (inverse_sine * inverse_sine);
    add(by_direction[arm], y, inverse_sine);
    add(by_axis, y, -cosine[angle] * inverse_sine);
  }
  return made;
}

template <bool torsion_energy>
void second(const Sp2Data& data, std::size_t begin_block, std::size_t end_block, Sp2Energy* energy) {
  const Sp2Constants& c = *data.constants;
  const Angular coefficients(c);
  Real repulsive = Real{}, sigma_pi = Real{}, conjugation = Real{}, dihedral = Real{}, torsional = Real{};
  alignas(64) double pulls[9][sp2_block];
  for (std::size_t block = begin_block; block < end_block; ++block) {
    const std::uint32_t* reverses = data.reverses + block * 3 * sp2_block;
    const double* geometry = data.geometry + std::size_t{data.slots[block]} * 12 * sp2_block;
    const Sp2Modifiers& modifiers = *data.modifiers[block];
    for (std::size_t l = 0; l < sp2_block; l += lanes) {
      Vector u[3];
      Real r[3];
      for (int s = 0; s < 3; ++s) {
        u[s] = {load(geometry + (4 * s) * sp2_block + l), load(geometry + (4 * s + 1) * sp2_block + l),
                load(geometry + (4 * s + 2) * sp2_block + l)};
        r[s] = load(geometry + (4 * s + 3) * sp2_block + l);
      }
      // Angle s is the one opposite to bond s: between bonds s + 1 and s + 2.
      // What the dihedrals need of its sine: 1 / sine with the torsion energy, else the square of that.
      Real cosine[3], inverse_sine[3], by_cosine[3];
      ValueAndSlope g[3];
      for (int s = 0; s < 3; ++s) {
        cosine[s] = dot(u[(s + 1) % 3], u[(s + 2) % 3]);
        inverse_sine[s] =
            torsion_energy ? inverse_square_root(sine_squared(cosine[s])) : inverse(sine_squared(cosine[s]));
        g[s] = angular(c, coefficients, cosine[s]);
        by_cosine[s] = Real{};
      }
      Real by_length[3];
      Vector by_direction[3] = {};
      const Real on = load(&modifiers.on[l]);
      for (int s = 0; s < 3; ++s) {
        const Real x = (r[s] - c.middle) * c.inverse_half_width;
        const ValueAndSlope v_r = polynomial<sp2_degree>(c.repulsion, x);
        const ValueAndSlope v_a = polynomial<sp2_degree>(c.attraction, x);
        const Real half_a = 0.5 * on * v_a.value;

        // p = (1 + P + g + g')^(-1/2) over the two angles at this bond.
        const int a = (s + 1) % 3, b = (s + 2) % 3;
        const Real p = inverse_square_root(c.one_plus_p + g[a].value + g[b].value);
        const Real by_sum = -0.5 * p * p * p * half_a;
        by_cosine[a] += by_sum * g[a].slope;
        by_cosine[b] += by_sum * g[b].slope;

        // Arm a encloses angle b with this bond, and arm b angle a.
        const Real torsion = load(&modifiers.torsion[s][l]);
        const Real by_product =
            -4.0 * torsion * half_a;  // both halves of the bond's energy, times 2 of the square
        Real sum = all(4.0), half_t = Real{};
        Real other_end[6];
        load_sixes(data.tensors, reverses + s * sp2_block + l, other_end);
        const Arm arms[] = {{a, b}, {b, a}};
        if constexpr (torsion_energy) {
          const Real barrier = torsion != 0.0 ? on * c.torsion_barrier : Real{};
          const Vector other[] = {{other_end[0], other_end[1], other_end[2]},
                                  {other_end[3], other_end[4], other_end[5]}};
          const Dihedrals dihedrals = add_dihedrals(other, arms, u, cosine, inverse_sine, by_product, barrier,
                                                    by_direction, by_direction[s], by_cosine);
          sum = dihedrals.sum;
          half_t = 0.5 * barrier * dihedrals.torsion;
          torsional += half_t;
        } else {
          const Tensor m = {other_end[0], other_end[1], other_end[2],
                            other_end[3], other_end[4], other_end[5]};
          for (const auto& [arm, angle] : arms) {
            const Vector y = times(m, u[arm]);
            const Real q = dot(y, u[arm]) * inverse_sine[angle];
            const Real f = by_product * inverse_sine[angle];
            sum -= q;
            by_cosine[angle] += f * q * cosine[angle];
            add(by_direction[arm], y, f);
            add(by_direction[s], y, -f * cosine[angle]);
          }
        }
        const Real pi = load(&modifiers.pi[s][l]);
        const Real order = p + torsion * sum + pi;
        const Real half_r = 0.5 * on * v_r.value;
        by_length[s] = 0.5 * on * c.inverse_half_width * (v_r.slope + v_a.slope * order);
        repulsive += half_r;
        sigma_pi += half_a * p;
        conjugation += half_a * pi;
        dihedral += half_a * torsion * sum;
        if (data.edge_energies)
          store(data.edge_energies + (block * 3 + s) * sp2_block + l,
                torsion_energy ? half_r + half_a * order + half_t : half_r + half_a * order);
      }
      for (int s = 0; s < 3; ++s) {
        const int a = (s + 1) % 3, b = (s + 2) % 3;
        add(by_direction[s], u[a], by_cosine[b]);
        add(by_direction[s], u[b], by_cosine[a]);
        const Real inverse_r = inverse(r[s]);
        const Real along = by_length[s] - dot(by_direction[s], u[s]) * inverse_r;
        store(&pulls[3 * s][l], along * u[s].x + by_direction[s].x * inverse_r);
        store(&pulls[3 * s + 1][l], along * u[s].y + by_direction[s].y * inverse_r);
        store(&pulls[3 * s + 2][l], along * u[s].z + by_direction[s].z * inverse_r);
      }
    }
    scatter_forces(data, block, pulls);
  }
  for (int m = 0; m < lanes; ++m) {
    energy->repulsive += repulsive[m];
    energy->sigma_pi += sigma_pi[m];
    energy->conjugation += conjugation[m];
    energy->dihedral += dihedral[m];
    if (torsion_energy) energy->torsion += torsional[m];
  }
}
