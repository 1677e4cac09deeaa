// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/building/turn_components.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "nanocarbon/core/neighbours_within.h"
#include "nanocarbon/core/point_buckets.h"
#include "nanocarbon/core/random_stream.h"
#include "nanocarbon/mesh/nearest_point.h"

namespace nanocarbon::building {

namespace {

constexpr double sigma = 3.4, well_depth = 2.84e-3, reach = 5.0;  // Angstrom, eV, Angstrom
constexpr double closest = 1.0;  // Angstrom: atoms nearer than this count as that near
// A second's work or two: of each component by chance, then of the best by less and less.
constexpr std::size_t atoms_tried = 4'000'000, most_trials = 4000, least_trials = 60;
constexpr std::size_t kept_trials = 8, most_narrow_trials = 100, least_narrow_trials = 8;
constexpr double widest = 0.4, narrowest = 0.01;  // radians, of narrow trials
constexpr double leaving = 0.05;                  // Angstrom
constexpr std::size_t sampled_atoms = 200;

double lennard_jones(double squared) {
  const double ratio = sigma * sigma / std::max(squared, closest * closest);
  const double sixth = ratio * ratio * ratio;
  return 4 * well_depth * (sixth * sixth - sixth);
}

double energy_between(std::span<const Vec3> positions, const topology::Components& components) {
  const NeighbourList near = neighbours_within(positions, nullptr, reach);
  double energy = 0;
  for (std::size_t a = 0; a < positions.size(); ++a)
    for (const Neighbour& n : near.of(a))
      if (n.atom > a && components.of_atom[n.atom] != components.of_atom[a])
        energy += lennard_jones((positions[n.atom] - positions[a]).squaredNorm());
  return energy;
}

//! Atoms that stay where they are, and what others feel of them.
class Placed {
 public:
  explicit Placed(std::span<const Vec3> positions)
      : buckets_(positions, [&](std::size_t i) { return bin_of(positions[i]); }) {}

  //! Lennard-Jones energy of an atom there, eV.
  double energy(const Vec3& at) const {
    double sum = 0;
    const PointBuckets::Bin home = bin_of(at);
    for (std::int64_t dx = -1; dx <= 1; ++dx)
      for (std::int64_t dy = -1; dy <= 1; ++dy)
        for (std::int64_t dz = -1; dz <= 1; ++dz)
          buckets_.for_each_in({home[0] + dx, home[1] + dy, home[2] + dz},
                               [&](const PointBuckets::Entry& other) {
                                 const double squared = (other.position - at).squaredNorm();
                                 if (squared < reach * reach) sum += lennard_jones(squared);
                               });
    return sum;
  }

 private:
  static PointBuckets::Bin bin_of(const Vec3& p) {
    PointBuckets::Bin bin;
    for (int d = 0; d < 3; ++d) bin[d] = static_cast<std::int64_t>(std::floor(p[d] / reach));
    return bin;
  }

  PointBuckets buckets_;
};

Vec3 direction(RandomStream& random) {
  const double z = 2 * random.uniform() - 1, angle = 2 * std::numbers::pi * random.uniform();
  const double r = std::sqrt(1 - z * z);
  return {r * std::cos(angle), r * std::sin(angle), z};
}

//! One component: its atoms, its centre, and how far it is from the surface.
class Turnable {
 public:
  Turnable(std::vector<std::size_t> atoms, std::span<const Vec3> positions, const mesh::NearestPoint& surface)
      : atoms_(std::move(atoms)), surface_(surface) {
    for (const std::size_t a : atoms_) centre_ += positions[a];
    centre_ /= static_cast<double>(atoms_.size());
    Mat3 spread = Mat3::Zero();
    for (const std::size_t a : atoms_) {
      start_.push_back(positions[a] - centre_);
      spread += start_.back() * start_.back().transpose();
    }
    axes_ = Eigen::SelfAdjointEigenSolver<Mat3>(spread).eigenvectors();
    allowed_ = distance(Mat3::Identity()) + leaving;
  }

  std::size_t size() const { return atoms_.size(); }

  //! Lennard-Jones energy, eV.
  double energy(const Mat3& turn, const Placed& others) const {
    double sum = 0;
    for (const Vec3& p : start_) sum += others.energy(centre_ + turn * p);
    return sum;
  }

  bool on_surface(const Mat3& turn) const { return distance(turn) <= allowed_; }

  void place(const Mat3& turn, std::span<Vec3> positions) const {
    for (std::size_t i = 0; i < atoms_.size(); ++i) positions[atoms_[i]] = centre_ + turn * start_[i];
  }

