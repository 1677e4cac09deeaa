// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/repair/sew_in_cell.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "nanocarbon/core/error.h"
#include "nanocarbon/mesh/edge_table.h"
#include "nanocarbon/mesh/measures.h"
#include "nanocarbon/mesh/mesh_topology.h"
#include "nanocarbon/mesh/periodic_mesh.h"
#include "nanocarbon/mesh/winding.h"
#include "nanocarbon/shapes/periodic_shapes.h"

namespace nanocarbon::mesh {
namespace {

TriangleMesh minimal(shapes::MinimalSurface::Kind kind) {
  shapes::MinimalSurface surface;
  surface.kind = kind;
  return shapes::make_minimal_surface(surface);
}

TEST(SewInCell, MakesWholeWhatWasCutOpen) {
  using Kind = shapes::MinimalSurface::Kind;
  for (const Kind kind : {Kind::schwarz_p, Kind::gyroid, Kind::schwarz_d}) {
    const TriangleMesh whole = minimal(kind);
    const SewnSurface sewn = sew_in_cell(unfolded(whole).mesh, *whole.space.cell());
    EXPECT_EQ(sewn.mesh.points.size(), whole.points.size());
    EXPECT_EQ(mesh_topology(sewn.mesh).euler_characteristic, mesh_topology(whole).euler_characteristic);
    EXPECT_TRUE(mesh_topology(sewn.mesh).closed());
    EXPECT_NEAR(area(sewn.mesh), area(whole), 1e-9);
  }
}

// A wavy sheet over the unit square; `rows` differ at the two ends if asked for.
TriangleMesh sheet(int nx, int ny, double shear_at_end = 0) {
  TriangleMesh mesh;
  for (int j = 0; j <= ny; ++j)
    for (int i = 0; i <= nx; ++i) {
      double y = static_cast<double>(j) / ny;
      const double x = static_cast<double>(i) / nx;
      if (i == nx && j > 0 && j < ny) y += shear_at_end / ny;
      mesh.points.push_back({x, y, 0.05 * std::sin(2 * M_PI * y)});
    }
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i) {
      const auto at = [&](int a, int b) { return static_cast<VertexIndex>(b * (nx + 1) + a); };
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return mesh;
}

const Cell unit_cell = orthogonal_cell({1, 1, 1}, {true, true, false});

TEST(SewInCell, JoinsCornersThatMeetFourTimes) {
  const SewnSurface sewn = sew_in_cell(sheet(12, 12), unit_cell);
  EXPECT_EQ(sewn.mesh.points.size(), 144u);
  EXPECT_TRUE(mesh_topology(sewn.mesh).closed());
  EXPECT_EQ(mesh_topology(sewn.mesh).euler_characteristic, 0);
  EXPECT_TRUE(sewn.notes.empty());
}

TEST(SewInCell, CutsSeamsWhereVerticesDoNotMeet) {
  const SewnSurface sewn = sew_in_cell(sheet(12, 12, 0.4), unit_cell);
  EXPECT_TRUE(mesh_topology(sewn.mesh).closed());
  EXPECT_EQ(mesh_topology(sewn.mesh).euler_characteristic, 0);
  EXPECT_FALSE(sewn.notes.empty());
}

// A sheet whose corners are cut into a small triangle, all four times: `small` of the edges' length.
TriangleMesh sheet_with_slivers(double small) {
  TriangleMesh mesh = sheet(12, 12);
  const auto at = [](VertexIndex i, VertexIndex j) { return j * 13 + i; };
  const double length = small / 12;
  std::map<VertexIndex, std::array<VertexIndex, 2>> beside;  // corners: new vertices along x and along y
  for (const VertexIndex i : {0u, 12u})
    for (const VertexIndex j : {0u, 12u}) {
      const Vec3 corner = mesh.points[at(i, j)];
      const Vec3 x(i == 0 ? length : -length, 0, 0), y(0, j == 0 ? length : -length, 0);
      const auto first = static_cast<VertexIndex>(mesh.points.size());
      mesh.points.push_back(corner + x);
      mesh.points.push_back(corner + y);
      beside[at(i, j)] = {first, first + 1};
    }
  std::vector<Triangle> triangles;
  for (const Triangle& t : mesh.triangles) {
    std::vector<VertexIndex> polygon;
    for (std::size_t k = 0; k < 3; ++k) {
      polygon.push_back(t[k]);
      const VertexIndex next = t[(k + 1) % 3];
      const bool along_x = mesh.points[t[k]].y() == mesh.points[next].y(),
                 along_y = mesh.points[t[k]].x() == mesh.points[next].x();
      for (const VertexIndex corner : {t[k], next})
        if (const auto found = beside.find(corner); found != beside.end() && (along_x || along_y))
          polygon.push_back(found->second[along_x ? 0 : 1]);
    }
    // A fan around a vertex that is no corner keeps the new vertices on the sides.
    std::size_t apex = 0;
    while (beside.count(polygon[apex]) > 0) ++apex;
    std::rotate(polygon.begin(), polygon.begin() + static_cast<std::ptrdiff_t>(apex), polygon.end());
    for (std::size_t k = 1; k + 1 < polygon.size(); ++k)
      triangles.push_back({polygon[0], polygon[k], polygon[k + 1]});
  }
  mesh.triangles = triangles;
  return mesh;
}

// Grids leave slivers where the surface nearly goes through a node: here at an edge of the cell, with vertices that are
// as near to images of each other as vertices that are meant to be the same may be.
TEST(SewInCell, TakesSliversAtTheEdgesOfTheCell) {
  for (const double small : {1e-3, 1e-2, 6e-2}) {
    const SewnSurface sewn = sew_in_cell(sheet_with_slivers(small), unit_cell);
    EXPECT_TRUE(mesh_topology(sewn.mesh).closed()) << small;
    EXPECT_TRUE(mesh_topology(sewn.mesh).manifold()) << small;
    EXPECT_EQ(mesh_topology(sewn.mesh).euler_characteristic, 0) << small;
  }
}

TEST(SewInCell, SplitsEdgesThatAreLongForTheCell) {
  const SewnSurface sewn = sew_in_cell(sheet(1, 1), unit_cell);
  EXPECT_TRUE(mesh_topology(sewn.mesh).closed());
  EXPECT_EQ(wrapping_ranks(sewn.mesh, mesh_topology(sewn.mesh)), std::vector<int>{2});
  EXPECT_LE(edge_lengths(sewn.mesh).max, 0.25 + 1e-12);
}

// Whatever the numbers in a file are: no memory without bound, and an answer soon.
TEST(SewInCell, RefusesEdgesThatAreFarTooLongForTheCell) {
  for (const double length : {1e3, 1e6, 1e100, 1e200}) {
    Cell cell;
    cell.vectors.diagonal() = Vec3(4, 4, 1);
    cell.periodic = {false, false, true};
    const TriangleMesh mesh{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, length, 0)}, {{0, 1, 2}}};
    try {
      sew_in_cell(mesh, cell);
      FAIL() << length;
    } catch (const UserError& error) {
      EXPECT_NE(std::string(error.what()).find("is this the right cell?"), std::string::npos) << error.what();
    }
  }
}

