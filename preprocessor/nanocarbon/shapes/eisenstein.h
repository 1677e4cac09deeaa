// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>

namespace nanocarbon::shapes {

//! A point x + y w of the triangular lattice, w = exp(i pi / 3), so that w^2 = w - 1. Exact while numbers are
//! below 2^31.
struct Eisenstein {
  std::int64_t x = 0;
  std::int64_t y = 0;

  friend auto operator<=>(const Eisenstein&, const Eisenstein&) = default;
  friend Eisenstein operator+(Eisenstein a, Eisenstein b) { return {a.x + b.x, a.y + b.y}; }
  friend Eisenstein operator-(Eisenstein a, Eisenstein b) { return {a.x - b.x, a.y - b.y}; }
  friend Eisenstein operator*(Eisenstein a, Eisenstein b) {
    return {a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x + a.y * b.y};
  }
};

inline Eisenstein conjugate(Eisenstein a) { return {a.x + a.y, -a.y}; }

//! Squared length, x^2 + x y + y^2.
inline std::int64_t norm(Eisenstein a) { return a.x * a.x + a.x * a.y + a.y * a.y; }

//! Signed area of the parallelogram of a and b in unit cells: the number of small triangles in the triangle 0
//! a b.
inline std::int64_t cross(Eisenstein a, Eisenstein b) { return a.x * b.y - a.y * b.x; }

//! w to the power k, any whole k.
inline Eisenstein sixth_turn(int k) {
  constexpr Eisenstein turns[6] = {{1, 0}, {0, 1}, {-1, 1}, {-1, 0}, {0, -1}, {1, -1}};
  return turns[((k % 6) + 6) % 6];
}

}  // namespace nanocarbon::shapes
