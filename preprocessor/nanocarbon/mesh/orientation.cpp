// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/orientation.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace nanocarbon::mesh {
namespace {

constexpr double half_epsilon = std::numeric_limits<double>::epsilon() / 2.0;

// A sum of doubles that do not overlap, the smallest first: an exact number. 192 terms are the most that a
// determinant of three differences can need.
class Expansion {
 public:
  void add(double value) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < size_; ++i) {
      const double sum = value + terms_[i];
      const double virtual_part = sum - value;
      const double error = (value - (sum - virtual_part)) + (terms_[i] - virtual_part);
      if (error != 0.0) terms_[kept++] = error;
      value = sum;
    }
    if (value != 0.0) terms_[kept++] = value;
    size_ = kept;
  }
  void add_product(double a, double b) {
    const double product = a * b;
    add(std::fma(a, b, -product));
    add(product);
  }
  void add_product(const Expansion& a, double b) {
    for (std::size_t i = 0; i < a.size_; ++i) add_product(a.terms_[i], b);
  }
  void subtract(const Expansion& other) {
    for (std::size_t i = 0; i < other.size_; ++i) add(-other.terms_[i]);
  }
  int sign() const { return size_ == 0 ? 0 : terms_[size_ - 1] > 0.0 ? 1 : -1; }

 private:
  std::array<double, 200> terms_;
  std::size_t size_ = 0;
};

// a - b without rounding.
std::array<double, 2> difference(double a, double b) {
  const double d = a - b;
  const double virtual_part = a - d;
  return {(a - (d + virtual_part)) + (virtual_part - b), d};
}

Expansion product(const std::array<double, 2>& a, const std::array<double, 2>& b) {
  Expansion result;
  for (const double x : a)
    for (const double y : b)
      if (x != 0.0 && y != 0.0) result.add_product(x, y);
  return result;
}

int exact_orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  std::array<std::array<std::array<double, 2>, 3>, 3> m;
  const std::array<const Vec3*, 3> rows = {&a, &b, &c};
  for (std::size_t row = 0; row < 3; ++row)
    for (int col = 0; col < 3; ++col)
      m[row][static_cast<std::size_t>(col)] = difference((*rows[row])[col], d[col]);
  Expansion determinant;
  for (std::size_t row = 0; row < 3; ++row) {
    const auto& next = m[(row + 1) % 3];
    const auto& last = m[(row + 2) % 3];
    Expansion minor = product(next[0], last[1]);
    minor.subtract(product(next[1], last[0]));
    for (const double z : m[row][2])
      if (z != 0.0) determinant.add_product(minor, z);
  }
  return determinant.sign();
}

int sign(double value) { return value > 0.0 ? 1 : value < 0.0 ? -1 : 0; }

}  // namespace

int orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 ad = a - d, bd = b - d, cd = c - d;
  const double bc1 = bd.x() * cd.y(), bc2 = bd.y() * cd.x();
  const double ca1 = cd.x() * ad.y(), ca2 = cd.y() * ad.x();
  const double ab1 = ad.x() * bd.y(), ab2 = ad.y() * bd.x();
  const double determinant = ad.z() * (bc1 - bc2) + bd.z() * (ca1 - ca2) + cd.z() * (ab1 - ab2);
  const double permanent = (std::abs(bc1) + std::abs(bc2)) * std::abs(ad.z()) +
                           (std::abs(ca1) + std::abs(ca2)) * std::abs(bd.z()) +
                           (std::abs(ab1) + std::abs(ab2)) * std::abs(cd.z());
  // Shewchuk's bound on the rounding errors above. With a permanent of zero every term is exactly zero.
  if (permanent == 0.0) return 0;
  if (std::abs(determinant) > (7.0 + 56.0 * half_epsilon) * half_epsilon * permanent)
    return -sign(determinant);
  return -exact_orientation(a, b, c, d);
}

int orientation_2d(const Vec3& a, const Vec3& b, const Vec3& c, int dropped) {
  const int x = (dropped + 1) % 3, y = (dropped + 2) % 3;
  const double left = (a[x] - c[x]) * (b[y] - c[y]);
  const double right = (a[y] - c[y]) * (b[x] - c[x]);
  const double determinant = left - right;
  if (std::abs(left) + std::abs(right) == 0.0) return 0;
  if (std::abs(determinant) > (3.0 + 16.0 * half_epsilon) * half_epsilon * (std::abs(left) + std::abs(right)))
    return sign(determinant);
  Expansion exact = product(difference(a[x], c[x]), difference(b[y], c[y]));
  exact.subtract(product(difference(a[y], c[y]), difference(b[x], c[x])));
  return exact.sign();
}

}  // namespace nanocarbon::mesh