TEST(SewInCell, KeepsHolesAndDropsCaps) {
  TriangleMesh holed = sheet(12, 12);
  holed.triangles.erase(holed.triangles.begin() + 100, holed.triangles.begin() + 102);
  EXPECT_EQ(mesh_topology(sew_in_cell(holed, unit_cell).mesh).boundary_loops, 1u);

  // A solid between two sheets, closed by flat walls at the cell's faces.
  TriangleMesh solid;
  constexpr int n = 8;
  const auto add = [&](const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const auto first = static_cast<VertexIndex>(solid.points.size());
    for (const Vec3& p : {a, b, c, d}) solid.points.push_back(p);
    solid.triangles.push_back({first, first + 1, first + 2});
    solid.triangles.push_back({first, first + 2, first + 3});
  };
  for (int i = 0; i < n; ++i) {
    const double at = static_cast<double>(i) / n, next = static_cast<double>(i + 1) / n;
    for (const double x : {0.0, 1.0}) add({x, at, 0.2}, {x, next, 0.2}, {x, next, 0.4}, {x, at, 0.4});
    for (const double y : {0.0, 1.0}) add({at, y, 0.2}, {next, y, 0.2}, {next, y, 0.4}, {at, y, 0.4});
    for (int j = 0; j < n; ++j) {
      const double v = static_cast<double>(j) / n, w = static_cast<double>(j + 1) / n;
      add({at, v, 0.4}, {next, v, 0.4}, {next, w, 0.4}, {at, w, 0.4});
      add({at, v, 0.2}, {at, w, 0.2}, {next, w, 0.2}, {next, v, 0.2});
    }
  }
  // Joined by hand: only the two sheets' own vertices, each once.
  TriangleMesh joined;
  for (const Vec3& p : solid.points) {
    const auto same = std::find_if(joined.points.begin(), joined.points.end(),
                                   [&](const Vec3& q) { return (p - q).norm() < 1e-9; });
    if (same == joined.points.end()) joined.points.push_back(p);
  }
  const auto index = [&](VertexIndex v) {
    const auto same = std::find_if(joined.points.begin(), joined.points.end(),
                                   [&](const Vec3& q) { return (solid.points[v] - q).norm() < 1e-9; });
    return static_cast<VertexIndex>(same - joined.points.begin());
  };
  for (const Triangle& t : solid.triangles)
    joined.triangles.push_back({index(t[0]), index(t[1]), index(t[2])});
  const SewnSurface sewn = sew_in_cell(joined, unit_cell);
  const MeshTopology t = mesh_topology(sewn.mesh);
  EXPECT_EQ(t.components, 2u);
  EXPECT_TRUE(t.closed());
  EXPECT_EQ(t.euler_characteristic, 0);
}

