// SPDX-License-Identifier: GPL-2.0-or-later
// Half-edges in lanes: their geometry, and the forces that they amount to.

inline void measure(const LaneEdges& edges, std::size_t begin, std::size_t end) {
  for (std::size_t e = begin; e < end; e += lanes) {
    Index from, to, pair, place;
    for (int l = 0; l < lanes; ++l) {
      from[l] = edges.from[e + l];
      to[l] = edges.to[e + l];
      pair[l] = edges.pair[e + l];
      place[l] = static_cast<std::uint32_t>(e + l);
    }
    const Records p = load_records(edges.positions, from);
    const Records q = load_records(edges.positions, to);
    const Vector delta = {q.a - p.a, q.b - p.b, q.c - p.c};
    const Real squared = dot(delta, delta);
    const Real inverse_r = inverse_square_root(squared);
    const Real r = squared * inverse_r;
    store_records(edges.geometry, place, {delta.x * inverse_r, delta.y * inverse_r, delta.z * inverse_r, r});

    // The windows stand at the beginning of each pair's parameters.
    constexpr std::uint32_t stride = sizeof(LanePair) / (4 * sizeof(double));
    static_assert(sizeof(LanePair) % (4 * sizeof(double)) == 0);
    for (int l = 0; l < lanes; ++l) pair[l] *= stride;
    const Records window = load_records(&edges.constants->pairs[0].cutoff_begin, pair);
    const Real over = r - window.a;
    Records weights = {all(1.0), Real{}, all(1.0), Real{}};
    const Mask beyond = over > 0.0;
    if (any(beyond)) {
      const Real t = over * window.b, arm_t = over * window.c;
      if (any(beyond & ((t < 1.0) | (arm_t < 1.0)))) {
        const ValueAndSlope bond = cosine_switch(t);
        const ValueAndSlope arm = cosine_switch(arm_t);
        weights = {bond.value, bond.slope * window.b, arm.value, arm.slope * window.c};
      } else {  // no bonds any more
        weights.a = weights.c = beyond ? Real{} : weights.a;
      }
    }
    store_records(edges.weights, place, weights);
  }
}

inline void pull(const LaneEdges& edges, std::size_t end, double* forces) {
  for (std::size_t e = 0; e < end; e += lanes) {
    Index place;
    for (int l = 0; l < lanes; ++l) place[l] = static_cast<std::uint32_t>(e + l);
    const Records geometry = load_records(edges.geometry, place);
    const Records gradient = load_records(edges.gradient, place);
    const Vector u = {geometry.a, geometry.b, geometry.c};
    const Vector by_direction = {gradient.a, gradient.b, gradient.c};
    const Real inverse_r = inverse(geometry.d);
    const Real along = gradient.d - dot(by_direction, u) * inverse_r;
    store_records(edges.gradient, place,
                  {along * u.x + by_direction.x * inverse_r, along * u.y + by_direction.y * inverse_r,
                   along * u.z + by_direction.z * inverse_r, Real{}});
  }
  constexpr int width = sizeof(Quad) / sizeof(double);
  for (std::size_t e = 0; e < end;) {
    const std::uint32_t centre = edges.from[e];
    Quad sum[4 / width] = {};
    const auto add_to = [](double* to, const Quad& row) {
      Quad value;
      __builtin_memcpy(&value, to, sizeof value);
      value += row;
      __builtin_memcpy(to, &value, sizeof value);
    };
    for (; e < end && edges.from[e] == centre; ++e)
      for (int h = 0; h < 4 / width; ++h) {
        Quad pulled;
        __builtin_memcpy(&pulled, edges.gradient + 4 * e + h * width, sizeof pulled);
        add_to(forces + 4 * std::size_t{edges.to[e]} + h * width, -pulled);
        sum[h] += pulled;
      }
    for (int h = 0; h < 4 / width; ++h) add_to(forces + 4 * std::size_t{centre} + h * width, sum[h]);
  }
}
