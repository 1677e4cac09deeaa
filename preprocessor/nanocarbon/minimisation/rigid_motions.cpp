// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/minimisation/rigid_motions.h"

#include <Eigen/Geometry>

namespace nanocarbon::minimisation {

namespace {

// Gram and Schmidt, twice for orthogonality to rounding; motions that the ones before it span are left out.
Eigen::MatrixXd orthonormal(const Eigen::MatrixXd& motions) {
  Eigen::MatrixXd basis(motions.rows(), motions.cols());
  Eigen::Index kept = 0;
  for (Eigen::Index k = 0; k < motions.cols(); ++k) {
    Eigen::VectorXd column = motions.col(k);
    const double before = column.norm();
    for (int pass = 0; pass < 2; ++pass)
      column -= basis.leftCols(kept) * (basis.leftCols(kept).transpose() * column);
    if (column.norm() <= 1e-8 * before || before == 0) continue;
    basis.col(kept++) = column.normalized();
  }
  return basis.leftCols(kept);
}

}  // namespace

RigidMotions::RigidMotions(std::span<const Vec3> positions, std::span<const std::uint32_t> component_of_atom)
    : size_(static_cast<Eigen::Index>(3 * positions.size())) {
  for (std::uint32_t a = 0; a < positions.size(); ++a) {
    const std::uint32_t component = component_of_atom.empty() ? 0 : component_of_atom[a];
    if (components_.size() <= component) components_.resize(component + 1);
    components_[component].atoms.push_back(a);
  }
  for (Component& component : components_) {
    const auto atoms = static_cast<Eigen::Index>(component.atoms.size());
    Vec3 centre = Vec3::Zero();
    for (const std::uint32_t a : component.atoms) centre += positions[a] / static_cast<double>(atoms);
    Eigen::MatrixXd motions(3 * atoms, 6);
    for (Eigen::Index i = 0; i < atoms; ++i)
      for (int d = 0; d < 3; ++d) {
        const Vec3 arm = positions[component.atoms[static_cast<std::size_t>(i)]] - centre;
        motions.block<3, 1>(3 * i, d) = Vec3::Unit(d);
        motions.block<3, 1>(3 * i, 3 + d) = Vec3::Unit(d).cross(arm);
      }
    component.basis = orthonormal(motions);
    count_ += component.basis.cols();
  }
}

void RigidMotions::project_out(Eigen::VectorXd& displacement) const {
  for (const Component& component : components_) {
    Eigen::VectorXd own(component.basis.rows());
    for (std::size_t i = 0; i < component.atoms.size(); ++i)
      own.segment<3>(static_cast<Eigen::Index>(3 * i)) =
          displacement.segment<3>(3 * Eigen::Index{component.atoms[i]});
    const Eigen::VectorXd share = component.basis.transpose() * own;
    const Eigen::VectorXd rigid = component.basis * share;
    for (std::size_t i = 0; i < component.atoms.size(); ++i)
      displacement.segment<3>(3 * Eigen::Index{component.atoms[i]}) -=
          rigid.segment<3>(static_cast<Eigen::Index>(3 * i));
  }
}

}  // namespace nanocarbon::minimisation
