// SPDX-License-Identifier: GPL-2.0-or-later
// The terms of bonds as a whole, a bond in each lane: pi_RC, T times the dihedrals, AIREBO's torsion energy.

struct Tricubic {
  Real value, by_i, by_j, by_conj;
};

//! Where in a table: the knot below, how far from it, and the four cubic Hermite functions with their slopes.
struct HermitePlace {
  Mask knot;
  Real t;
  Real value[2], value_slope[2], slope[2], slope_slope[2];

  inline void set(Real x, int first, int last) {
    const Real inside = clamped(x, first, last);
    // The knot below it, or at a knot that or the one before; t is exact.
    const Real magic = all(0x1.8p52);
    const Real rounded = inside - 0.5 + magic;
    const Real whole = clamped(rounded - magic, first, last - 1);
    t = inside - whole;
    knot = (Mask)(whole + magic) - (Mask)magic;
  }
  inline void weigh() {
    const Real rest = 1.0 - t;
    value[1] = t * t * (3.0 - 2.0 * t);
    value[0] = 1.0 - value[1];
    value_slope[1] = 6.0 * t * rest;
    value_slope[0] = -value_slope[1];
    slope[0] = t * rest * rest;
    slope[1] = -t * t * rest;
    slope_slope[0] = rest * (1.0 - 3.0 * t);
    slope_slope[1] = t * (3.0 * t - 2.0);
  }
};

//! The place in the tables F and T of each lane.
struct TablePlace {
  HermitePlace i, j, conj;
  bool at_knots;  // all lanes
  Index index;

  inline TablePlace(Real n_i, Real n_j, Real n_conj) {
    i.set(n_i, 0, 4);
    j.set(n_j, 0, 4);
    conj.set(n_conj, 1, 9);
    const auto between = [](Real t) { return (Mask)((t != 0.0) & (t != 1.0)); };
    at_knots = !any(between(i.t) | between(j.t) | between(conj.t));
    Mask cell = (i.knot * 5 + j.knot) * 9 + conj.knot - 1;
    if (at_knots) {
      cell -= (Mask)(i.t == 1.0) * 45 + (Mask)(j.t == 1.0) * 9 + (Mask)(conj.t == 1.0);
    } else {
      i.weigh();
      j.weigh();
      conj.weigh();
    }
    for (int l = 0; l < lanes; ++l) index[l] = static_cast<std::uint32_t>(cell[l]);
  }
};

NANOCARBON_INLINE Tricubic tricubic(const double (*table)[4], const TablePlace& at) {
  if (at.at_knots) {
    const Records knot = load_records(&table[0][0], at.index);
    return {knot.a, knot.b, knot.c, knot.d};
  }
  const HermitePlace &x = at.i, &y = at.j, &z = at.conj;
  Tricubic sum = {};
  for (int a = 0; a < 2; ++a) {
    // Along N_conj and N_ji; p has the slopes by N_ij.
    Real w = {}, w_y = {}, w_z = {}, p = {}, p_y = {}, p_z = {};
    for (int b = 0; b < 2; ++b) {
      const Records low = load_records(&table[a * 45 + b * 9][0], at.index);
      const Records high = load_records(&table[a * 45 + b * 9 + 1][0], at.index);
      const Real v = low.a * z.value[0] + high.a * z.value[1] + low.d * z.slope[0] + high.d * z.slope[1];
      const Real v_z = low.a * z.value_slope[0] + high.a * z.value_slope[1] + low.d * z.slope_slope[0] +
                       high.d * z.slope_slope[1];
      const Real si = low.b * z.value[0] + high.b * z.value[1];
      const Real si_z = low.b * z.value_slope[0] + high.b * z.value_slope[1];
      const Real sj = low.c * z.value[0] + high.c * z.value[1];
      const Real sj_z = low.c * z.value_slope[0] + high.c * z.value_slope[1];
      w += v * y.value[b] + sj * y.slope[b];
      w_y += v * y.value_slope[b] + sj * y.slope_slope[b];
      w_z += v_z * y.value[b] + sj_z * y.slope[b];
      p += si * y.value[b];
      p_y += si * y.value_slope[b];
      p_z += si_z * y.value[b];
    }
    sum.value += w * x.value[a] + p * x.slope[a];
    sum.by_i += w * x.value_slope[a] + p * x.slope_slope[a];
    sum.by_j += w_y * x.value[a] + p_y * x.slope[a];
    sum.by_conj += w_z * x.value[a] + p_z * x.slope[a];
  }
  return sum;
}

//! Neighbours of one end of a bond, seen from its axis, and the derivatives by them.
struct LaneArm {
  Vector u;
  Real cosine, inverse_sine;
  Real weight, weight_slope;      // of the bond
  Real arm, arm_slope;            // w'
  Real not_linear, linear_slope;  // 1 - Sp2, and its slope over the cosine
  Vector by_direction;
  Real by_length, by_cosine;
  Real to, hydrogen;
  Index edge;
};

