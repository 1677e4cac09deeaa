// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/minimisation/multilevel/sheet_preconditioner.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <utility>

#include "nanocarbon/core/chunks.h"
#include "nanocarbon/minimisation/multilevel/galerkin.h"
#include "nanocarbon/minimisation/multilevel/smoother.h"

namespace nanocarbon::multilevel {

namespace {

// Steps between chosen nodes: bonds between atoms, then between nodes whose cells touch. One node for about nine
// atoms, and for four nodes of the level below.
constexpr unsigned atom_separation = 4, node_separation = 2;
constexpr std::size_t coarsest_nodes = 150;
constexpr double least_coarsening = 0.8;

// Springs that have turned or stretched by more than this are out of date, Angstrom.
constexpr double most_strain = 0.5;

// Translations and turns about the centre, which no spring resists.
class RigidPart {
 public:
  struct Motion {
    Vec3 shift = Vec3::Zero(), turn = Vec3::Zero();
  };

  void set(std::span<const Vec3> positions, ThreadTeam* team) {
    positions_ = positions;
    centre_ = sum(team, [&](std::size_t a) { return positions[a]; }) / static_cast<double>(positions.size());
    Mat3 inertia = Mat3::Zero();
    for (const Vec3& p : positions) {
      const Vec3 arm = p - centre_;
      inertia += arm.squaredNorm() * Mat3::Identity() - arm * arm.transpose();
    }
    const Eigen::SelfAdjointEigenSolver<Mat3> axes(inertia);
    inverse_.setZero();
    for (int k = 0; k < 3; ++k)
      if (axes.eigenvalues()[k] > 1e-9 * axes.eigenvalues()[2])
        inverse_ +=
            axes.eigenvectors().col(k) * axes.eigenvectors().col(k).transpose() / axes.eigenvalues()[k];
  }

  //! The motion that is nearest to a displacement of all atoms.
  template <typename Displacement>
  Motion of(const Displacement& displacement, ThreadTeam* team) const {
    Motion motion;
    motion.shift = sum(team, displacement) / static_cast<double>(positions_.size());
    motion.turn = inverse_ * sum(team, [&](std::size_t a) -> Vec3 {
                    return (positions_[a] - centre_).cross(displacement(a));
                  });
    return motion;
  }
  Vec3 at(const Motion& motion, std::size_t atom) const {
    return motion.shift + motion.turn.cross(positions_[atom] - centre_);
  }

 private:
  template <typename Of>
  Vec3 sum(ThreadTeam* team, const Of& of) const {
    std::vector<Vec3> parts(chunks_of(positions_.size()), Vec3::Zero());
    for_chunks(team, positions_.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t a = begin; a < end; ++a) parts[begin / chunk_size] += of(a);
    });
    Vec3 whole = Vec3::Zero();
    for (const Vec3& part : parts) whole += part;
    return whole;
  }
  std::span<const Vec3> positions_;
  Vec3 centre_ = Vec3::Zero();
  Mat3 inverse_ = Mat3::Zero();  // of the inertia
};

struct Level {
  NodeGraph pattern;
  Smoother smoother;
  Interpolation interpolation;  // from the next level
  NodeGraph fine_of;            // its transpose, with weights
  std::vector<float> fine_weights;
  GalerkinProduct product;
  Displacements right, solution, residual;
};

// Solves on the coarsest level.
class CoarsestSolver {
 public:
  void set(const NodeGraph& pattern, const RowOf& row_of) {
    using Entry = Eigen::Triplet<double>;
    std::vector<Entry> entries;
    std::vector<Block> row;
    for (std::uint32_t i = 0; i < pattern.size(); ++i) {
      row_of(i, row);
      for (std::size_t k = 0; k < row.size(); ++k) {
        const Block& b = row[k];
        const double full[3][3] = {{b[0], b[1], b[2]}, {b[1], b[3], b[4]}, {b[2], b[4], b[5]}};
        for (int r = 0; r < 3; ++r)
          for (int c = 0; c < 3; ++c)
            entries.emplace_back(static_cast<int>(3 * i) + r, static_cast<int>(3 * pattern.of(i)[k]) + c,
                                 full[r][c]);
      }
    }
    const auto size = static_cast<Eigen::Index>(3 * pattern.size());
    Eigen::SparseMatrix<double> matrix(size, size);
    matrix.setFromTriplets(entries.begin(), entries.end());
    if (!analysed_) factors_.analyzePattern(matrix);
    analysed_ = true;
    factors_.factorize(matrix);
  }

  void solve(const Displacements& right, Displacements& solution) const {
    const Eigen::Map<const Eigen::VectorXf> b(right.data(), static_cast<Eigen::Index>(right.size()));
    const Eigen::VectorXd x = factors_.solve(b.cast<double>());
    Eigen::Map<Eigen::VectorXf>(solution.data(), x.size()) = x.cast<float>();
  }

