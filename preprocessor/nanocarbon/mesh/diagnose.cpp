// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/diagnose.h"

#include <fmt/format.h>

#include <algorithm>

#include "nanocarbon/mesh/describe.h"
#include "nanocarbon/mesh/drop_faces.h"
#include "nanocarbon/mesh/edge_table.h"
#include "nanocarbon/mesh/join_points.h"
#include "nanocarbon/mesh/periodic_mesh.h"
#include "nanocarbon/mesh/same_faces.h"
#include "nanocarbon/mesh/self_intersections.h"
#include "nanocarbon/mesh/triangulate.h"

namespace nanocarbon::mesh {
namespace {

constexpr std::size_t most_places = 10;

class Findings {
 public:
  Findings(const PolygonSoup& soup, MeshDiagnosis& diagnosis) : soup_(soup), diagnosis_(diagnosis) {}

  //! Counts one more case of a problem; places at the same problem must follow each other.
  void add(MeshProblem problem, std::vector<VertexIndex> vertices, std::vector<FaceIndex> faces) {
    if (diagnosis_.findings.empty() || diagnosis_.findings.back().problem != problem)
      diagnosis_.findings.push_back({problem, 0, {}, {}});
    MeshFinding& finding = diagnosis_.findings.back();
    if (++finding.count > most_places) return;
    Vec3 point = Vec3::Zero();
    for (const VertexIndex v : vertices) point += soup_.points[v] / static_cast<double>(vertices.size());
    finding.places.push_back({std::move(vertices), std::move(faces), point});
  }

