// SPDX-License-Identifier: GPL-2.0-or-later
// Every real mesh against what its index says it is; the index was made with other programs.
#include <gmock/gmock.h>

#include <fstream>
#include <map>
#include <sstream>

#include "nanocarbon/core/error.h"
#include "nanocarbon/mesh/diagnose.h"
#include "nanocarbon/mesh/formats/load_surface.h"
#include "nanocarbon/mesh/formats/read_mesh.h"
#include "support/models.h"

namespace nanocarbon::mesh {
namespace {

using Row = std::map<std::string, std::string>;

std::vector<Row> read_index() {
  std::ifstream stream(test::models_folder() / "INDEX.tsv");
  std::vector<std::string> columns;
  std::vector<Row> rows;
  for (std::string line; std::getline(stream, line);) {
    std::istringstream cells(line);
    std::vector<std::string> row;
    for (std::string cell; std::getline(cells, cell, '\t');) row.push_back(cell);
    if (columns.empty()) {
      columns = row;
      continue;
    }
    rows.emplace_back();
    for (std::size_t i = 0; i < columns.size() && i < row.size(); ++i) rows.back()[columns[i]] = row[i];
  }
  return rows;
}

std::size_t count(const MeshDiagnosis& diagnosis, MeshProblem problem) {
  const MeshFinding* finding = diagnosis.find(problem);
  return finding ? finding->count : 0;
}

std::string refusal(const std::filesystem::path& path) {
  try {
    load_surface(path);
  } catch (const UserError& error) {
    return error.what();
  }
  return {};
}

TEST(Models, GoodMeshesAreWhatTheIndexSays) {
  NANOCARBON_NEEDS_MODELS();
  std::size_t meshes = 0;
  for (const Row& row : read_index()) {
    if (row.at("class") == "bad") continue;
    SCOPED_TRACE(row.at("file"));
    ++meshes;
    const LoadedSurface surface = load_surface(test::models_folder() / row.at("file"));
    const MeshTopology& topology = surface.diagnosis.topology;
    EXPECT_EQ(std::to_string(topology.vertices), row.at("V"));
    EXPECT_EQ(std::to_string(topology.faces), row.at("F"));
    EXPECT_EQ(std::to_string(topology.components), row.at("components"));
    EXPECT_EQ(std::to_string(topology.boundary_loops), row.at("boundary_loops"));
    EXPECT_EQ(std::to_string(topology.euler_characteristic), row.at("euler"));
    EXPECT_EQ(std::to_string(topology.genus), row.at("genus"));
    EXPECT_EQ(topology.orientable ? "yes" : "no", row.at("orientable"));
    EXPECT_EQ(topology.closed() ? "closed" : "open", row.at("class"));
    EXPECT_EQ(std::to_string(count(surface.diagnosis, MeshProblem::duplicate_vertex)),
              row.at("duplicate_vertices"));
    EXPECT_EQ(std::to_string(count(surface.diagnosis, MeshProblem::self_intersection)),
              row.at("self_intersecting_pairs"));
    const EdgeLengths& edges = surface.diagnosis.edges;
    // The index averages over the sides of faces, so that boundary edges weigh half: a little else in open
    // meshes.
    EXPECT_NEAR(edges.mean, std::stod(row.at("edge_mean")), (topology.closed() ? 5e-4 : 3e-3) * edges.mean);
    EXPECT_NEAR(edges.coefficient_of_variation(), std::stod(row.at("edge_cv")), 0.0051);
    EXPECT_NEAR(edges.min / edges.mean, std::stod(row.at("edge_min/mean")), 0.0051 * edges.min / edges.mean);
    EXPECT_NEAR(edges.max / edges.mean, std::stod(row.at("edge_max/mean")), 0.006 * edges.max / edges.mean);
    if (topology.closed()) {
      EXPECT_GT(surface.diagnosis.volume.value(), 0.0);
    }
    const bool inside_out = row.at("note").find("inside-out") != std::string::npos;
    if (inside_out)
      EXPECT_THAT(surface.repairs, testing::ElementsAre(testing::HasSubstr("inside-out")));
    else
      EXPECT_THAT(surface.repairs, testing::IsEmpty());
  }
  EXPECT_GT(meshes, 20u);
}

TEST(Models, DiagnosisAsReadIsWhatTheIndexSaysAlsoOfBadMeshes) {
  NANOCARBON_NEEDS_MODELS();
  for (const Row& row : read_index()) {
    if (row.at("F") == "0") continue;  // cut off: cannot be read
    SCOPED_TRACE(row.at("file"));
    const MeshDiagnosis diagnosis = diagnose(read_mesh(test::models_folder() / row.at("file")));
    const MeshTopology& topology = diagnosis.topology;
    EXPECT_EQ(std::to_string(diagnosis.points), row.at("V"));
    EXPECT_EQ(std::to_string(diagnosis.faces), row.at("F"));
    EXPECT_EQ(std::to_string(topology.components), row.at("components"));
    EXPECT_EQ(std::to_string(topology.boundary_loops), row.at("boundary_loops"));
    EXPECT_EQ(std::to_string(topology.euler_characteristic), row.at("euler"));
    EXPECT_EQ(topology.non_manifold_edges.empty(), row.at("manifold_edge/vertex").starts_with("yes/"));
    EXPECT_EQ(topology.non_manifold_vertices.empty(), row.at("manifold_edge/vertex").ends_with("/yes"));
    if (topology.manifold()) {
      EXPECT_EQ(topology.orientable ? "yes" : "no", row.at("orientable"));
    }
    EXPECT_EQ(std::to_string(count(diagnosis, MeshProblem::no_area)), row.at("degenerate"));
    EXPECT_EQ(std::to_string(count(diagnosis, MeshProblem::unused_vertex)), row.at("isolated"));
  }
}

TEST(Models, BadMeshesAreRefusedWithTheReasonTheIndexGives) {
  NANOCARBON_NEEDS_MODELS();
  const auto models = test::models_folder();
  using testing::HasSubstr;
  EXPECT_THAT(refusal(models / "bad-moebius.off"), HasSubstr("not orientable"));
  EXPECT_THAT(refusal(models / "bad-two-spheres.obj"),
              HasSubstr("147 pairs of faces of different pieces intersect"));
  EXPECT_THAT(refusal(models / "bad-truncated.off"), HasSubstr("bad-truncated.off:6: "));
}

// Two cubes that share an edge, and two icosahedra that share a vertex.
TEST(Models, SolidsThatTouchAreTakenApart) {
  NANOCARBON_NEEDS_MODELS();
  for (const char* file : {"bad-shared-edge.stl", "bad-hourglass-vertex.obj"}) {
    SCOPED_TRACE(file);
    const LoadedSurface surface = load_surface(test::models_folder() / file);
    EXPECT_EQ(surface.diagnosis.topology.components, 2u);
    EXPECT_EQ(surface.diagnosis.topology.euler_characteristic, 4);
    EXPECT_TRUE(surface.diagnosis.topology.closed());
    EXPECT_THAT(surface.repairs, testing::Contains(testing::HasSubstr("separated sheets")));
  }
}

TEST(Models, FacesWithoutAreaAreRepairedWithoutChangingTheShape) {
  NANOCARBON_NEEDS_MODELS();
  const auto path = test::models_folder() / "bad-degenerate-triangles.off";
  const MeshDiagnosis before = diagnose(read_mesh(path));
  EXPECT_EQ(count(before, MeshProblem::no_area), 4u);
  const LoadedSurface surface = load_surface(path);
  EXPECT_THAT(surface.repairs, testing::Contains(testing::HasSubstr("without area")));
  EXPECT_DOUBLE_EQ(surface.diagnosis.area, before.area);
  EXPECT_EQ(surface.diagnosis.topology.euler_characteristic, before.topology.euler_characteristic);
  EXPECT_EQ(surface.diagnosis.topology.faces, 8u);
  EXPECT_TRUE(surface.diagnosis.findings.empty());
}

}  // namespace
}  // namespace nanocarbon::mesh
