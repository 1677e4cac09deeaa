// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/structures/capped_tube.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "nanocarbon/core/error.h"
#include "nanocarbon/molecule/dual.h"
#include "nanocarbon/shapes/lattice_surface.h"
#include "nanocarbon/structures/honeycomb.h"
#include "nanocarbon/structures/spring_relaxation.h"

namespace nanocarbon::structures {
namespace {

constexpr VertexIndex apex_a = 0, apex_b = 11;
VertexIndex rim_a(std::size_t i) { return static_cast<VertexIndex>(1 + i % 5); }
VertexIndex rim_b(std::size_t i) { return static_cast<VertexIndex>(6 + i % 5); }

//! The unfolded tube: rim a runs from 0 to the circumference, the straight part lies to its right, then comes
//! rim b.
struct Unfolded {
  std::array<shapes::Eisenstein, 5> spoke_end;  // of either cap, unfolded around its middle
  std::array<shapes::Eisenstein, 6> rim_a;      // the last is the first again, once around
  std::array<shapes::Eisenstein, 6> rim_b;
  shapes::Eisenstein circumference;
};

Unfolded unfold(const TubeCap& cap, shapes::Eisenstein axis) {
  Unfolded u;
  for (int i = 0; i < 5; ++i) u.spoke_end[i] = shapes::sixth_turn(i) * cap.spoke[i];
  // Each pentagon on the rim turns what follows back by 60 degrees.
  u.rim_a[0] = {0, 0};
  for (int i = 0; i < 5; ++i)
    u.rim_a[i + 1] = u.rim_a[i] + cap.spoke[(i + 1) % 5] * shapes::sixth_turn(1) - cap.spoke[i];
  u.circumference = u.rim_a[5];
  for (int i = 0; i < 6; ++i) u.rim_b[i] = axis + u.circumference - u.rim_a[5 - i];
  return u;
}

std::vector<shapes::LatticePiece> pieces_of(const Unfolded& u) {
  std::vector<shapes::LatticePiece> pieces;
  for (std::size_t i = 0; i < 5; ++i) {
    const std::size_t j = (i + 1) % 5;
    // The fifth triangle ends at the first spoke, turned by 300 degrees.
    const shapes::Eisenstein next = j == 0 ? shapes::sixth_turn(5) * u.spoke_end[0] : u.spoke_end[j];
    pieces.push_back({{apex_a, rim_a(i), rim_a(j)}, {shapes::Eisenstein{0, 0}, u.spoke_end[i], next}});
    pieces.push_back({{apex_b, rim_b(i), rim_b(j)}, {shapes::Eisenstein{0, 0}, u.spoke_end[i], next}});
    // Rim b is met in the opposite order.
    pieces.push_back({{rim_a(i + 1), rim_a(i), rim_b(5 - i)}, {u.rim_a[i + 1], u.rim_a[i], u.rim_b[i]}});
    pieces.push_back(
        {{rim_a(i + 1), rim_b(5 - i), rim_b(4 - i)}, {u.rim_a[i + 1], u.rim_b[i], u.rim_b[i + 1]}});
  }
  return pieces;
}

//! Whether the rims are far enough apart: no piece between them is flat or turned over, no pentagons of
//! theirs are neighbours.
bool clear_of_each_other(const Unfolded& u, const std::vector<shapes::LatticePiece>& pieces) {
  for (const shapes::Eisenstein a : u.rim_a)
    for (const shapes::Eisenstein b : u.rim_b)
      for (const int round : {-1, 0, 1})
        if (shapes::norm(b - a + shapes::Eisenstein{round, 0} * u.circumference) < 3) return false;
  return std::all_of(pieces.begin(), pieces.end(), [](const shapes::LatticePiece& p) {
    return shapes::cross(p.at[1] - p.at[0], p.at[2] - p.at[0]) > 0;
  });
}

Eigen::Vector2d in_plane(shapes::Eisenstein z) {
  return graphene_lattice_constant *
         Eigen::Vector2d(static_cast<double>(z.x) + 0.5 * static_cast<double>(z.y),
                         0.5 * std::numbers::sqrt3 * static_cast<double>(z.y));
}

//! The lattice vector that goes down the tube closest to a length, and aside by at most half a step of the
//! rim.
shapes::Eisenstein down(shapes::Eisenstein circumference, double length) {
  const Eigen::Vector2d around = in_plane(circumference).normalized(), axis(around.y(), -around.x());
  const double aside = in_plane(circumference).norm() / 10.0;
  shapes::Eisenstein best;
  double least = std::numeric_limits<double>::infinity();
  // Row by row along the lattice: the x that are within reach of the straight line down.
  const Eigen::Vector2d target = length * axis / graphene_lattice_constant;
  const auto x0 = std::llround(target.x() - target.y() / std::numbers::sqrt3);
  const auto y0 = std::llround(2.0 * target.y() / std::numbers::sqrt3);
  const auto reach = static_cast<std::int64_t>(std::ceil(1.2 * aside / graphene_lattice_constant)) + 1;
  for (std::int64_t x = x0 - reach; x <= x0 + reach; ++x)
    for (std::int64_t y = y0 - reach; y <= y0 + reach; ++y) {
      const Eigen::Vector2d step = in_plane({x, y});
      if (std::abs(step.dot(around)) > aside * (1.0 + 1e-9)) continue;
      // The length decides; of two as good the one that goes straighter.
      const double cost = std::abs(step.dot(axis) - length) + 1e-3 * std::abs(step.dot(around));
      if (cost < least - 1e-9) least = cost, best = {x, y};
    }
  return best;
}

//! Rolls the straight part up around z, and hangs the flat triangles of the caps in between rim and apex.
class Placement {
 public:
  Placement(const Unfolded& u, const std::vector<shapes::LatticePiece>& pieces)
      : pieces_(pieces), around_(in_plane(u.circumference)) {
    double top = 0.0, spoke = 0.0;
    for (int i = 0; i < 5; ++i) {
      corner_[rim_a(i)] = rolled(u.rim_a[i]);
      corner_[rim_b(5 - i)] = rolled(u.rim_b[i]);
      top += corner_[rim_a(i)].z() / 5.0;
      spoke += in_plane(u.spoke_end[i]).norm() / 5.0;
    }
    const double bottom = in_plane_z(u.rim_b[0] + u.rim_a[0]) - top;
    const double height = std::sqrt(std::max(spoke * spoke - radius() * radius(), 0.04 * spoke * spoke));
    corner_[apex_a] = Vec3(0.0, 0.0, top + height);
    corner_[apex_b] = Vec3(0.0, 0.0, bottom - height);
  }

