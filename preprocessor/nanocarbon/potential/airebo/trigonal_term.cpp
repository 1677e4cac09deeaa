// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/potential/airebo/trigonal_term.h"

#include <algorithm>
#include <cmath>

#include "nanocarbon/core/vec3.h"
#include "nanocarbon/potential/rebo2/angular_spline.h"
#include "nanocarbon/potential/rebo2/switching.h"

namespace nanocarbon::airebo {

using rebo2::ValueSlope;

namespace {

//! p at one end, and what its derivatives need.
struct HalfOrder {
  double p;
  std::array<double, 3> by_cosine;  // dg/dcos for each bond
};

Vec3 bond(const TrigonalCarbon& carbon, int b) {
  return {carbon.along[3 * b], carbon.along[3 * b + 1], carbon.along[3 * b + 2]};
}

HalfOrder half_order(const TrigonalCarbon& carbon, const Vec3& along, const rebo2::CarbonAngles& angles) {
  HalfOrder order = {};
  double sum = carbon.base;
  for (int b = 0; b < 3; ++b) {
    const ValueSlope g = rebo2::angular_carbon_few(angles, std::clamp(bond(carbon, b).dot(along), -1.0, 1.0));
    sum += g.value;
    order.by_cosine[b] = g.slope;
  }
  order.p = 1.0 / std::sqrt(sum);
  return order;
}

Eigen::Map<Vec3> force(double* forces, std::uint32_t atom) {
  return Eigen::Map<Vec3>(forces + 3 * std::size_t{atom});
}

//! Adds the forces of an energy that depends on p at one end to its neighbours and to itself.
//! \return its derivative by the direction of the pair
Vec3 add_end_forces(const TrigonalCarbon& end, const HalfOrder& order, const Vec3& along, double by_order,
                    double* forces) {
  const double by_sum = -0.25 * by_order * order.p * order.p * order.p;
  Vec3 by_direction = Vec3::Zero(), at_end = Vec3::Zero();
  for (int b = 0; b < 3; ++b) {
    const double by_cosine = by_sum * order.by_cosine[b];
    const Vec3 u = bond(end, b);
    by_direction += by_cosine * u;
    const Vec3 pull = by_cosine * end.inverse[b] * (along - along.dot(u) * u);
    force(forces, end.neighbours[b]) -= pull;
    at_end += pull;
  }
  force(forces, end.atom) += at_end;
  return by_direction;
}

}  // namespace

bool trigonal_order_is_plain(const rebo2::Rebo2Parameters& parameters) {
  using enum Element;
  if (!(parameters.carbon.few_end >= 3.0)) return false;
  for (const rebo2::TricubicTable* table : {&parameters.tables.f(carbon, carbon), &parameters.tables.t_cc})
    for (int k = 1; k <= 9; ++k) {
      const auto at = table->at(3, 3, k);
      if (at.value != 0.0 || at.slope[2] != 0.0) return false;
    }
  return true;
}

double add_trigonal_term(const TrigonalCarbon& i, const TrigonalCarbon& j, const std::array<double, 3>& along,
                         double length, const AireboModel& model, double* forces) {
  const Vec3 from_i(along[0], along[1], along[2]), from_j = -from_i;
  const rebo2::CarbonAngles& angles = model.parameters.rebo.carbon;
  const HalfOrder at_i = half_order(i, from_i, angles), at_j = half_order(j, from_j, angles);
  const LongRangeParameters& pair = model.parameters.long_range[0];
  const ValueSlope s_b =
      rebo2::cubic_switch(0.5 * (at_i.p + at_j.p), pair.order_switch_begin, pair.order_switch_end);
  if (s_b.value == 1.0) return 0.0;
  const ValueSlope s_r = rebo2::cubic_switch(length, pair.length_switch_begin, pair.length_switch_end);
  const LjValue v = lj_value(model.lj, 0, length);
  const double part = -s_r.value * (1.0 - s_b.value);
  Vec3 pull = (v.slope * part - v.energy * s_r.slope * (1.0 - s_b.value)) * from_i;
  if (s_b.slope != 0.0) {
    const double by_order = v.energy * s_r.value * s_b.slope;
    const Vec3 by_direction =
        add_end_forces(i, at_i, from_i, by_order, forces) - add_end_forces(j, at_j, from_j, by_order, forces);
    pull += (by_direction - by_direction.dot(from_i) * from_i) / length;
  }
  force(forces, i.atom) += pull;
  force(forces, j.atom) -= pull;
  return v.energy * part;
}

}  // namespace nanocarbon::airebo