NANOCARBON_INLINE LaneArm load_arm(const LaneEdges& edges, const std::uint32_t* arm, const Vector& axis,
                                   double sign, bool numbers) {
  LaneArm a;
  for (int l = 0; l < lanes; ++l) a.edge[l] = arm[l];
  const Records geometry = load_records(edges.geometry, a.edge);
  const Records weights = load_records(edges.weights, a.edge);
  a.u = {geometry.a, geometry.b, geometry.c};
  a.weight = weights.a;
  a.weight_slope = weights.b;
  a.arm = weights.c;
  a.arm_slope = weights.d;
  a.cosine = clamped(sign * dot(axis, a.u), -1.0, 1.0);
  const Real sine_squared = 1.0 - a.cosine * a.cosine;
  const Mask counts = sine_squared > 1e-18;
  a.inverse_sine = counts ? inverse_square_root(counts ? sine_squared : all(1.0)) : Real{};
  // The linear-angle switch, a cubic over cosines from -1 to -0.995.
  constexpr double window = 0.005;
  const Real t = smaller((a.cosine + 1.0) * (1.0 / window), all(1.0));
  a.not_linear = counts ? t * t * (3.0 - 2.0 * t) : Real{};
  a.linear_slope = counts ? 6.0 * t * (1.0 - t) * (1.0 / window) : Real{};
  a.by_direction = Vector{};
  a.by_length = a.by_cosine = Real{};
  if (numbers)
    for (int l = 0; l < lanes; ++l) {
      a.to[l] = edges.to[arm[l]];
      a.hydrogen[l] = edges.pair[arm[l]];  // the centre is a carbon
    }
  return a;
}

//! What the dihedrals of a bond need and give.
struct DihedralSums {
  Real by_sum;     // dE/dS
  Real strength;   // share and weight of the bond, for the torsion energy
  Real dihedrals;  // S
  Real torsion;    // the torsion energy without the bond's weight and share
};

template <bool torsion, bool triangles>
inline void add_dihedrals(const LaneConstants& c, LaneArm* at_i, int arms_i, LaneArm* at_j, int arms_j,
                          DihedralSums& sums) {
  for (int a = 0; a < arms_i; ++a)
    for (int b = 0; b < arms_j; ++b) {
      LaneArm& k = at_i[a];
      LaneArm& l = at_j[b];
      const Real inverse = k.inverse_sine * l.inverse_sine;
      const Real cosine = (dot(k.u, l.u) + k.cosine * l.cosine) * inverse;
      Real linear = k.not_linear * l.not_linear;
      Real slope_k = k.linear_slope * l.not_linear, slope_l = k.not_linear * l.linear_slope;
      if constexpr (triangles) {
        const Mask same = k.to == l.to;
        linear = same ? Real{} : linear;
        slope_k = same ? Real{} : slope_k;
        slope_l = same ? Real{} : slope_l;
      }
      const Real sine_squared = 1.0 - cosine * cosine;
      const Real arms = k.arm * l.arm;
      sums.dihedrals += sine_squared * arms * linear;
      const Real f = sums.by_sum * sine_squared;
      Real by_cosine = -2.0 * sums.by_sum * cosine * arms * linear;
      Real by_linear = f * arms;
      k.by_length += f * k.arm_slope * l.arm * linear;
      l.by_length += f * k.arm * l.arm_slope * linear;
      if constexpr (torsion) {
        const Real both = k.hydrogen * l.hydrogen, either = k.hydrogen + l.hydrogen;
        const Real barrier = c.barriers[0] + either * (c.barriers[1] - c.barriers[0]) +
                             both * (c.barriers[2] - 2.0 * c.barriers[1] + c.barriers[0]);
        const Real half = 0.5 + 0.5 * cosine;
        const Real fourth = (half * half) * (half * half);
        const Real value = barrier * ((256.0 / 405.0) * fourth * half - 0.1);
        const Real weights = k.weight * l.weight;
        sums.torsion += value * weights * linear;
        const Real g = sums.strength * value;
        by_cosine += sums.strength * barrier * (2.5 * 256.0 / 405.0) * fourth * weights * linear;
        by_linear += g * weights;
        k.by_length += g * k.weight_slope * l.weight * linear;
        l.by_length += g * k.weight * l.weight_slope * linear;
      }
      const Real by_product = by_cosine * inverse;
      const Real q = by_cosine * cosine;
      k.by_cosine +=
          q * k.cosine * k.inverse_sine * k.inverse_sine + by_product * l.cosine + by_linear * slope_k;
      l.by_cosine +=
          q * l.cosine * l.inverse_sine * l.inverse_sine + by_product * k.cosine + by_linear * slope_l;
      add(k.by_direction, l.u, by_product);
      add(l.by_direction, k.u, by_product);
    }
}