  Vec3 operator()(const shapes::LatticePlace& place) const {
    const shapes::LatticePiece& piece = pieces_[place.piece];
    if (piece.corner[0] != apex_a && piece.corner[0] != apex_b) return rolled(place.at);
    const auto weight = shapes::barycentric(piece, place.at);
    return weight[0] * corner_[piece.corner[0]] + weight[1] * corner_[piece.corner[1]] +
           weight[2] * corner_[piece.corner[2]];
  }

 private:
  double radius() const { return around_.norm() / (2.0 * std::numbers::pi); }
  double in_plane_z(shapes::Eisenstein z) const {
    const Eigen::Vector2d p = in_plane(z), along = around_.normalized();
    return p.y() * along.x() - p.x() * along.y();
  }
  Vec3 rolled(shapes::Eisenstein z) const {
    const double angle = in_plane(z).dot(around_.normalized()) / radius();
    return {radius() * std::cos(angle), radius() * std::sin(angle), in_plane_z(z)};
  }

  const std::vector<shapes::LatticePiece>& pieces_;
  Eigen::Vector2d around_;
  std::array<Vec3, 12> corner_;
};

//! The mirror image, its rings turned round so that they stay counter-clockwise seen from outside.
void mirror(Molecule& molecule) {
  for (Vec3& p : molecule.positions) p.y() = -p.y();
  for (std::size_t r = 0; r < molecule.rings.size(); ++r)
    std::reverse(molecule.rings.atoms.begin() + molecule.rings.offsets[r] + 1,
                 molecule.rings.atoms.begin() + molecule.rings.offsets[r + 1]);
}

}  // namespace

Molecule capped_tube(int n, int m, double length) {
  if (!(length > 0.0)) throw UserError(Failure::usage, "the length of a capped tube must be above zero");
  if (n < 0 || m < 0 || n > 10000 || m > 10000)
    throw UserError(Failure::usage, fmt::format("({}, {}) is not a tube: indices go from 0 to 10000", n, m));
  // Mirror images get mirrored caps.
  const TubeCap cap = tube_cap(std::max(n, m), std::min(n, m));

  // A tube too short for its two jagged rims is lengthened until they are clear of each other.
  Unfolded unfolded;
  std::vector<shapes::LatticePiece> pieces;
  const shapes::Eisenstein circumference = unfold(cap, {0, 0}).circumference;
  for (double straight = length;; straight += 0.25) {
    unfolded = unfold(cap, down(circumference, straight));
    pieces = pieces_of(unfolded);
    if (clear_of_each_other(unfolded, pieces)) break;
  }

  const shapes::LatticeSurface surface = shapes::glue(pieces);
  const Placement place(unfolded, pieces);
  TriangleMesh triangulation;
  triangulation.triangles = surface.triangles;
  for (const shapes::LatticePlace& vertex : surface.vertices) triangulation.points.push_back(place(vertex));
  Molecule tube = molecule::dual(triangulation);
  relax_by_springs(tube, {});
  // The unfolded sheet is seen from outside; open_tube() rolls it the other way.
  if (n > m) mirror(tube);
  Vec3 middle = Vec3::Zero();
  for (const Vec3& p : tube.positions) middle += p / static_cast<double>(tube.size());
  for (Vec3& p : tube.positions) p -= middle;
  return tube;
}

}  // namespace nanocarbon::structures