// Nobody's boundaries meet exactly: scans and simulations move each vertex by itself.
TEST(SewInCell, TakesNoiseAtTheFacesOfTheCell) {
  for (const double noise : {0.02, 0.05, 0.1})
    for (const unsigned seed : {1u, 2u, 3u}) {
      TriangleMesh mesh = sheet(12, 12);
      std::mt19937 random(seed);
      std::normal_distribution<double> by(0, noise / 12);
      for (Vec3& p : mesh.points) p += Vec3(by(random), by(random), by(random));
      const SewnSurface sewn = sew_in_cell(mesh, unit_cell);
      EXPECT_TRUE(mesh_topology(sewn.mesh).closed()) << noise;
      EXPECT_TRUE(mesh_topology(sewn.mesh).manifold()) << noise;
      EXPECT_EQ(mesh_topology(sewn.mesh).euler_characteristic, 0) << noise;
    }
}

// Noise turns slivers over and puts their vertices in any order.
TEST(SewInCell, TakesNoiseAtSlivers) {
  for (const double small : {1e-3, 1e-2, 6e-2, 0.2})
    for (const unsigned seed : {1u, 2u, 3u, 4u, 5u}) {
      TriangleMesh mesh = sheet_with_slivers(small);
      std::mt19937 random(seed);
      std::normal_distribution<double> by(0, 0.05 / 12);
      for (Vec3& p : mesh.points) p += Vec3(by(random), by(random), by(random));
      const SewnSurface sewn = sew_in_cell(mesh, unit_cell);
      EXPECT_TRUE(mesh_topology(sewn.mesh).closed()) << small << " " << seed;
      EXPECT_TRUE(mesh_topology(sewn.mesh).manifold()) << small << " " << seed;
      EXPECT_EQ(mesh_topology(sewn.mesh).euler_characteristic, 0) << small << " " << seed;
    }
}