//! Adds what has been gathered at an arm to its gradient, and its part to the axis's.
NANOCARBON_INLINE void store_arm(const LaneEdges& edges, LaneArm& a, const Vector& axis, double sign,
                                 Vector& by_axis) {
  const Real by_cosine = sign * a.by_cosine;
  add(by_axis, a.u, by_cosine);
  add(a.by_direction, axis, by_cosine);
  add_records(edges.gradient, a.edge, {a.by_direction.x, a.by_direction.y, a.by_direction.z, a.by_length});
}

template <bool dihedrals, bool torsion, bool triangles>
inline void bonds_of(const LaneEdges& edges, const LaneBonds& bonds, LaneEnergy* energy) {
  const LaneConstants& c = *edges.constants;
  const int arms = bonds.arms_i + bonds.arms_j;
  Real conjugation = {}, dihedral = {}, torsional = {};
  LaneArm arm[dihedrals ? 2 * lane_most_bonds : 1];
  for (std::size_t begin = 0; begin < bonds.count; begin += lanes) {
    const std::size_t block = begin / lane_block, lane = begin % lane_block;
    double* numbers = bonds.numbers + block * lane_pieces * lane_block + lane;
    const auto number = [&](LaneBondPiece piece) { return numbers + piece * lane_block; };
    const Real sum_i = load(number(lane_sum_i)), sum_j = load(number(lane_sum_j));
    const Real share = load(number(lane_share));
    Index edge;
    for (int l = 0; l < lanes; ++l) edge[l] = bonds.edges[begin + l];
    const Records geometry = load_records(edges.geometry, edge);
    const Records weights = load_records(edges.weights, edge);
    const Vector axis = {geometry.a, geometry.b, geometry.c};
    const TablePlace place(load(number(lane_n_i)), load(number(lane_n_j)),
                           1.0 + sum_i * sum_i + sum_j * sum_j);
    const Tricubic pi = tricubic(c.f[bonds.pair], place);
    const ValueAndSlope v_a = attraction(c.pairs[bonds.pair], geometry.d);
    const Real strength = share * weights.a * v_a.value;
    Tricubic order = pi;
    Vector by_axis = {};
    Real by_length = {};
    if constexpr (dihedrals) {
      Tricubic t = tricubic(c.t, place);
      const Mask dropped = larger(t.value, -t.value) <= 1e-9;
      t = {dropped ? Real{} : t.value, dropped ? Real{} : t.by_i, dropped ? Real{} : t.by_j,
           dropped ? Real{} : t.by_conj};
      const std::uint32_t* arm_edges = bonds.arms + block * arms * lane_block + lane;
      for (int a = 0; a < arms; ++a)
        arm[a] = load_arm(edges, arm_edges + a * lane_block, axis, a < bonds.arms_i ? 1.0 : -1.0,
                          torsion || triangles);
      DihedralSums sums = {strength * t.value, share * weights.a, Real{}, Real{}};
      add_dihedrals<torsion, triangles>(c, arm, bonds.arms_i, arm + bonds.arms_i, bonds.arms_j, sums);
      for (int a = 0; a < arms; ++a) store_arm(edges, arm[a], axis, a < bonds.arms_i ? 1.0 : -1.0, by_axis);
      order.value += t.value * sums.dihedrals;
      order.by_i += t.by_i * sums.dihedrals;
      order.by_j += t.by_j * sums.dihedrals;
      order.by_conj += t.by_conj * sums.dihedrals;
      dihedral += strength * t.value * sums.dihedrals;
      if constexpr (torsion) {
        torsional += sums.strength * sums.torsion;
        by_length = share * sums.torsion * weights.b;
      }
    }
    conjugation += strength * pi.value;
    by_length += share * (weights.a * v_a.slope + v_a.value * weights.b) * order.value;
    add_records(edges.gradient, edge, {by_axis.x, by_axis.y, by_axis.z, by_length});
    if (edges.energies)
      for (int l = 0; l < lanes; ++l) edges.energies[edge[l]] += strength[l] * order.value[l];
    store(number(lane_n_i), strength * order.by_i);
    store(number(lane_n_j), strength * order.by_j);
    store(number(lane_sum_i), 2.0 * strength * order.by_conj * sum_i);
    store(number(lane_sum_j), 2.0 * strength * order.by_conj * sum_j);
  }
  energy->conjugation += sum_of(conjugation);
  energy->dihedral += sum_of(dihedral);
  energy->torsion += sum_of(torsional);
}

inline void bonds(const LaneEdges& edges, const LaneBonds& given, LaneEnergy* energy) {
  const bool torsion = given.dihedrals && edges.constants->torsion;
  if (!given.dihedrals) return bonds_of<false, false, false>(edges, given, energy);
  if (torsion)
    given.triangles ? bonds_of<true, true, true>(edges, given, energy)
                    : bonds_of<true, true, false>(edges, given, energy);
  else
    given.triangles ? bonds_of<true, false, true>(edges, given, energy)
                    : bonds_of<true, false, false>(edges, given, energy);
}
