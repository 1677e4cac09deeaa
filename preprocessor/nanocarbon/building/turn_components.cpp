// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/building/turn_components.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "nanocarbon/core/neighbours_within.h"
#include "nanocarbon/core/random_stream.h"
#include "nanocarbon/mesh/nearest_point.h"

namespace nanocarbon::building {

namespace {

constexpr double sigma = 3.4, well_depth = 2.84e-3, reach = 5.0;  // Angstrom, eV, Angstrom
constexpr double closest = 1.0;  // Angstrom: atoms nearer than this count as that near
constexpr std::size_t most_trials = 400, least_trials = 60, atoms_tried = 1'000'000;  // a second's work
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

// Returns whether it lies otherwise than before; `energy` is that of `positions`, before and after.
bool turn(const Turnable& component, const topology::Components& components, std::span<Vec3> positions,
          double& energy, RandomStream& random) {
  const std::size_t trials = std::clamp(atoms_tried / positions.size(), least_trials, most_trials);
  const std::size_t wide_trials = trials * 3 / 4;
  Mat3 best = Mat3::Identity();
  bool turned = false;
  for (std::size_t trial = 0; trial < trials; ++trial) {
    double angle = std::numbers::pi;
    if (trial >= wide_trials) {
      const double done =
          static_cast<double>(trial - wide_trials) / static_cast<double>(trials - wide_trials);
      angle = widest * std::pow(narrowest / widest, done);
    }
    const Mat3 tried = component.random_turn(angle, random) * best;
    if (!component.on_surface(tried)) continue;
    component.place(tried, positions);
    const double found = energy_between(positions, components);
    if (found >= energy) continue;
    energy = found;
    best = tried;
    turned = true;
  }
  component.place(best, positions);
  return turned;
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
                   [](const auto& a, const auto& b) { return a.size() < b.size(); });
  atoms.pop_back();

  const mesh::NearestPoint nearest(surface);
  for (std::size_t k = 0; k < atoms.size(); ++k) {
    RandomStream random(seed, k);
    if (turn(Turnable(std::move(atoms[k]), positions, nearest), components, positions, result.after, random))
      ++result.turned;
  }
  return result;
}

}  // namespace nanocarbon::building
