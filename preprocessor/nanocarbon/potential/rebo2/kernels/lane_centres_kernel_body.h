// SPDX-License-Identifier: GPL-2.0-or-later
// The terms centred on atoms, an atom in each lane: half of the pair terms of each of its bonds, and p_ij.

//! An atom's bonds, and the derivatives by them.
template <int most>
struct LaneBond {
  Vector u[most];
  Real r[most], weight[most], weight_slope[most];
  Vector by_direction[most];
  Real by_length[most], by_weight[most];
  Real sum[most];     // under the root of p
  Real by_sum[most];  // dE/d of it
};

//! P of one pair of elements, and its slopes by N_C and N_H.
struct SplineValue {
  Real value, by_carbons, by_hydrogens;
};

NANOCARBON_INLINE SplineValue bicubic(const double (*cells)[4], Real n_carbon, Real n_hydrogen) {
  const auto place = [](Real x, Real& t) {
    const Real inside = clamped(x, 0.0, 4.0);
    const Mask knot = (Mask)(inside >= 1.0) + (Mask)(inside >= 2.0) + (Mask)(inside >= 3.0);
    t = inside + __builtin_convertvector(knot, Real);
    return -knot;
  };
  Real c, h;
  const Mask cell = 4 * place(n_carbon, c) + place(n_hydrogen, h);
  Index index;
  for (int l = 0; l < lanes; ++l) index[l] = static_cast<std::uint32_t>(cell[l]);
  const Records corner = load_records(&cells[0][0], index);
  const Real rise_c = c * c * (3.0 - 2.0 * c), slope_c = 6.0 * c * (1.0 - c);
  const Real rise_h = h * h * (3.0 - 2.0 * h), slope_h = 6.0 * h * (1.0 - h);
  const Real low = corner.a + rise_h * (corner.b - corner.a), low_slope = slope_h * (corner.b - corner.a);
  const Real high = corner.c + rise_h * (corner.d - corner.c), high_slope = slope_h * (corner.d - corner.c);
  return {low + rise_c * (high - low), slope_c * (high - low), low_slope + rise_c * (high_slope - low_slope)};
}

inline Mask carbon_piece(const LaneConstants& c, Real x) {
  return -((Mask)(x >= c.carbon_knots[0]) + (Mask)(x >= c.carbon_knots[1]) + (Mask)(x >= c.carbon_knots[2]));
}

//! Pair terms and p of every bond, once the sums under the roots are there; sets by_sum.
template <int most, bool whole>
NANOCARBON_INLINE void add_pair_terms(const LaneEdges& edges, const LaneCentres& centres, LaneBond<most>& b,
                                      int n, Real on, const Index& first, std::size_t live,
                                      Real (&totals)[2]) {
  for (int s = 0; s < n; ++s) {
    const bool to_hydrogen = s >= centres.carbons;
    const PairTerms v =
        pair_terms(edges.constants->pairs[(centres.hydrogen ? 1 : 0) + (to_hydrogen ? 1 : 0)], b.r[s]);
    const Real p = inverse_square_root(b.sum[s]);
    Real half = all(0.5);
    // As in LAMMPS, a bond that is as good as cut has no terms of its own.
    if constexpr (!whole) half = b.weight[s] > 1e-9 ? half : Real{};
    const Real half_weight = whole ? half : half * b.weight[s];
    const Real repulsive = half_weight * v.repulsion.value;
    const Real sigma_pi = half_weight * v.attraction.value * p;
    totals[0] += on * repulsive;
    totals[1] += on * sigma_pi;
    b.by_sum[s] = -0.5 * p * p * sigma_pi;
    b.by_length[s] = half_weight * (v.repulsion.slope + p * v.attraction.slope);
    if constexpr (!whole) b.by_weight[s] = half * (v.repulsion.value + p * v.attraction.value);
    if (edges.energies)
      for (std::size_t l = 0; l < live; ++l) edges.energies[first[l] + s] = repulsive[l] + sigma_pi[l];
  }
}

