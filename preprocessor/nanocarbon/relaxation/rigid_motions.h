#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "nanocarbon/core/vec3.h"

namespace nanocarbon {

//! \brief Translations and infinitesimal rotations of each piece of a molecule on its own, orthonormal.
//! \details Six for a piece, five for one on a line, three for an atom. Kept piece by piece: linear in atoms.
class RigidMotions {
 public:
  //! \param piece_of_atom pieces numbered from 0; empty for one piece
  RigidMotions(std::span<const Vec3> positions, std::span<const std::uint32_t> piece_of_atom);

  Eigen::Index count() const { return count_; }
  //! Takes the rigid part out of a displacement of all atoms (3 entries an atom).
  void project_out(Eigen::VectorXd& displacement) const;
  //! Every motion as a displacement of all atoms, one after the other.
  template <class Visitor>
  void visit(const Visitor& visitor) const {
    for (const Piece& piece : pieces_)
      for (Eigen::Index k = 0; k < piece.basis.cols(); ++k) {
        Eigen::VectorXd motion = Eigen::VectorXd::Zero(size_);
        for (std::size_t i = 0; i < piece.atoms.size(); ++i)
          motion.segment<3>(3 * Eigen::Index{piece.atoms[i]}) =
              piece.basis.col(k).segment<3>(static_cast<Eigen::Index>(3 * i));
        visitor(motion);
      }
  }

 private:
  struct Piece {
    std::vector<std::uint32_t> atoms;
    Eigen::MatrixXd basis;  // 3 entries an atom of the piece, a column each
  };
  std::vector<Piece> pieces_;
  Eigen::Index count_ = 0, size_ = 0;
};

}  // namespace nanocarbon
