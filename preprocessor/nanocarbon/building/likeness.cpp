// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/building/likeness.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "nanocarbon/mesh/distance.h"
#include "nanocarbon/mesh/measures.h"
#include "nanocarbon/mesh/nearest_point.h"
#include "nanocarbon/molecule/ring_mesh.h"
#include "nanocarbon/remeshing/crystal/surface_guide.h"

namespace nanocarbon::building {
namespace {

constexpr double bending_rigidity = 1.4;               // eV, of graphene
constexpr double stretching_modulus = 21;              // eV/Angstrom^2, of graphene
constexpr double energy_of_boundary = 1.2;             // eV/Angstrom, bare
constexpr double energy_with_hydrogen = 0.01;          // eV/Angstrom: nothing where straight, but corners
constexpr double ring_spacing = 2.46;                  // Angstrom
constexpr double disclination = std::numbers::pi / 3;  // Gaussian curvature that a pentagon stands for

// eV for a pentagon or heptagon that has so much of the surface, square Angstrom, for itself. Fitted to relaxed molecules
// under REBO2: C60, C240 and C540 (2.77, 4.00 and 4.50 eV for each pentagon, with 13, 52 and 118 square Angstrom), an
// icosahedral cage of 9,900 atoms (6.9 with 2,160); the schwarzites P144, P192, P432, P768 and P2304 (0.85, 0.93, 1.39,
// 1.81 and 2.81 eV for half an octagon, with 16, 21, 47, 84 and 251) and D168 (1.07 for a heptagon, with 18). The slopes
// are nearly those of cones, pi/3 times the rigidity.
struct CostOfDisclinations {
  double of_smallest, smallest, slope;
  double with(double area) const {
    return std::max(0.5 * of_smallest, of_smallest + 0.5 * slope * std::log(area / smallest));
  }
};
constexpr CostOfDisclinations pentagons{2.77, 13.1, 1.55}, heptagons{0.85, 15.7, 1.41};

// eV for each square Angstrom of a surface with this Gaussian curvature.
double density_of_disclinations(double gaussian) {
  const double per_area = std::abs(gaussian) / disclination;
  if (!(per_area > 0)) return 0;
  return per_area * (gaussian > 0 ? pentagons : heptagons).with(1 / per_area);
}

// eV of a disc without defects, stretched to so much Gaussian curvature in all.
double energy_of_strain(double area, double gaussian) {
  return stretching_modulus * area * gaussian * gaussian / (384 * std::numbers::pi * std::numbers::pi);
}

// How the normal turns on a triangle with the normals of its corners, as a map of its plane.
Eigen::Matrix2d shape_operator(const std::array<Vec3, 3>& p, const std::array<Vec3, 3>& n) {
  const Vec3 e1 = p[1] - p[0], e2 = p[2] - p[0];
  const Vec3 u = e1.normalized(), v = e1.cross(e2).normalized().cross(u);
  Eigen::Matrix2d edges, turns;
  edges << e1.dot(u), e2.dot(u), e1.dot(v), e2.dot(v);
  const Vec3 d1 = n[1] - n[0], d2 = n[2] - n[0];
  turns << d1.dot(u), d2.dot(u), d1.dot(v), d2.dot(v);
  return turns * edges.inverse();
}

// Mean distance of a surface from the sphere about its centroid that has its mean radius.
double distance_from_sphere(const TriangleMesh& surface) {
  if (surface.space.periodic()) return 0;
  constexpr std::size_t samples = 2000;
  const std::vector<Vec3> places = mesh::sample_by_area(surface, samples);
  Vec3 centroid = Vec3::Zero();
  for (const Vec3& p : places) centroid += p / static_cast<double>(places.size());
  double mean = 0, deviation = 0;
  for (const Vec3& p : places) mean += (p - centroid).norm() / static_cast<double>(places.size());
  for (const Vec3& p : places)
    deviation += std::abs((p - centroid).norm() - mean) / static_cast<double>(places.size());
  return deviation;
}

Vec3 normal_of(const TriangleMesh& mesh, std::uint32_t triangle) {
  const auto [a, b, c] = corners_of(mesh, mesh.triangles[triangle]);
  return mesh::area_normal(a, b, c).normalized();
}

// Either side of the molecule will do: rings need not be wound as the surface is.
double share_turned_away(const TriangleMesh& surface, const mesh::NearestPoint& to_surface,
                         const TriangleMesh& rings) {
  constexpr std::size_t samples = 5000;
  constexpr double cosine = 0.5;
  const std::vector<Vec3> places = mesh::sample_by_area(surface, samples);
  const mesh::NearestPoint to_rings(rings);
  std::size_t turned = 0;
  for (const Vec3& place : places) {
    const Vec3 own = normal_of(surface, to_surface.nearest(place).triangle);
    turned += std::abs(own.dot(normal_of(rings, to_rings.nearest(place).triangle))) < cosine;
  }
  return places.empty() ? 0.0 : static_cast<double>(turned) / static_cast<double>(places.size());
}

bool beyond(double share, double share_limit, double value, double limit) {
  return share > share_limit && value > limit;
}

}  // namespace

double expected_energy(const TriangleMesh& surface, std::size_t atoms, Boundary boundary) {
  crystal::SurfaceGuide guide(surface, 0.5 * ring_spacing);
  guide.smooth_normals(ring_spacing);
  const TriangleMesh& mesh = guide.mesh();
  double bending = 0.0, disclinations = 0.0, whole_area = 0.0, gaussian = 0.0;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const std::array<Vec3, 3> points = corners_of(mesh, mesh.triangles[t]);
    std::array<Vec3, 3> normals;
    for (std::size_t k = 0; k < 3; ++k) {
      crystal::Foot corner{points[k], {0, 0, 0}, t};
      corner.weights[k] = 1;
      normals[k] = guide.normal(corner);
    }
    const double area = 0.5 * mesh::area_normal(points[0], points[1], points[2]).norm();
    const Eigen::Matrix2d turn = shape_operator(points, normals);
    // A needle's operator is noise; nothing bends more than by a right angle over a bond.
    if (!turn.allFinite() || turn.norm() > 1.1) continue;
    const double k = turn.determinant();
    // What a sphere bends is part of what its pentagons cost.
    bending +=
        area * 0.5 * bending_rigidity * std::max(0.0, std::pow(turn.trace(), 2) - 4 * std::max(0.0, k));
    disclinations += area * density_of_disclinations(k);
    gaussian += area * std::abs(k);
    whole_area += area;
  }
  double energy = bending + std::min(disclinations, energy_of_strain(whole_area, gaussian));
  for (crystal::HalfEdgeIndex h = 0; h < guide.table().half_edges(); ++h)
    if (guide.table().twin(h) == crystal::no_half_edge)
      energy +=
          (boundary == Boundary::hydrogen ? energy_with_hydrogen : energy_of_boundary) *
          mesh.space.displacement(mesh.points[guide.table().origin(h)], mesh.points[guide.table().target(h)])
              .norm();
  return energy / static_cast<double>(atoms);
}