 private:
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors_;
  bool analysed_ = false;
};

void set_transposed(Level& level, std::size_t coarse_nodes) {
  const NodeGraph& rows = level.interpolation.coarse;
  level.fine_of = transposed(rows, coarse_nodes);
  level.fine_weights.resize(rows.nodes.size());
  std::vector<std::uint32_t> fill(level.fine_of.offsets.begin(), level.fine_of.offsets.end() - 1);
  for (std::size_t e = 0; e < rows.nodes.size(); ++e)
    level.fine_weights[fill[rows.nodes[e]]++] = static_cast<float>(level.interpolation.weights[e]);
}

void restrict_residual(const Level& level, Displacements& coarse, ThreadTeam* team) {
  for_chunks(team, level.fine_of.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c) {
      float sum[3] = {0, 0, 0};
      for (std::uint32_t e = level.fine_of.offsets[c]; e < level.fine_of.offsets[c + 1]; ++e)
        for (std::size_t d = 0; d < 3; ++d)
          sum[d] += level.fine_weights[e] * level.residual[3 * level.fine_of.nodes[e] + d];
      std::copy_n(sum, 3, &coarse[3 * c]);
    }
  });
}

void add_correction(Level& level, const Displacements& coarse, ThreadTeam* team) {
  const NodeGraph& rows = level.interpolation.coarse;
  for_chunks(team, rows.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      float sum[3] = {0, 0, 0};
      for (std::uint32_t e = rows.offsets[i]; e < rows.offsets[i + 1]; ++e)
        for (std::size_t d = 0; d < 3; ++d)
          sum[d] += static_cast<float>(level.interpolation.weights[e]) * coarse[3 * rows.nodes[e] + d];
      for (std::size_t d = 0; d < 3; ++d) level.solution[3 * i + d] += sum[d];
    }
  });
}

}  // namespace

struct SheetPreconditioner::Levels {
  Space space;
  ThreadTeam* team = nullptr;
  NodeGraph bonds;                   // of atoms as they come
  bool connected = true;             // by bonds
  std::vector<std::uint32_t> order;  // atoms by place
  SheetSprings springs;              // by place
  std::vector<Level> all;
  NodeGraph coarsest_pattern;
  CoarsestSolver coarsest;
  Displacements coarsest_right, coarsest_solution;
  std::vector<Vec3> reference;  // positions that the springs are of, as they come
  Holds holds;                  // as they come
  RigidPart rigid;              // about the reference

  // Whether nothing says where the molecule is.
  bool floats() const { return connected && holds.empty() && !space.periodic(); }

  void build(std::span<const Vec3> positions, const SheetStiffness& stiffness) {
    order = compact_order(bonds);
    NodeGraph graph = renumbered(bonds, order);
    springs = SheetSprings(graph, stiffness);
    std::vector<Vec3> at = in_order(positions);
    NodeGraph pattern = springs.pattern();
    while (graph.size() > coarsest_nodes) {
      Coarsening coarsening = coarsen(graph, all.empty() ? atom_separation : node_separation);
      const std::size_t coarse = coarsening.chosen.size();
      if (static_cast<double>(coarse) > least_coarsening * static_cast<double>(graph.size())) break;
      Level& level = all.emplace_back();
      level.interpolation = quadratic_interpolation(space, at, coarsening);
      set_transposed(level, coarse);
      level.smoother = Smoother(pattern, team);
      level.product = GalerkinProduct(pattern, level.interpolation, coarse, team);
      level.pattern = std::exchange(pattern, level.product.pattern());
      for (Displacements* vector : {&level.right, &level.solution, &level.residual})
        vector->assign(3 * graph.size(), 0);
      graph = std::move(coarsening.graph);
      std::vector<Vec3> chosen;
      for (const std::uint32_t node : coarsening.chosen) chosen.push_back(at[node]);
      at = std::move(chosen);
    }
    coarsest_pattern = std::move(pattern);
    coarsest_right.assign(3 * coarsest_pattern.size(), 0);
    coarsest_solution = coarsest_right;
  }

  std::vector<Vec3> in_order(std::span<const Vec3> vectors) const {
    std::vector<Vec3> result;
    if (vectors.empty()) return result;
    result.reserve(order.size());
    for (const std::uint32_t atom : order) result.push_back(vectors[atom]);
    return result;
  }

  void renew() {
    if (floats()) rigid.set(reference, team);
    springs.set(space, in_order(reference), in_order(holds));
    std::vector<Block> blocks;
    RowOf row_of = [&](std::size_t node, std::vector<Block>& row) { springs.row(node, row); };
    for (std::size_t l = 0; l < all.size(); ++l) {
      Level& level = all[l];
      level.smoother.set(level.pattern, row_of);
      blocks = level.product.blocks(level.pattern, row_of, level.interpolation);
      const NodeGraph& pattern = l + 1 < all.size() ? all[l + 1].pattern : coarsest_pattern;
      row_of = [&blocks, &pattern](std::size_t node, std::vector<Block>& row) {
        row.assign(blocks.begin() + pattern.offsets[node], blocks.begin() + pattern.offsets[node + 1]);
      };
    }
    coarsest.set(coarsest_pattern, row_of);
  }