// The triangles that polygonising a function on a grid over the unit cube gives, each cube as six tetrahedra. Vertices at
// nodes of the grid are as many as there are edges there, and what is between them has no area.
template <typename Function>
TriangleMesh polygonised(const Function& f, int n) {
  TriangleMesh mesh;
  std::map<std::pair<std::array<int, 3>, std::array<int, 3>>, VertexIndex> known;
  using Node = std::array<int, 3>;
  const auto at = [&](const Node& k) -> Vec3 { return Vec3(k[0], k[1], k[2]) / n; };
  const auto value = [&](const Node& k) { return f(at(k)); };
  const auto vertex = [&](Node a, Node b) {
    if (b < a) std::swap(a, b);
    const auto [entry, added] = known.try_emplace({a, b}, static_cast<VertexIndex>(mesh.points.size()));
    if (added) mesh.points.push_back(at(a) + value(a) / (value(a) - value(b)) * (at(b) - at(a)));
    return entry->second;
  };
  for (int cube = 0; cube < n * n * n; ++cube) {
    std::array<std::size_t, 3> order = {0, 1, 2};
    do {
      Node node = {cube % n, cube / n % n, cube / n / n};
      std::vector<Node> in, out;
      for (std::size_t k = 0; k < 4; ++k) {
        (value(node) < 0 ? in : out).push_back(node);
        if (k < 3) ++node[order[k]];
      }
      if (in.empty() || out.empty()) continue;
      std::vector<Triangle> triangles;
      if (in.size() == 2) {
        const VertexIndex a = vertex(in[0], out[0]), b = vertex(in[0], out[1]), c = vertex(in[1], out[1]),
                          d = vertex(in[1], out[0]);
        triangles = {{a, b, c}, {a, c, d}};
      } else {
        const bool one_in = in.size() == 1;
        const Node apex = one_in ? in[0] : out[0];
        const std::vector<Node>& base = one_in ? out : in;
        triangles = {{vertex(apex, base[0]), vertex(apex, base[1]), vertex(apex, base[2])}};
      }
      for (Triangle t : triangles) {
        const Vec3 normal =
            (mesh.points[t[1]] - mesh.points[t[0]]).cross(mesh.points[t[2]] - mesh.points[t[0]]);
        if (normal.dot(at(out[0]) - at(in[0])) < 0) std::swap(t[1], t[2]);
        mesh.triangles.push_back(t);
      }
    } while (std::next_permutation(order.begin(), order.end()));
  }
  const EdgeTable edges = edge_table(soup_of(mesh));  // some triangles have no normal
  wind_alike(mesh, mesh_topology(soup_of(mesh), edges), edges);
  return mesh;
}

// At some phases the gyroid goes through corners of its cell, where the grid has a node.
TEST(SewInCell, TakesANoisyGyroidAtAnyPhase) {
  const Cell cell = orthogonal_cell({1, 1, 1}, {true, true, true});
  for (const double phase : {0.013, 0.1, 0.25})
    for (const unsigned seed : {1u, 2u, 3u}) {
      TriangleMesh mesh = polygonised(
          [&](const Vec3& p) {
            const Vec3 q = 2 * M_PI * (p + Vec3::Constant(phase));
            return std::sin(q.x()) * std::cos(q.y()) + std::sin(q.y()) * std::cos(q.z()) +
                   std::sin(q.z()) * std::cos(q.x());
          },
          12);
      std::mt19937 random(seed);
      std::normal_distribution<double> by(0, 0.05 * edge_lengths(mesh).mean);
      for (Vec3& p : mesh.points) p += Vec3(by(random), by(random), by(random));
      const MeshTopology topology = mesh_topology(sew_in_cell(mesh, cell).mesh);
      EXPECT_TRUE(topology.closed()) << phase << " " << seed;
      EXPECT_EQ(topology.euler_characteristic, -8) << phase << " " << seed;
      EXPECT_EQ(topology.components, 1u) << phase << " " << seed;
    }
}

// Within rounding of a node in a face of the cell there are slivers, cut differently at the two sides.
TEST(SewInCell, TakesASurfaceThatAllButTouchesANodeInAFace) {
  const Cell cell = orthogonal_cell({1, 1, 1}, {true, true, true});
  const auto gyroid = [](const Vec3& p) {
    const Vec3 q = 2 * M_PI * (p + Vec3(0.031, 0.047, 0.083));
    return std::sin(q.x()) * std::cos(q.y()) + std::sin(q.y()) * std::cos(q.z()) +
           std::sin(q.z()) * std::cos(q.x());
  };
  for (const double off : {1e-9, 1e-6, 1e-5, 1e-4})
    for (const double side : {-1.0, 1.0}) {
      const double level = gyroid({11 / 12.0, 8 / 12.0, 0}) + side * off;
      const TriangleMesh mesh = polygonised([&](const Vec3& p) { return gyroid(p) - level; }, 12);
      const MeshTopology topology = mesh_topology(sew_in_cell(mesh, cell).mesh);
      EXPECT_TRUE(topology.closed()) << off << " " << side;
      EXPECT_EQ(topology.euler_characteristic, -8) << off << " " << side;
    }
}

