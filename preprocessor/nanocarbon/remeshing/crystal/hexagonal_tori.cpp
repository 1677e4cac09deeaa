// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/remeshing/crystal/hexagonal_tori.h"

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

#include "nanocarbon/core/disjoint_sets.h"
#include "nanocarbon/mesh/measures.h"
#include "nanocarbon/mesh/mesh_topology.h"
#include "nanocarbon/mesh/split_in_four.h"
#include "nanocarbon/remeshing/crystal/corner_table.h"

namespace nanocarbon::crystal {
namespace {

using Vec2 = Eigen::Vector2d;
using Mat2 = Eigen::Matrix2d;

// Of graphene, eV/Angstrom^2: what a change of area and what a shear cost.
constexpr double bulk_modulus = 12.7, shear_modulus = 9.3;
// Cotangent weights are raised to this, so that the map is one to one.
constexpr double least_weight = 1e-3;
// The shortest way round the torus, in edges of the lattice: fewer make double edges.
constexpr double least_girth = 3.5;
// Lattices are looked for whose first edge is longer or shorter by this share.
constexpr double mismatch = 0.06;
// The surface is refined until its mean edge is below this many edges of the lattice.
constexpr double longest_edge = 0.7;

//! A surface mapped to a flat torus of the same area.
struct FlatTorus {
  std::vector<std::array<Vec2, 3>> corners;  //!< of each triangle, side by side
  Mat2 periods = Mat2::Zero();               //!< columns: the edges of a cell that tiles the plane
};

//! \name The harmonic map of a closed orientable surface of genus one.
//! @{

//! Two closed forms of whole numbers on half-edges whose integrals along closed paths take all pairs of whole
//! numbers: each counts how often a path crosses one of two loops (tree and cotree, Eppstein 2003).
std::array<std::vector<double>, 2> counting_forms(const CornerTable& table) {
  const std::size_t half_edges = table.half_edges(), triangles = half_edges / 3;
  DisjointSets trees(table.vertices());
  std::vector<bool> in_tree(half_edges, false);
  std::vector<HalfEdgeIndex> up(triangles, no_half_edge);  // the half-edge to cross towards the root
  std::vector<bool> in_cotree(half_edges, false), seen(triangles, false);
  for (HalfEdgeIndex h = 0; h < half_edges; ++h)
    if (table.is_edge(h) && trees.find(table.origin(h)) != trees.find(table.target(h))) {
      trees.join(table.origin(h), table.target(h));
      in_tree[h] = in_tree[table.twin(h)] = true;
    }
  std::vector<std::uint32_t> waiting = {0};
  seen[0] = true;
  for (std::size_t k = 0; k < waiting.size(); ++k)
    for (HalfEdgeIndex h = 3 * waiting[k]; h < 3 * waiting[k] + 3; ++h) {
      const HalfEdgeIndex other = table.twin(h);
      if (in_tree[h] || seen[other / 3]) continue;
      seen[other / 3] = true;
      up[other / 3] = other;
      in_cotree[h] = in_cotree[other] = true;
      waiting.push_back(other / 3);
    }
  std::array<std::vector<double>, 2> forms;
  std::size_t found = 0;
  for (HalfEdgeIndex h = 0; h < half_edges && found < 2; ++h) {
    if (!table.is_edge(h) || in_tree[h] || in_cotree[h]) continue;
    std::vector<double>& form = forms[found++];
    form.assign(half_edges, 0.0);
    const auto cross = [&](HalfEdgeIndex crossed, double sign) {
      form[crossed] += sign;
      form[table.twin(crossed)] -= sign;
    };
    cross(h, 1);
    for (std::uint32_t t = table.twin(h) / 3; up[t] != no_half_edge; t = table.twin(up[t]) / 3)
      cross(up[t], 1);
    for (std::uint32_t t = h / 3; up[t] != no_half_edge; t = table.twin(up[t]) / 3) cross(up[t], -1);
  }
  return forms;
}

//! Half the cotangents of the angles opposite to an edge.
std::vector<double> edge_weights(const TriangleMesh& mesh, const CornerTable& table) {
  std::vector<double> half(table.half_edges());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const std::array<Vec3, 3> p = corners_of(mesh, mesh.triangles[t]);
    for (std::uint32_t k = 0; k < 3; ++k) {
      const Vec3 u = p[k] - p[(k + 2) % 3], v = p[(k + 1) % 3] - p[(k + 2) % 3];
      half[3 * t + k] = 0.5 * u.dot(v) / std::max(u.cross(v).norm(), 1e-300);
    }
  }
  std::vector<double> weights(half.size());
  for (HalfEdgeIndex h = 0; h < weights.size(); ++h)
    weights[h] = std::max(half[h] + half[table.twin(h)], least_weight);
  return weights;
}

//! Makes closed forms harmonic by adding the differences of functions of the vertices.
bool make_harmonic(const CornerTable& table, const std::vector<double>& weights,
                   std::array<std::vector<double>, 2>& forms) {
  const auto n = static_cast<Eigen::Index>(table.vertices());
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::MatrixX2d right = Eigen::MatrixX2d::Zero(n, 2);
  for (HalfEdgeIndex h = 0; h < table.half_edges(); ++h) {
    const auto from = static_cast<Eigen::Index>(table.origin(h)),
               to = static_cast<Eigen::Index>(table.target(h));
    entries.emplace_back(from, from, weights[h]);
    if (from != 0 && to != 0) entries.emplace_back(from, to, -weights[h]);
    for (Eigen::Index k = 0; k < 2; ++k) right(from, k) += weights[h] * forms[static_cast<std::size_t>(k)][h];
  }
  right.row(0).setZero();  // where the functions are zero
  Eigen::SparseMatrix<double> laplacian(n, n);
  laplacian.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(laplacian);
  if (solver.info() != Eigen::Success) return false;
  const Eigen::MatrixX2d u = solver.solve(right);
  for (std::size_t k = 0; k < 2; ++k)
    for (HalfEdgeIndex h = 0; h < table.half_edges(); ++h)
      forms[k][h] +=
          u(table.target(h), static_cast<Eigen::Index>(k)) - u(table.origin(h), static_cast<Eigen::Index>(k));
  return u.allFinite();
}

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

std::optional<FlatTorus> flat_torus(const TriangleMesh& mesh, const CornerTable& table) {
  std::array<std::vector<double>, 2> forms = counting_forms(table);
  if (forms[1].empty()) return std::nullopt;
  const std::vector<double> weights = edge_weights(mesh, table);
  if (!make_harmonic(table, weights, forms)) return std::nullopt;
  const auto value = [&](HalfEdgeIndex h) { return Vec2(forms[0][h], forms[1][h]); };
  // Of all linear maps of the two integrals the conformal one: that with the same energy in every direction.
  Mat2 energy = Mat2::Zero();
  for (HalfEdgeIndex h = 0; h < table.half_edges(); ++h)
    energy += 0.5 * weights[h] * value(h) * value(h).transpose();
  FlatTorus flat;
  flat.periods = Eigen::SelfAdjointEigenSolver<Mat2>(energy).operatorInverseSqrt();
  double area = 0;
  for (HalfEdgeIndex h = 0; h < table.half_edges(); h += 3)
    area += 0.5 * cross(flat.periods * value(h), flat.periods * value(h + 1));
  if (area < 0) flat.periods.row(1) *= -1;
  flat.periods *= std::sqrt(mesh::area(mesh) / std::abs(area));
  if (!flat.periods.allFinite()) return std::nullopt;
  // Places of the vertices, followed from one to the next; of the other corners beside the first.
  std::vector<Vec2> place(table.vertices());
  std::vector<bool> placed(table.vertices(), false);
  std::vector<VertexIndex> waiting = {0};
  placed[0] = true;
  for (std::size_t k = 0; k < waiting.size(); ++k)
    table.for_outgoing(waiting[k], [&](HalfEdgeIndex h) {
      const VertexIndex to = table.target(h);
      if (placed[to]) return;
      placed[to] = true;
      place[to] = place[waiting[k]] + flat.periods * value(h);
      waiting.push_back(to);
    });
  for (HalfEdgeIndex h = 0; h < table.half_edges(); h += 3) {
    const Vec2 first = place[table.origin(h)], second = first + flat.periods * value(h);
    flat.corners.push_back({first, second, second + flat.periods * value(h + 1)});
  }
  return flat;
}
//! @}

//! The same lattice by two short vectors (Gauss), counter-clockwise.
Mat2 reduced(Mat2 periods) {
  if (periods.determinant() < 0) periods.col(1) *= -1;
  for (;;) {
    if (periods.col(0).squaredNorm() > periods.col(1).squaredNorm()) {
      const Vec2 longer = periods.col(0);
      periods.col(0) = periods.col(1);
      periods.col(1) = -longer;
    }
    const double part = periods.col(0).dot(periods.col(1)) / periods.col(0).squaredNorm();
    if (!(std::abs(part) > 0.5 + 1e-9)) return periods;
    periods.col(1) -= std::round(part) * periods.col(0);
  }
}

//! The triangular lattice modulo two of its vectors, numbered.
class LatticeTorus {
 public:
  //! \param edges columns: the two vectors in lattice coordinates, counter-clockwise
  explicit LatticeTorus(const Eigen::Matrix<std::int64_t, 2, 2>& edges) {
    // Another basis: (across, 0) and (shift, rows).
    std::int64_t a = edges(1, 0), b = edges(1, 1), s = 1, t = 0, s_next = 0, t_next = 1;
    while (b != 0) {
      const std::int64_t q = a / b;
      a -= q * b, std::swap(a, b);
      s -= q * s_next, std::swap(s, s_next);
      t -= q * t_next, std::swap(t, t_next);
    }
    if (a < 0) a = -a, s = -s, t = -t;
    rows_ = a;
    shift_ = s * edges(0, 0) + t * edges(0, 1);
    across_ = (edges(0, 0) * edges(1, 1) - edges(0, 1) * edges(1, 0)) / rows_;
  }
  std::size_t size() const { return static_cast<std::size_t>(across_ * rows_); }
  VertexIndex number(std::int64_t x, std::int64_t y) const {
    const std::int64_t turns = floor_division(y, rows_);
    y -= turns * rows_;
    x -= turns * shift_;
    x -= floor_division(x, across_) * across_;
    return static_cast<VertexIndex>(y * across_ + x);
  }
  std::vector<Triangle> triangles() const {
    std::vector<Triangle> result;
    for (std::int64_t y = 0; y < rows_; ++y)
      for (std::int64_t x = 0; x < across_; ++x) {
        result.push_back({number(x, y), number(x + 1, y), number(x, y + 1)});
        result.push_back({number(x + 1, y), number(x + 1, y + 1), number(x, y + 1)});
      }
    return result;
  }