  void cycle() {
    const auto right_of = [&](std::size_t l) -> Displacements& {
      return l < all.size() ? all[l].right : coarsest_right;
    };
    for (std::size_t l = 0; l < all.size(); ++l) {
      all[l].smoother.sweep_from_zero(all[l].right, all[l].solution, all[l].residual);
      restrict_residual(all[l], right_of(l + 1), team);
    }
    coarsest.solve(coarsest_right, coarsest_solution);
    for (std::size_t l = all.size(); l-- > 0;) {
      add_correction(all[l], l + 1 < all.size() ? all[l + 1].solution : coarsest_solution, team);
      all[l].smoother.sweep_back(all[l].right, all[l].solution);
    }
  }
};

SheetPreconditioner::SheetPreconditioner(const Space& space, std::span<const Vec3> positions,
                                         const NodeGraph& bonds, ThreadTeam* team,
                                         const SheetStiffness& stiffness)
    : levels_(std::make_unique<Levels>()) {
  levels_->space = space;
  levels_->team = team;
  levels_->bonds = bonds;
  levels_->connected = is_connected(bonds);
  levels_->build(positions, stiffness);
}

SheetPreconditioner::~SheetPreconditioner() = default;
SheetPreconditioner::SheetPreconditioner(SheetPreconditioner&&) noexcept = default;
SheetPreconditioner& SheetPreconditioner::operator=(SheetPreconditioner&&) noexcept = default;

void SheetPreconditioner::renew(std::span<const Vec3> positions, const Holds& holds) {
  levels_->reference.assign(positions.begin(), positions.end());
  levels_->holds = holds;
  levels_->renew();
}

void SheetPreconditioner::renew_if_strained(std::span<const Vec3> positions) {
  const std::vector<Vec3>& reference = levels_->reference;
  const double strain2 =
      largest_in_chunks(levels_->team, positions.size(), [&](std::size_t begin, std::size_t end) {
        double largest = 0;
        for (std::size_t a = begin; a < end; ++a)
          for (const std::uint32_t n : levels_->bonds.of(a))
            if (n > a)
              largest = std::max(
                  largest, ((positions[n] - reference[n]) - (positions[a] - reference[a])).squaredNorm());
        return largest;
      });
  if (!(strain2 > most_strain * most_strain)) return;
  levels_->reference.assign(positions.begin(), positions.end());
  levels_->renew();
}

void SheetPreconditioner::apply(std::span<const Vec3> gradient, std::span<Vec3> step) const {
  const std::vector<std::uint32_t>& order = levels_->order;
  const bool direct = levels_->all.empty();
  Displacements& right = direct ? levels_->coarsest_right : levels_->all.front().right;
  // From both sides, so that the operator stays symmetric.
  const bool floats = levels_->floats();
  const RigidPart& rigid = levels_->rigid;
  RigidPart::Motion pull;
  if (floats) pull = rigid.of([&](std::size_t a) { return gradient[a]; }, levels_->team);
  for_chunks(levels_->team, order.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t place = begin; place < end; ++place) {
      Vec3 g = gradient[order[place]];
      if (floats) g -= rigid.at(pull, order[place]);
      for (int d = 0; d < 3; ++d) right[3 * place + static_cast<std::size_t>(d)] = static_cast<float>(g[d]);
    }
  });
  levels_->cycle();
  const Displacements& solution = direct ? levels_->coarsest_solution : levels_->all.front().solution;
  for_chunks(levels_->team, order.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t place = begin; place < end; ++place)
      for (int d = 0; d < 3; ++d)
        step[order[place]][d] = static_cast<double>(solution[3 * place + static_cast<std::size_t>(d)]);
  });
  if (!floats) return;
  const RigidPart::Motion drift = rigid.of([&](std::size_t a) { return step[a]; }, levels_->team);
  for_chunks(levels_->team, step.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t a = begin; a < end; ++a) step[a] -= rigid.at(drift, a);
  });
}

double SheetPreconditioner::strain(std::span<const Vec3> displacement) const {
  constexpr double share = 0.2;
  return std::sqrt(
      largest_in_chunks(levels_->team, displacement.size(), [&](std::size_t begin, std::size_t end) {
        double largest = 0;
        for (std::size_t a = begin; a < end; ++a) {
          if (!levels_->connected) largest = std::max(largest, share * share * displacement[a].squaredNorm());
          for (const std::uint32_t n : levels_->bonds.of(a))
            if (n > a) largest = std::max(largest, (displacement[n] - displacement[a]).squaredNorm());
        }
        return largest;
      }));
}

}  // namespace nanocarbon::multilevel