 private:
  const PolygonSoup& soup_;
  MeshDiagnosis& diagnosis_;
};

std::vector<FaceIndex> faces_at(const EdgeTable& edges, std::size_t edge) {
  std::vector<FaceIndex> faces;
  for (const EdgeUse& use : edges.uses_of(edge)) faces.push_back(use.face);
  return faces;
}

std::vector<VertexIndex> vertices_of(std::span<const VertexIndex> face) {
  return {face.begin(),
          face.begin() + static_cast<std::ptrdiff_t>(std::min<std::size_t>(face.size(), most_places))};
}

void find_in_faces(const PolygonSoup& soup, Findings& findings) {
  const auto for_each = [&](MeshProblem problem, const auto& is_so) {
    for (FaceIndex face = 0; face < soup.faces(); ++face)
      if (is_so(soup.face(face))) findings.add(problem, vertices_of(soup.face(face)), {face});
  };
  for_each(MeshProblem::too_many_corners, [](auto face) { return face.size() > most_corners; });
  for_each(MeshProblem::repeated_vertex, [](auto face) { return repeats_a_vertex(face); });
  for_each(MeshProblem::no_area,
           [&](auto face) { return !repeats_a_vertex(face) && has_no_area(soup.points, face); });
  for (const SameFace& same : same_faces(soup))
    findings.add(MeshProblem::duplicate_face, vertices_of(soup.face(same.face)), {same.earlier, same.face});
}

void find_in_topology(const PolygonSoup& soup, const EdgeTable& edges, const MeshTopology& topology,
                      Findings& findings) {
  for (const std::size_t e : topology.non_manifold_edges)
    findings.add(MeshProblem::non_manifold_edge, {edges.low[e], edges.high[e]}, faces_at(edges, e));
  for (const VertexIndex v : topology.non_manifold_vertices)
    findings.add(MeshProblem::non_manifold_vertex, {v}, {});
  for (const MeshComponent& component : topology.component)
    if (!component.orientable)
      findings.add(MeshProblem::not_orientable, vertices_of(soup.face(component.first_face)),
                   {component.first_face});
  for (const std::size_t e : topology.twisted_edges)
    if (topology.component[topology.component_of_face[edges.uses_of(e)[0].face]].orientable)
      findings.add(MeshProblem::inconsistent_winding, {edges.low[e], edges.high[e]}, faces_at(edges, e));
}

constexpr MeshProblem kinds_of_intersection[] = {
    MeshProblem::components_intersect, MeshProblem::images_intersect, MeshProblem::self_intersection};

// Which kind the intersection of two faces is.
MeshProblem problem_of(std::uint32_t first, std::uint32_t second, const MeshTopology& topology) {
  return topology.component_of_face[first] == topology.component_of_face[second]
             ? MeshProblem::self_intersection
             : MeshProblem::components_intersect;
}

void find_intersections(const PolygonSoup& soup, const CoincidentPoints& coincident,
                        const MeshTopology& topology, Findings& findings) {
  TriangleMesh mesh;
  mesh.points = soup.points;
  mesh.triangles.reserve(soup.faces());
  for (std::size_t face = 0; face < soup.faces(); ++face)
    mesh.triangles.push_back({soup.face(face)[0], soup.face(face)[1], soup.face(face)[2]});
  const SelfIntersections found = crossings(mesh, coincident.representative);
  for (const MeshProblem problem : kinds_of_intersection)
    for (const auto& [first, second] : found.pairs)
      if (problem_of(first, second, topology) == problem)
        findings.add(problem, vertices_of(soup.face(first)), {first, second});
  if (!found.complete) findings.add(MeshProblem::search_given_up, {}, {});
}

void find_in_points(const PolygonSoup& soup, const CoincidentPoints& coincident, Findings& findings) {
  std::vector<bool> used(soup.points.size(), false);
  for (const VertexIndex corner : soup.corners) used[corner] = true;
  for (VertexIndex v = 0; v < soup.points.size(); ++v)
    if (!used[v]) findings.add(MeshProblem::unused_vertex, {v}, {});
  for (VertexIndex v = 0; v < soup.points.size(); ++v)
    if (coincident.representative[v] != v)
      findings.add(MeshProblem::duplicate_vertex, {coincident.representative[v], v}, {});
}

// Fills in the findings; the other members are known.
void find_problems(const PolygonSoup& soup, const EdgeTable& edges, MeshDiagnosis& diagnosis) {
  Findings findings(soup, diagnosis);
  if (soup.faces() == 0) findings.add(MeshProblem::no_faces, {}, {});
  find_in_faces(soup, findings);
  find_in_topology(soup, edges, diagnosis.topology, findings);
  if (diagnosis.volume && *diagnosis.volume < 0.0) findings.add(MeshProblem::inside_out, {}, {});
  // Polygons have no one surface to intersect with until they are cut into triangles.
  const CoincidentPoints coincident = coincident_points(soup.points);
  if (diagnosis.most_corners_of_a_face == 3)
    find_intersections(soup, coincident, diagnosis.topology, findings);
  find_in_points(soup, coincident, findings);
  for (MeshFinding& finding : diagnosis.findings) finding.text = describe(finding);
}

}  // namespace

MeshDiagnosis diagnose(const PolygonSoup& soup) {
  MeshDiagnosis diagnosis;
  const EdgeTable edges = edge_table(soup);
  diagnosis.points = soup.points.size();
  diagnosis.faces = soup.faces();
  diagnosis.topology = mesh_topology(soup, edges);
  diagnosis.box = bounding_box(soup.points);
  diagnosis.edges = edge_lengths(soup.points, edges);
  for (std::size_t face = 0; face < soup.faces(); ++face) {
    diagnosis.most_corners_of_a_face = std::max(diagnosis.most_corners_of_a_face, soup.face(face).size());
    diagnosis.area += 0.5 * newell_normal(soup.points, soup.face(face)).norm();
  }
  if (diagnosis.topology.closed() && diagnosis.topology.manifold() && diagnosis.topology.consistently_wound())
    diagnosis.volume = signed_volume(soup);
  find_problems(soup, edges, diagnosis);
  return diagnosis;
}

void find_intersections_in_cell(const TriangleMesh& mesh, MeshDiagnosis& diagnosis) {
  SelfIntersections found = self_intersections(mesh);
  add_crossings_in_edges(mesh, first_at_place(mesh), found);
  if (!found.complete) diagnosis.findings.push_back({MeshProblem::search_given_up, 1, {}, {}});
  if (found.pairs.empty()) return;
  const MeshTopology topology = mesh_topology(mesh);
  const Wrapping unrolled = wrapping(mesh, topology);
  // Of one piece that goes on through the cell, what its own translations lead to is no other image.
  const auto problem_at = [&](std::size_t pair) {
    const auto [first, second] = found.pairs[pair];
    const MeshProblem problem = problem_of(first, second, topology);
    if (problem != MeshProblem::self_intersection) return problem;
    const auto& one = unrolled.image[mesh.triangles[first][0]];
    const auto& other = unrolled.image[mesh.triangles[second][0]];
    std::array<std::int32_t, 3> across = mesh.space.multiples(found.moved[pair]);
    for (std::size_t d = 0; d < 3; ++d) across[d] += other[d] - one[d];
    const bool own = unrolled.translations[topology.component_of_face[first]].contains(across);
    return own ? problem : MeshProblem::images_intersect;
  };
  std::vector<MeshProblem> problems;
  for (std::size_t pair = 0; pair < found.pairs.size(); ++pair) problems.push_back(problem_at(pair));
  for (const MeshProblem problem : kinds_of_intersection) {
    MeshFinding finding{problem, 0, {}, {}};
    for (std::size_t pair = 0; pair < problems.size(); ++pair) {
      if (problems[pair] != problem || ++finding.count > most_places) continue;
      const auto [a, b, c] = corners_of(mesh, mesh.triangles[found.pairs[pair][0]]);
      finding.places.push_back({{}, {}, mesh.space.wrapped((a + b + c) / 3.0)});
    }
    if (finding.count > 0) diagnosis.findings.push_back(std::move(finding));
  }
  for (MeshFinding& finding : diagnosis.findings)
    if (finding.text.empty()) finding.text = describe(finding);
}

}  // namespace nanocarbon::mesh
