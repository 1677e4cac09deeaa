// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "nanocarbon/core/vec3.h"

namespace nanocarbon::minimisation {

//! \brief Translations and infinitesimal rotations of each component of a molecule on its own, orthonormal.
//! \details Six for a component, five for one on a line, three for an atom. Kept component by component:
//! linear in atoms.
class RigidMotions {
 public:
  //! \param component_of_atom components numbered from 0; empty for one component
  RigidMotions(std::span<const Vec3> positions, std::span<const std::uint32_t> component_of_atom);

  Eigen::Index count() const { return count_; }
  //! Takes the rigid part out of a displacement of all atoms (3 entries an atom).
  void project_out(Eigen::VectorXd& displacement) const;
  //! Every motion as a displacement of all atoms, one after the other.
  template <class Visitor>
  void visit(const Visitor& visitor) const {
    for (const Component& component : components_)
      for (Eigen::Index k = 0; k < component.basis.cols(); ++k) {
        Eigen::VectorXd motion = Eigen::VectorXd::Zero(size_);
        for (std::size_t i = 0; i < component.atoms.size(); ++i)
          motion.segment<3>(3 * Eigen::Index{component.atoms[i]}) =
              component.basis.col(k).segment<3>(static_cast<Eigen::Index>(3 * i));
        visitor(motion);
      }
  }

 private:
  struct Component {
    std::vector<std::uint32_t> atoms;
    Eigen::MatrixXd basis;  // 3 entries an atom of the component, a column each
  };
  std::vector<Component> components_;
  Eigen::Index count_ = 0, size_ = 0;
};

}  // namespace nanocarbon::minimisation