template <int most, bool whole>
NANOCARBON_INLINE void store_bonds(const LaneEdges& edges, LaneBond<most>& b, int n, const Index& first) {
  for (int s = 0; s < n; ++s) {
    Index place;
    for (int l = 0; l < lanes; ++l) place[l] = first[l] + s;
    if constexpr (!whole) b.by_length[s] += b.by_weight[s] * b.weight_slope[s];
    store_records(edges.gradient, place,
                  {b.by_direction[s].x, b.by_direction[s].y, b.by_direction[s].z, b.by_length[s]});
  }
}

//! 1 + P of each bond of a carbon, and dP by both numbers.
template <int most, bool whole>
NANOCARBON_INLINE void begin_sums(const LaneConstants& c, const LaneCentres& centres, LaneBond<most>& b,
                                  int n, Real n_carbon, Real n_hydrogen, Real (&slopes)[2][most]) {
  for (int s = 0; s < n; ++s) {
    const int other = s >= centres.carbons;
    if constexpr (whole) {
      const int without_c = centres.carbons - (other ? 0 : 1),
                without_h = centres.hydrogens - (other ? 1 : 0);
      b.sum[s] = all(1.0 + c.p[other][without_c < 4 ? without_c : 4][without_h < 4 ? without_h : 4]);
    } else {
      const SplineValue p = bicubic(c.p_cells[other], other ? n_carbon : n_carbon - b.weight[s],
                                    other ? n_hydrogen - b.weight[s] : n_hydrogen);
      b.sum[s] = 1.0 + p.value;
      slopes[0][s] = p.by_carbons;
      slopes[1][s] = p.by_hydrogens;
    }
  }
}

//! Carbons. \tparam fixed how many bonds, or 0 for any number and both branches of g
template <int fixed, bool whole>
NANOCARBON_INLINE void carbon_centre(const LaneEdges& edges, const LaneCentres& centres,
                                     LaneBond<fixed ? fixed : lane_most_bonds>& b, Real on,
                                     const Index& first, std::size_t live, Real (&totals)[2]) {
  constexpr int most = fixed ? fixed : lane_most_bonds;
  constexpr bool branches = fixed == 0;
  constexpr int most_angles = most * (most - 1) / 2 + (most == 1);
  const int n = fixed ? fixed : centres.carbons + centres.hydrogens;
  const LaneConstants& c = *edges.constants;
  Real n_carbon = Real{}, n_hydrogen = Real{};
  if constexpr (!whole)
    for (int s = 0; s < n; ++s) (s < centres.carbons ? n_carbon : n_hydrogen) += b.weight[s];
  Real slopes[2][most];
  begin_sums<most, whole>(c, centres, b, n, n_carbon, n_hydrogen, slopes);

  ValueAndSlope g[most_angles], g_other[branches ? most_angles : 1];
  ValueAndSlope share[most];  // of the branch for few neighbours
  Real sum_by_n[most];
  if constexpr (branches) {
    const double inverse = 1.0 / (c.many_begin - c.few_end);
    for (int s = 0; s < n; ++s) {
      const Real n_ij = whole ? all(n - 1) : n_carbon + n_hydrogen - b.weight[s];
      share[s] = cosine_switch((n_ij - c.few_end) * inverse);
      share[s].slope *= inverse;
      sum_by_n[s] = Real{};
    }
  }
  for (int j = 0, angle = 0; j < n; ++j)
    for (int k = j + 1; k < n; ++k, ++angle) {
      const Real cosine = clamped(dot(b.u[j], b.u[k]), -1.0, 1.0);
      const Mask piece = carbon_piece(c, cosine);
      g[angle] = evaluate(choose(c.few, piece), cosine);
      Real at_j = g[angle].value, at_k = g[angle].value;
      if constexpr (branches) {
        // Kept: the branch for many, and what the other one has more.
        g_other[angle] = g[angle];
        g[angle] = evaluate(choose(c.many, piece), cosine);
        g_other[angle].value -= g[angle].value;
        g_other[angle].slope -= g[angle].slope;
        at_j = g[angle].value + share[j].value * g_other[angle].value;
        at_k = g[angle].value + share[k].value * g_other[angle].value;
        sum_by_n[j] += b.weight[k] * share[j].slope * g_other[angle].value;
        sum_by_n[k] += b.weight[j] * share[k].slope * g_other[angle].value;
      }
      b.sum[j] += whole ? at_j : b.weight[k] * at_j;
      b.sum[k] += whole ? at_k : b.weight[j] * at_k;
    }
  add_pair_terms<most, whole>(edges, centres, b, n, on, first, live, totals);

  for (int s = 0; s < n; ++s) b.by_direction[s] = Vector{};
  for (int j = 0, angle = 0; j < n; ++j)
    for (int k = j + 1; k < n; ++k, ++angle) {
      const Real by_j = whole ? b.by_sum[j] : b.by_sum[j] * b.weight[k];
      const Real by_k = whole ? b.by_sum[k] : b.by_sum[k] * b.weight[j];
      Real by_cosine = (by_j + by_k) * g[angle].slope;
      if constexpr (branches)
        by_cosine += (by_j * share[j].value + by_k * share[k].value) * g_other[angle].slope;
      add(b.by_direction[j], b.u[k], by_cosine);
      add(b.by_direction[k], b.u[j], by_cosine);
      if constexpr (!whole) {
        Real at_j = g[angle].value, at_k = g[angle].value;
        if constexpr (branches) {
          at_j += share[j].value * g_other[angle].value;
          at_k += share[k].value * g_other[angle].value;
        }
        b.by_weight[k] += b.by_sum[j] * at_j;
        b.by_weight[j] += b.by_sum[k] * at_k;
      }
    }
  if constexpr (!whole) {
    // Each bond's P (and g) depends on the weights of all others.
    Real by_numbers[2] = {};
    for (int s = 0; s < n; ++s)
      for (int h = 0; h < 2; ++h) {
        if constexpr (branches) slopes[h][s] += sum_by_n[s];
        slopes[h][s] *= b.by_sum[s];
        by_numbers[h] += slopes[h][s];
      }
    for (int s = 0; s < n; ++s) {
      const int h = s >= centres.carbons;
      b.by_weight[s] += by_numbers[h] - slopes[h][s];
    }
  }
}

