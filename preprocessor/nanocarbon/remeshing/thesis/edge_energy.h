// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "nanocarbon/core/vec3.h"

namespace nanocarbon::thesis {

//! One term of Eq. 4.4 and 4.7: weight * (|x_a - x_b|^2 - m^2)^2.
struct EdgeTerm {
  std::uint32_t a;
  std::uint32_t b;
  double weight;  //!< how often the double sum meets this edge: 2 with both ends in the star, 1 with one
};

//! \brief The edges of a region with the points they join; the first `moving` points may move.
struct EdgeEnergy {
  std::vector<EdgeTerm> terms;
  std::vector<Vec3> points;   //!< Angstrom; moving ones first
  std::vector<Vec3> normals;  //!< of the moving points; empty where they may move freely (Eq. 4.4)
  std::size_t moving = 0;
  double m = 0.0;  //!< Angstrom
};

//! The energy at the points as they are, Angstrom^4.
double edge_energy(const EdgeEnergy& energy);

//! \brief Its gradient with respect to the moving points, Angstrom^3.
//! \details With normals the part along them is removed: the gradient in alpha and beta of Eq. 4.7, written
//! as a vector of space. Conjugate gradients on these vectors are the same as on the pairs (alpha, beta), for
//! T and T' are orthonormal.
void edge_energy_gradient(const EdgeEnergy& energy, std::vector<Vec3>& gradient);

struct MinimiserOptions {
  unsigned max_iterations = 30;
  double relative_decrease = 1e-3;  //!< ends where a step lowers the energy by less than this share of it
};

struct MinimiserResult {
  unsigned iterations = 0;
  double energy_before = 0.0;  //!< Angstrom^4
  double energy_after = 0.0;
};

//! Room for the vectors of minimise(), kept between calls.
struct MinimiserWorkspace {
  std::vector<Vec3> gradient, previous, direction;
};

//! \brief Minimises by conjugate gradients (Polak and Ribiere, as Press et al.).
//! \details Along a line the energy is a polynomial of fourth degree: its least value is found exactly, by
//! one pass over the terms and the roots of a cubic. The energy never rises.
MinimiserResult minimise(EdgeEnergy& energy, const MinimiserOptions& options, MinimiserWorkspace& workspace);

}  // namespace nanocarbon::thesis
