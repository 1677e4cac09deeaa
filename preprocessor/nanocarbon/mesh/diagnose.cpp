// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/diagnose.h"

#include <algorithm>

#include "nanocarbon/mesh/edge_table.h"
#include "nanocarbon/mesh/find_problems.h"

namespace nanocarbon::mesh {

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

}  // namespace nanocarbon::mesh