//! Hydrogens: no P, no branches, but e^lambda.
template <int fixed, bool whole>
NANOCARBON_INLINE void hydrogen_centre(const LaneEdges& edges, const LaneCentres& centres,
                                       LaneBond<fixed ? fixed : lane_most_bonds>& b, Real on,
                                       const Index& first, std::size_t live, Real (&totals)[2]) {
  constexpr int most = fixed ? fixed : lane_most_bonds;
  constexpr int most_angles = most * (most - 1) / 2 + (most == 1);
  const int n = fixed ? fixed : centres.carbons + centres.hydrogens;
  const LaneConstants& c = *edges.constants;
  constexpr double lambda_slope = 4.0;
  ValueAndSlope g[most_angles];
  Real stretch[most], inverse_stretch[most];
  for (int s = 0; s < n; ++s) {
    b.sum[s] = all(1.0);
    if (n == 1) break;
    const double rho = c.pairs[s >= centres.carbons ? 2 : 1].equilibrium;
    stretch[s] = exponential(lambda_slope * (rho - b.r[s]));
    inverse_stretch[s] = inverse(stretch[s]);
  }
  for (int j = 0, angle = 0; j < n; ++j)
    for (int k = j + 1; k < n; ++k, ++angle) {
      const Real cosine = clamped(dot(b.u[j], b.u[k]), -1.0, 1.0);
      const Mask piece = -((Mask)(cosine >= c.hydrogen_knots[0]) + (Mask)(cosine >= c.hydrogen_knots[1]));
      g[angle] = evaluate(choose(c.hydrogen, piece), cosine);
      const Real at_j = g[angle].value * stretch[k] * inverse_stretch[j];
      const Real at_k = g[angle].value * stretch[j] * inverse_stretch[k];
      b.sum[j] += whole ? at_j : b.weight[k] * at_j;
      b.sum[k] += whole ? at_k : b.weight[j] * at_k;
    }
  add_pair_terms<most, whole>(edges, centres, b, n, on, first, live, totals);
  for (int s = 0; s < n; ++s) b.by_direction[s] = Vector{};
  for (int j = 0, angle = 0; j < n; ++j)
    for (int k = j + 1; k < n; ++k, ++angle) {
      // Derivatives by the weight of the third atom's bond, as each of the two bonds sees it.
      const Real by_k = b.by_sum[j] * stretch[k] * inverse_stretch[j];
      const Real by_j = b.by_sum[k] * stretch[j] * inverse_stretch[k];
      const Real weighted_k = whole ? by_k : by_k * b.weight[k];
      const Real weighted_j = whole ? by_j : by_j * b.weight[j];
      const Real by_cosine = (weighted_k + weighted_j) * g[angle].slope;
      add(b.by_direction[j], b.u[k], by_cosine);
      add(b.by_direction[k], b.u[j], by_cosine);
      const Real by_length = lambda_slope * (weighted_k - weighted_j) * g[angle].value;
      b.by_length[j] += by_length;
      b.by_length[k] -= by_length;
      if constexpr (!whole) {
        b.by_weight[k] += by_k * g[angle].value;
        b.by_weight[j] += by_j * g[angle].value;
      }
    }
}

