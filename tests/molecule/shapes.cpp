// SPDX-License-Identifier: GPL-2.0-or-later
#include "molecule/shapes.h"

#include <Eigen/Geometry>
#include <cmath>
#include <map>
#include <numbers>

#include "nanocarbon/molecule/bond_statistics.h"
#include "nanocarbon/molecule/dual.h"

namespace nanocarbon::test {

TriangleMesh icosahedron() {
  TriangleMesh mesh;
  const double golden = std::numbers::phi;
  for (const double s : {-1.0, 1.0})
    for (const double g : {-golden, golden}) {
      mesh.points.push_back(Vec3(s, g, 0).normalized());
      mesh.points.push_back(Vec3(0, s, g).normalized());
      mesh.points.push_back(Vec3(g, 0, s).normalized());
    }
  const double edge = 2.0 / std::sqrt(golden * golden + 1.0);
  const auto near = [&](VertexIndex a, VertexIndex b) {
    return std::abs((mesh.points[a] - mesh.points[b]).norm() - edge) < 1e-9;
  };
  for (VertexIndex a = 0; a < 12; ++a)
    for (VertexIndex b = a + 1; b < 12; ++b)
      for (VertexIndex c = b + 1; c < 12; ++c) {
        if (!near(a, b) || !near(b, c) || !near(c, a)) continue;
        Mat3 corners;
        corners << mesh.points[a], mesh.points[b], mesh.points[c];
        if (corners.col(0).cross(corners.col(1)).dot(corners.col(2)) > 0.0)
          mesh.triangles.push_back({a, b, c});
        else
          mesh.triangles.push_back({a, c, b});
      }
  return mesh;
}

TriangleMesh sqrt3_subdivided_sphere(const TriangleMesh& sphere) {
  TriangleMesh mesh{sphere.points, {}};
  std::map<std::pair<VertexIndex, VertexIndex>, VertexIndex> centre_left_of;
  for (const Triangle& t : sphere.triangles) {
    const auto centre = static_cast<VertexIndex>(mesh.points.size());
    mesh.points.push_back((sphere.points[t[0]] + sphere.points[t[1]] + sphere.points[t[2]]).normalized());
    for (int k = 0; k < 3; ++k) centre_left_of[{t[k], t[(k + 1) % 3]}] = centre;
  }
  for (const auto& [edge, left] : centre_left_of)
    mesh.triangles.push_back({edge.first, centre_left_of.at({edge.second, edge.first}), left});
  return mesh;
}

TriangleMesh torus(int around, int along, double circle, double tube) {
  TriangleMesh mesh;
  const auto index = [&](int i, int j) {
    return static_cast<VertexIndex>(((i % around) + around) % around +
                                    around * (((j % along) + along) % along));
  };
  for (int j = 0; j < along; ++j)
    for (int i = 0; i < around; ++i) {
      const double u = 2.0 * std::numbers::pi * i / around, v = 2.0 * std::numbers::pi * j / along;
      const double r = circle + tube * std::cos(u);
      mesh.points.emplace_back(r * std::cos(v), r * std::sin(v), tube * std::sin(u));
    }
  for (int j = 0; j < along; ++j)
    for (int i = 0; i < around; ++i) {
      mesh.triangles.push_back({index(i, j), index(i, j + 1), index(i + 1, j)});
      mesh.triangles.push_back({index(i + 1, j), index(i, j + 1), index(i + 1, j + 1)});
    }
  return mesh;
}

TriangleMesh cylinder(int around, int rows) {
  TriangleMesh mesh;
  const double step = 2.0 * std::numbers::pi / around;
  const double radius = 0.5 / std::sin(0.5 * step);
  const double height = std::sqrt(3.0) / 2.0;
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i < around; ++i) {
      const double angle = step * (i + 0.5 * (j % 2));
      mesh.points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), height * j);
    }
  const auto index = [&](int i, int j) {
    return static_cast<VertexIndex>((i + around) % around + around * j);
  };
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < around; ++i) {
      const int upper = i + (j % 2);  // the point of the next row to the right above i
      mesh.triangles.push_back({index(i, j), index(i + 1, j), index(upper, j + 1)});
      mesh.triangles.push_back({index(i, j), index(upper, j + 1), index(upper - 1, j + 1)});
    }
  return mesh;
}

TriangleMesh sheet(int columns, int rows) {
  TriangleMesh mesh;
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i <= columns; ++i) mesh.points.emplace_back(i + 0.5 * j, std::sqrt(3.0) / 2.0 * j, 0.0);
  const auto index = [&](int i, int j) { return static_cast<VertexIndex>(i + (columns + 1) * j); };
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      mesh.triangles.push_back({index(i, j), index(i + 1, j), index(i, j + 1)});
      mesh.triangles.push_back({index(i + 1, j), index(i + 1, j + 1), index(i, j + 1)});
    }
  return mesh;
}

TriangleMesh without_vertices(const TriangleMesh& mesh, const std::vector<VertexIndex>& vertices) {
  TriangleMesh rest{mesh.points, {}};
  for (const Triangle& t : mesh.triangles) {
    bool keep = true;
    for (const VertexIndex v : vertices) keep = keep && t[0] != v && t[1] != v && t[2] != v;
    if (keep) rest.triangles.push_back(t);
  }
  return rest;
}

TriangleMesh scaled_to_carbon(TriangleMesh mesh) {
  const double scale = 1.42 / molecule::spread(molecule::bond_lengths(molecule::dual(mesh))).mean;
  for (Vec3& p : mesh.points) p *= scale;
  return mesh;
}

}  // namespace nanocarbon::test