  //! By at most an angle in radians: about any axis, or one of its own, about which it may be symmetric.
  Mat3 random_turn(double angle, RandomStream& random) const {
    const std::uint64_t axis = random.below(6);
    const Vec3 about = axis < 3 ? Vec3(axes_.col(static_cast<Eigen::Index>(axis))) : direction(random);
    return Eigen::AngleAxisd(angle * (2 * random.uniform() - 1), about).toRotationMatrix();
  }

 private:
  // Root mean square, of a sample.
  double distance(const Mat3& turn) const {
    const std::size_t step = std::max<std::size_t>(1, start_.size() / sampled_atoms);
    double sum = 0, count = 0;
    for (std::size_t i = 0; i < start_.size(); i += step, ++count) {
      const double d = surface_.nearest(centre_ + turn * start_[i]).distance;
      sum += d * d;
    }
    return std::sqrt(sum / count);
  }

  std::vector<std::size_t> atoms_;
  std::vector<Vec3> start_;  // from the centre
  Vec3 centre_ = Vec3::Zero();
  Mat3 axes_;
  double allowed_ = 0;
  const mesh::NearestPoint& surface_;
};

struct Trial {
  Mat3 turn;
  double energy;  // eV
};

// By less and less from where it is, whatever lowers the energy.
void improve(const Turnable& component, const Placed& others, Trial& best, RandomStream& random) {
  const std::size_t trials =
      std::clamp(atoms_tried / (kept_trials * component.size()), least_narrow_trials, most_narrow_trials);
  for (std::size_t k = 0; k < trials; ++k) {
    const double done = static_cast<double>(k) / static_cast<double>(trials);
    const double angle = widest * std::pow(narrowest / widest, done);
    const Mat3 tried = component.random_turn(angle, random) * best.turn;
    const double found = component.energy(tried, others);
    if (found < best.energy && component.on_surface(tried)) best = {tried, found};
  }
}

// The best of many turns by chance, the first of which leaves it as it lies.
Trial best_turn(const Turnable& component, const Placed& others, RandomStream& random) {
  const std::size_t trials = std::clamp(atoms_tried / component.size(), least_trials, most_trials);
  const auto lower = [](const Trial& a, const Trial& b) { return a.energy < b.energy; };
  std::vector<Trial> kept{{Mat3::Identity(), component.energy(Mat3::Identity(), others)}};
  for (std::size_t k = 0; k < trials; ++k) {
    const Mat3& from = kept[random.below(kept.size())].turn;
    Trial tried{component.random_turn(std::numbers::pi, random) * from, 0};
    tried.energy = component.energy(tried.turn, others);
    const bool full = kept.size() == kept_trials;
    if ((full && !lower(tried, kept.back())) || !component.on_surface(tried.turn)) continue;
    if (full) kept.pop_back();
    kept.insert(std::upper_bound(kept.begin(), kept.end(), tried, lower), tried);
  }
  for (Trial& trial : kept) improve(component, others, trial, random);
  return *std::min_element(kept.begin(), kept.end(), lower);
}

}  // namespace

TurnedComponents turn_components(std::span<Vec3> positions, const topology::Components& components,
                                 const TriangleMesh& surface, std::uint64_t seed) {
  TurnedComponents result;
  if (components.count < 2) return result;
  result.before = result.after = energy_between(positions, components);
  if (result.before == 0) return result;

  std::vector<std::vector<std::size_t>> atoms(components.count);
  for (std::size_t a = 0; a < positions.size(); ++a) atoms[components.of_atom[a]].push_back(a);
  std::stable_sort(atoms.begin(), atoms.end(),
                   [](const auto& a, const auto& b) { return a.size() > b.size(); });

  const std::vector<Vec3> given(positions.begin(), positions.end());
  const mesh::NearestPoint nearest(surface);
  std::vector<Vec3> placed;
  for (std::size_t k = 0; k < atoms.size(); ++k) {
    if (k > 0) {
      const Placed others(placed);
      const Turnable component(atoms[k], positions, nearest);
      const double before = component.energy(Mat3::Identity(), others);
      if (before != 0) {
        RandomStream random(seed, k);
        const Trial best = best_turn(component, others, random);
        if (best.energy < before) {
          component.place(best.turn, positions);
          ++result.turned;
        }
      }
    }
    for (const std::size_t a : atoms[k]) placed.push_back(positions[a]);
  }
  if (result.turned > 0) result.after = energy_between(positions, components);
  // What comes later may not be able to follow what was turned before it.
  if (result.after > result.before) {
    std::copy(given.begin(), given.end(), positions.begin());
    result.after = result.before;
    result.turned = 0;
  }
  return result;
}

}  // namespace nanocarbon::building