// Cuts away what lies where a function is negative.
template <typename Function>
TriangleMesh without(const TriangleMesh& mesh, const Function& f) {
  TriangleMesh left{mesh.points, {}};
  std::map<std::pair<VertexIndex, VertexIndex>, VertexIndex> known;
  const auto negative = [&](VertexIndex v) { return f(mesh.points[v]) < -1e-9; };
  for (const Triangle& t : mesh.triangles) {
    std::vector<VertexIndex> polygon;
    for (std::size_t k = 0; k < 3; ++k) {
      const VertexIndex a = t[k], b = t[(k + 1) % 3], low = std::min(a, b), high = std::max(a, b);
      if (!negative(a)) polygon.push_back(a);
      const double at_low = f(mesh.points[low]), at_high = f(mesh.points[high]);
      if (negative(a) == negative(b) || std::max(at_low, at_high) < 1e-9) continue;
      const auto [cut, added] = known.try_emplace({low, high}, static_cast<VertexIndex>(left.points.size()));
      if (added)
        left.points.push_back(mesh.points[low] +
                              at_low / (at_low - at_high) * (mesh.points[high] - mesh.points[low]));
      polygon.push_back(cut->second);
    }
    for (std::size_t k = 2; k < polygon.size(); ++k)
      left.triangles.push_back({polygon[0], polygon[k - 1], polygon[k]});
  }
  return left;
}

// Holes may lie across faces and edges of the cell: a sheet with bevelled corners has one.
TEST(SewInCell, KeepsHolesThatReachTheFacesOfTheCell) {
  const auto beside = [](double x) { return x - std::round(x); };
  for (const double size : {0.03, 0.05, 0.1, 0.15, 0.2, 0.3}) {
    const TriangleMesh bevelled = without(sheet(12, 12), [&](const Vec3& p) {
      return std::abs(beside(p.x())) + std::abs(beside(p.y())) - size;
    });
    const MeshTopology topology = mesh_topology(sew_in_cell(bevelled, unit_cell).mesh);
    EXPECT_EQ(topology.boundary_loops, 1u) << size;
    EXPECT_EQ(topology.euler_characteristic, -1) << size;
  }
  for (const double at : {0.0, 0.05, 0.1, 0.24, 0.5}) {
    const TriangleMesh holed = without(sheet(12, 12), [&](const Vec3& p) {
      return std::hypot(beside(p.x() - at), beside(p.y() - 0.55)) - 0.22;
    });
    const MeshTopology topology = mesh_topology(sew_in_cell(holed, unit_cell).mesh);
    EXPECT_EQ(topology.boundary_loops, 1u) << at;
    EXPECT_EQ(topology.euler_characteristic, -1) << at;
  }
}

// But a part of a face's line without its counterpart is a part that is missing.
TEST(SewInCell, RefusesASheetWithOneCornerCutAway) {
  for (const double size : {0.15, 0.2, 0.3}) {
    const TriangleMesh torn = without(sheet(12, 12), [&](const Vec3& p) { return p.x() + p.y() - size; });
    EXPECT_THROW(sew_in_cell(torn, unit_cell), UserError) << size;
  }
}

// Triangles between two rows of points, each in order.
void fill(TriangleMesh& mesh, const std::vector<VertexIndex>& low, const std::vector<VertexIndex>& high) {
  for (std::size_t i = 0, j = 0; i + 1 < low.size() || j + 1 < high.size();) {
    const bool on_low = j + 1 == high.size() ||
                        (i + 1 < low.size() && (i + 1) * (high.size() - 1) <= (j + 1) * (low.size() - 1));
    if (on_low)
      mesh.triangles.push_back({low[i], low[i + 1], high[j]});
    else
      mesh.triangles.push_back({low[i], high[j + 1], high[j]});
    on_low ? ++i : ++j;
  }
}

// A tube of unit length with so many vertices around it at its ends, some way round each, and uneven.
TriangleMesh tube(int at_bottom, int at_top, double turned, double noise) {
  TriangleMesh mesh;
  std::mt19937 random(5);
  std::normal_distribution<double> by(0, noise);
  std::vector<VertexIndex> below;
  for (int ring = 0; ring <= 6; ++ring) {
    const int n = ring < 3 ? at_bottom : at_top;
    std::vector<VertexIndex> row;
    for (int k = 0; k < n; ++k) {
      const double angle = 2 * M_PI * (k + (ring == 6 ? turned : 0) + 0.3 * std::sin(k)) / n;
      row.push_back(static_cast<VertexIndex>(mesh.points.size()));
      mesh.points.push_back(0.4 * Vec3(std::cos(angle), std::sin(angle) * (1 + 0.3 * std::cos(angle)), 0) +
                            Vec3(by(random), by(random), ring / 6.0 + by(random)));
    }
    row.push_back(row.front());
    if (ring > 0) fill(mesh, below, row);
    below = row;
  }
  return mesh;
}