double Likeness::distance() const { return std::max(distance_there, distance_back); }

std::string Likeness::distance_told() const {
  return fmt::format("{} on average, {:.0f}% of the shape's radius of {:.1f} A",
                     distance_back > distance_there
                         ? fmt::format("the surface lies {:.1f} A from the molecule", distance_back)
                         : fmt::format("the atoms lie {:.1f} A from the surface", distance_there),
                     100 * distance_share, shape_radius);
}

bool Likeness::far() const {
  return beyond(distance_share, distance_share_to_refuse, distance(), distance_to_refuse);
}

bool Likeness::strained() const {
  return beyond(energy_share, energy_share_to_refuse, energy, energy_to_refuse);
}

bool Likeness::rounded() const {
  return from_sphere > roundness_share * shape_radius && distance() > roundness_to_warn * from_sphere;
}

bool Likeness::lacks_detail() const { return turned_away > turned_away_to_warn; }

std::vector<std::string> Likeness::warnings() const {
  std::vector<std::string> told;
  if (beyond(distance_share, distance_share_to_warn, distance(), distance_to_warn))
    told.push_back(distance_told() + ": the molecule follows the shape only roughly");
  else if (rounded())
    told.push_back(distance_told() +
                   fmt::format(", where a sphere would lie {:.1f} A: with so few atoms it is "
                               "rounded off, and hardly has the shape",
                               from_sphere));
  else if (lacks_detail())
    told.push_back(
        fmt::format("{:.0f}% of the surface faces another way than the molecule does there, by more than 60 "
                    "degrees: detail of the shape, such as teeth or grooves, is lost; more atoms may show it",
                    100 * turned_away));
  if (beyond(energy_share, energy_share_to_warn, energy, energy_to_warn))
    told.push_back(
        fmt::format("the molecule's energy is {:.0f} meV per atom above graphene, {:.1f} times the {:.0f} "
                    "that the shape's curvature and boundary cost: it is strained",
                    1e3 * energy, energy_share, 1e3 * expected_energy));
  return told;
}

Likeness likeness(const Molecule& molecule, const TriangleMesh& surface, double energy, Boundary boundary) {
  Likeness result;
  result.shape_radius = std::sqrt(mesh::area(surface) / (4 * std::numbers::pi));
  const mesh::NearestPoint to_surface(surface);
  result.distance_there = mesh::distances_to_surface(molecule.positions, to_surface).mean;
  const TriangleMesh rings = molecule::ring_mesh(molecule);
  if (!rings.triangles.empty()) {
    result.distance_back = mesh::distances_of_area(surface, rings).mean;
    result.turned_away = share_turned_away(surface, to_surface, rings);
  }
  result.from_sphere = distance_from_sphere(surface);
  result.distance_share = result.distance() / result.shape_radius;
  result.energy = energy;
  result.expected_energy = expected_energy(surface, molecule.size(), boundary);
  result.energy_share = energy / std::max(result.expected_energy, 1e-6);
  return result;
}

}  // namespace nanocarbon::building
