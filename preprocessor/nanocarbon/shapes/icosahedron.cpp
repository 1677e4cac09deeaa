// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/shapes/icosahedron.h"

#include <numbers>

namespace nanocarbon::shapes {

TriangleMesh icosahedron(double edge) {
  // Three golden rectangles: the corners (0, +-1, +-phi) and their cyclic permutations have edges of
  // length 2.
  const double one = 0.5 * edge, phi = std::numbers::phi * one;
  return {{{-one, phi, 0},
           {one, phi, 0},
           {-one, -phi, 0},
           {one, -phi, 0},
           {0, -one, phi},
           {0, one, phi},
           {0, -one, -phi},
           {0, one, -phi},
           {phi, 0, -one},
           {phi, 0, one},
           {-phi, 0, -one},
           {-phi, 0, one}},
          {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
           {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
           {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};
}

}  // namespace nanocarbon::shapes