TEST(SewInCell, MeetsBoundariesWithOtherVertices) {
  const Cell cell = orthogonal_cell({4, 4, 1}, {false, false, true});
  for (const int at_top : {16, 17, 29, 64})
    for (const double turned : {0.0, 0.3, 0.5})
      for (const double noise : {0.0, 0.01}) {
        const std::string which =
            std::to_string(at_top) + " " + std::to_string(turned) + " " + std::to_string(noise);
        const SewnSurface sewn = sew_in_cell(tube(16, at_top, turned, noise), cell);
        EXPECT_TRUE(mesh_topology(sewn.mesh).closed()) << which;
        EXPECT_TRUE(mesh_topology(sewn.mesh).manifold()) << which;
        EXPECT_EQ(mesh_topology(sewn.mesh).euler_characteristic, 0) << which;
        EXPECT_EQ(wrapping_ranks(sewn.mesh, mesh_topology(sewn.mesh)), std::vector<int>{1}) << which;
      }
}

TEST(SewInCell, SaysWhereABoundaryHasNoPartner) {
  TriangleMesh torn = sheet(12, 12);
  for (Vec3& p : torn.points)
    if (p.x() > 0.99) p.z() += 0.5;
  try {
    sew_in_cell(torn, unit_cell);
    FAIL();
  } catch (const UserError& error) {
    EXPECT_EQ(error.failure(), Failure::unsuitable);
    EXPECT_NE(std::string(error.what()).find("boundary vertices"), std::string::npos) << error.what();
  }
}

// Of a cell that is sheared where the mesh is not, whatever sewing fails by.
TEST(SewInCell, AsksWhetherACellWithOtherAnglesIsRight) {
  for (const double shear : {0.05, 0.1, 0.2})
    for (const int along : {0, 1}) {
      Cell cell = unit_cell;
      cell.vectors(along, 1 - along) = shear;
      try {
        sew_in_cell(sheet(12, 12), cell);
        ADD_FAILURE() << shear << " " << along;
      } catch (const UserError& error) {
        EXPECT_NE(std::string(error.what()).find("is the cell right"), std::string::npos) << error.what();
      }
    }
}

// A vertex far away makes all other edges short, and what is sound looks like specks.
TEST(SewInCell, NothingSoundIsDroppedAsSpecks) {
  TriangleMesh cut = unfolded(minimal(shapes::MinimalSurface::Kind::schwarz_p)).mesh;
  const Cell cell = *minimal(shapes::MinimalSurface::Kind::schwarz_p).space.cell();
  cut.points[cut.triangles[0][0]].y() += 65536 * cell.vectors(1, 1);
  EXPECT_THROW(sew_in_cell(cut, cell), UserError);
  const TriangleMesh box{
      .points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 65536, 1}},
      .triangles = {{0, 2, 3},
                    {0, 3, 1},
                    {4, 5, 7},
                    {4, 7, 6},
                    {0, 1, 5},
                    {0, 5, 4},
                    {2, 6, 7},
                    {2, 7, 3},
                    {0, 4, 6},
                    {0, 6, 2},
                    {1, 3, 7},
                    {1, 7, 5}}};
  Cell long_cell = cell;
  long_cell.vectors = Vec3(1, 3, 3).asDiagonal();
  EXPECT_THROW(sew_in_cell(box, long_cell), UserError);
}

// Edges across a seam are twenty times those along it: what is torn open by less than a mean edge is no corner of a hole.
TEST(SewInCell, ATearInAFineSeamIsNoHole) {
  TriangleMesh torn = sheet(5, 100);
  Cell cell;
  cell.vectors = Mat3::Identity();
  cell.periodic = {true, true, false};
  EXPECT_NO_THROW(sew_in_cell(torn, cell));
  int raised = 0;
  for (Vec3& p : torn.points)
    if (p.x() == 1 && p.y() > 0.4 && raised < 3) {
      p.z() += 0.045;
      ++raised;
    }
  EXPECT_THROW(sew_in_cell(torn, cell), UserError);
}

}  // namespace
}  // namespace nanocarbon::mesh