template <int fixed, bool hydrogen, bool whole>
inline void centres_of(const LaneEdges& edges, const LaneCentres& centres, LaneEnergy* energy) {
  constexpr int most = fixed ? fixed : lane_most_bonds;
  const int n = fixed ? fixed : centres.carbons + centres.hydrogens;
  Real totals[2] = {};
  for (std::size_t begin = 0; begin < centres.count; begin += lanes) {
    const std::size_t left = centres.count - begin;
    const std::size_t live = left < lanes ? left : lanes;
    Index first;
    Real on = all(1.0);
    for (int l = 0; l < lanes; ++l) first[l] = centres.first[begin + l];
    for (int l = static_cast<int>(live); l < lanes; ++l) on[l] = 0.0;
    LaneBond<most> b;
    for (int s = 0; s < n; ++s) {
      Index place;
      for (int l = 0; l < lanes; ++l) place[l] = first[l] + s;
      const Records geometry = load_records(edges.geometry, place);
      b.u[s] = {geometry.a, geometry.b, geometry.c};
      b.r[s] = geometry.d;
      if constexpr (!whole) {
        const Records weights = load_records(edges.weights, place);
        b.weight[s] = weights.a;
        b.weight_slope[s] = weights.b;
      } else if constexpr (fixed == 0) {
        b.weight[s] = all(1.0);
      }
    }
    if constexpr (hydrogen)
      hydrogen_centre<fixed, whole>(edges, centres, b, on, first, live, totals);
    else
      carbon_centre<fixed, whole>(edges, centres, b, on, first, live, totals);
    // Lanes beyond the last atom repeat one: it gets the same gradient twice.
    store_bonds<most, whole>(edges, b, n, first);
  }
  energy->repulsive += sum_of(totals[0]);
  energy->sigma_pi += sum_of(totals[1]);
}

template <bool hydrogen, bool whole>
inline void centres_by_count(const LaneEdges& edges, const LaneCentres& centres, LaneEnergy* energy) {
  switch (centres.carbons + centres.hydrogens) {
    case 1:
      return centres_of<1, hydrogen, whole>(edges, centres, energy);
    case 2:
      return centres_of<2, hydrogen, whole>(edges, centres, energy);
    case 3:
      return centres_of<3, hydrogen, whole>(edges, centres, energy);
    case 4:
      return centres_of<4, hydrogen, whole>(edges, centres, energy);
    default:
      return centres_of<0, hydrogen, whole>(edges, centres, energy);
  }
}

inline void centres(const LaneEdges& edges, const LaneCentres& given, LaneEnergy* energy) {
  if (given.hydrogen)
    given.whole ? centres_by_count<true, true>(edges, given, energy)
                : centres_by_count<true, false>(edges, given, energy);
  else
    given.whole ? centres_by_count<false, true>(edges, given, energy)
                : centres_by_count<false, false>(edges, given, energy);
}
