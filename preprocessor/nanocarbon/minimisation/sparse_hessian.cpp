// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/minimisation/sparse_hessian.h"

#include <algorithm>

namespace nanocarbon::minimisation {

namespace {

// Greedy colouring: atoms of one colour have no coupled atom in common.
std::vector<std::uint32_t> colours(const CouplingRows& coupled, std::size_t atoms) {
  constexpr std::uint32_t none = ~0u;
  std::vector<std::uint32_t> colour(atoms, none);
  std::vector<std::size_t> taken;  // by colour: the last atom that met it, plus one
  for (std::size_t a = 0; a < atoms; ++a) {
    for (const std::uint32_t row : coupled.of(a))
      for (const std::uint32_t b : coupled.of(row))
        if (colour[b] != none) taken[colour[b]] = a + 1;
    std::uint32_t free = 0;
    while (free < taken.size() && taken[free] == a + 1) ++free;
    if (free == taken.size()) taken.push_back(0);
    colour[a] = free;
  }
  return colour;
}

}  // namespace

CouplingRows coupled_atoms(const NeighbourList& neighbours, unsigned reach) {
  CouplingRows rows{{0}, {}};
  std::vector<std::size_t> seen(neighbours.atoms(), 0);
  for (std::uint32_t a = 0; a < neighbours.atoms(); ++a) {
    std::size_t shell = rows.atoms.size();
    const auto first = static_cast<std::ptrdiff_t>(shell);
    rows.atoms.push_back(a);
    seen[a] = a + 1;
    for (unsigned distance = 0; distance < reach; ++distance) {
      const std::size_t end = rows.atoms.size();
      for (; shell < end; ++shell)
        for (const Neighbour& n : neighbours.of(rows.atoms[shell]))
          if (seen[n.atom] != a + 1) {
            seen[n.atom] = a + 1;
            rows.atoms.push_back(n.atom);
          }
    }
    std::sort(rows.atoms.begin() + first, rows.atoms.end());
    rows.offsets.push_back(rows.atoms.size());
  }
  return rows;
}

Eigen::SparseMatrix<double> sparse_hessian(std::span<const Vec3> positions, const CouplingRows& coupled,
                                           const EnergyFunction& energy, double step) {
  using Matrix = Eigen::SparseMatrix<double>;
  const std::size_t atoms = positions.size();
  const std::vector<std::uint32_t> colour = colours(coupled, atoms);
  std::vector<std::vector<std::uint32_t>> groups;
  for (std::uint32_t a = 0; a < atoms; ++a) {
    if (groups.size() <= colour[a]) groups.resize(colour[a] + 1);
    groups[colour[a]].push_back(a);
  }

  const auto size = static_cast<Matrix::Index>(3 * atoms);
  Matrix hessian(size, size);
  Eigen::VectorXi entries(size);
  for (std::size_t a = 0; a < atoms; ++a)
    entries.segment<3>(static_cast<Eigen::Index>(3 * a))
        .setConstant(static_cast<int>(3 * coupled.of(a).size()));
  hessian.reserve(entries);

  std::vector<Vec3> moved(positions.begin(), positions.end()), ahead(atoms), behind(atoms);
  const auto gradient = [&](const std::vector<std::uint32_t>& group, int axis, double by,
                            std::vector<Vec3>& at) {
    for (const std::uint32_t a : group) moved[a][axis] = positions[a][axis] + by;
    std::fill(at.begin(), at.end(), Vec3::Zero());
    energy(moved, at);
    for (const std::uint32_t a : group) moved[a][axis] = positions[a][axis];
  };
  for (const std::vector<std::uint32_t>& group : groups)
    for (int axis = 0; axis < 3; ++axis) {
      gradient(group, axis, step, ahead);
      gradient(group, axis, -step, behind);
      for (const std::uint32_t a : group)
        for (const std::uint32_t row : coupled.of(a))
          for (int d = 0; d < 3; ++d)
            hessian.insert(static_cast<Matrix::Index>(3 * row) + d,
                           static_cast<Matrix::Index>(3 * a) + axis) =
                (ahead[row][d] - behind[row][d]) / (2 * step);
    }
  hessian.makeCompressed();
  const Matrix transposed = hessian.transpose();
  return 0.5 * (hessian + transposed);
}

}  // namespace nanocarbon::minimisation