 private:
  static std::int64_t floor_division(std::int64_t a, std::int64_t b) {
    return a / b - (a % b != 0 && (a < 0) != (b < 0) ? 1 : 0);
  }
  std::int64_t across_ = 1, rows_ = 1, shift_ = 0;
};

struct Fit {
  Eigen::Matrix<std::int64_t, 2, 2> edges;  //!< of the torus, in lattice coordinates
  Mat2 deformation;                         //!< from the flat torus to the lattice
};

//! What a deformation of graphene costs, eV for each square Angstrom.
double elastic_energy(const Mat2& deformation) {
  const Mat2 strain = 0.5 * (deformation.transpose() * deformation - Mat2::Identity());
  const Mat2 shear = strain - 0.5 * strain.trace() * Mat2::Identity();
  return 0.5 * bulk_modulus * std::pow(strain.trace(), 2) + shear_modulus * shear.squaredNorm();
}

//! The least strained torus of a lattice that is about the flat one.
std::optional<Fit> best_fit(const Mat2& periods, const Mat2& lattice) {
  std::optional<Fit> best;
  double least = std::numeric_limits<double>::infinity();
  const Vec2 p = periods.col(0), q = periods.col(1);
  const double edge = lattice.col(0).norm(), length = p.norm(),
               slack = std::max(1.2 * edge, mismatch * length);
  const Mat2 to_lattice = lattice.inverse();
  const auto most = static_cast<std::int64_t>((length + slack) / edge * 2 / std::sqrt(3.0)) + 1;
  for (std::int64_t i = 1; i <= most; ++i)
    for (std::int64_t j = 0; j <= most; ++j) {  // within a sixth of a turn: all others are turned lattices
      const Vec2 first = lattice * Vec2(static_cast<double>(i), static_cast<double>(j));
      if (std::abs(first.norm() - length) > slack || first.norm() < least_girth * edge) continue;
      Mat2 turn;
      turn << p.dot(first), -cross(p, first), cross(p, first), p.dot(first);
      const Vec2 near = to_lattice * (turn * q / (length * first.norm()));
      for (int dk = -1; dk <= 1; ++dk)
        for (int dl = -1; dl <= 1; ++dl) {
          Eigen::Matrix<std::int64_t, 2, 2> edges;
          edges << i, std::llround(near.x()) + dk, j, std::llround(near.y()) + dl;
          if (edges(0, 0) * edges(1, 1) - edges(0, 1) * edges(1, 0) <= 0) continue;
          const Mat2 image = lattice * edges.cast<double>();
          if (reduced(image).col(0).norm() < least_girth * edge) continue;
          const Mat2 deformation = image * periods.inverse();
          const double energy = elastic_energy(deformation);
          if (energy >= least * (1 - 1e-9)) continue;
          least = energy;
          best = Fit{edges, deformation};
        }
    }
  return best;
}

//! Barycentric weights in the plane.
Vec3 weights_at(const std::array<Vec2, 3>& corners, const Vec2& at) {
  const double whole = cross(corners[1] - corners[0], corners[2] - corners[0]);
  return Vec3(cross(corners[1] - at, corners[2] - at), cross(corners[2] - at, corners[0] - at),
              cross(corners[0] - at, corners[1] - at)) /
         whole;
}

std::optional<TriangleMesh> triangulated(const TriangleMesh& component, std::size_t faces) {
  const double edge = std::sqrt(4 * mesh::area(component) / (std::sqrt(3.0) * static_cast<double>(faces)));
  TriangleMesh mesh = component;
  while (mesh::edge_lengths(mesh).mean > longest_edge * edge) mesh = mesh::split_in_four(mesh);
  const std::optional<FlatTorus> flat = flat_torus(mesh, CornerTable(mesh));
  if (!flat) return std::nullopt;
  Mat2 lattice;
  lattice << edge, 0.5 * edge, 0, 0.5 * std::sqrt(3.0) * edge;
  const std::optional<Fit> fit = best_fit(reduced(flat->periods), lattice);
  if (!fit) return std::nullopt;
  const LatticeTorus torus(fit->edges);
  TriangleMesh result;
  result.space = component.space;
  result.triangles = torus.triangles();
  result.points.resize(torus.size());
  std::vector<bool> placed(torus.size(), false);
  std::size_t left = torus.size();
  const Mat2 to_lattice = lattice.inverse() * fit->deformation;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    std::array<Vec2, 3> corners = flat->corners[t];
    for (Vec2& c : corners) c = to_lattice * c;
    const Vec2 low = corners[0].cwiseMin(corners[1]).cwiseMin(corners[2]),
               high = corners[0].cwiseMax(corners[1]).cwiseMax(corners[2]);
    constexpr double rounding = 1e-9;
    for (auto y = static_cast<std::int64_t>(std::ceil(low.y() - rounding));
         static_cast<double>(y) <= high.y() + rounding; ++y)
      for (auto x = static_cast<std::int64_t>(std::ceil(low.x() - rounding));
           static_cast<double>(x) <= high.x() + rounding; ++x) {
        const Vec3 weight = weights_at(corners, Vec2(static_cast<double>(x), static_cast<double>(y)));
        const VertexIndex v = torus.number(x, y);
        if (placed[v] || !(weight.minCoeff() > -rounding)) continue;
        const std::array<Vec3, 3> p = corners_of(mesh, mesh.triangles[t]);
        result.points[v] = weight[0] * p[0] + weight[1] * p[1] + weight[2] * p[2];
        placed[v] = true;
        --left;
      }
  }
  if (left > 0) return std::nullopt;  // the map is not one to one
  return result;
}

}  // namespace

std::optional<TriangleMesh> hexagonal_triangulation(const TriangleMesh& surface, std::size_t faces) {
  const mesh::MeshTopology topology = mesh::mesh_topology(surface);
  const double area = mesh::area(surface);
  TriangleMesh result;
  result.space = surface.space;
  for (std::size_t c = 0; c < topology.components; ++c) {
    const mesh::MeshComponent& kind = topology.component[c];
    if (kind.boundary_loops > 0 || !kind.orientable || kind.genus() != 1) return std::nullopt;
    TriangleMesh component;
    component.space = surface.space;
    constexpr VertexIndex none = std::numeric_limits<VertexIndex>::max();
    std::vector<VertexIndex> index(surface.points.size(), none);
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
      if (topology.component_of_face[t] != c) continue;
      Triangle own = surface.triangles[t];
      for (VertexIndex& v : own) {
        if (index[v] == none) {
          index[v] = static_cast<VertexIndex>(component.points.size());
          component.points.push_back(surface.points[v]);
        }
        v = index[v];
      }
      component.triangles.push_back(own);
    }
    const double share = mesh::area(component) / area;
    const auto made =
        triangulated(component, static_cast<std::size_t>(std::llround(share * static_cast<double>(faces))));
    if (!made) return std::nullopt;
    const auto first = static_cast<VertexIndex>(result.points.size());
    result.points.insert(result.points.end(), made->points.begin(), made->points.end());
    for (const Triangle& t : made->triangles)
      result.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
  return result;
}

}  // namespace nanocarbon::crystal
