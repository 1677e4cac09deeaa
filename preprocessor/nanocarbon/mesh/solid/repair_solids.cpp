// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/solid/repair_solids.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <unordered_set>
#include <utility>

#include "nanocarbon/core/disjoint_sets.h"
#include "nanocarbon/mesh/join_points.h"
#include "nanocarbon/mesh/repair/repair_surface.h"
#include "nanocarbon/mesh/solid/mesh_parts.h"

namespace nanocarbon::mesh {
namespace {

constexpr std::size_t most_pieces = 1000;

// The faces that hang together by their vertices as numbered, piece by piece; none where that is one piece, or where
// there are more than solids can be.
std::vector<std::vector<FaceIndex>> pieces_of(const PolygonSoup& soup) {
  DisjointSets sets(soup.points.size());
  for (FaceIndex face = 0; face < soup.faces(); ++face)
    for (const VertexIndex v : soup.face(face)) sets.join(soup.face(face)[0], v);
  std::map<std::uint32_t, std::size_t> piece_of;
  std::vector<std::vector<FaceIndex>> pieces;
  for (FaceIndex face = 0; face < soup.faces(); ++face) {
    if (soup.face(face).empty()) continue;
    const auto [found, is_new] = piece_of.try_emplace(sets.find(soup.face(face)[0]), pieces.size());
    if (is_new) pieces.emplace_back();
    pieces[found->second].push_back(face);
    if (pieces.size() > most_pieces) return {};
  }
  if (pieces.size() < 2) pieces.clear();
  return pieces;
}

// The same where the format knows no shared vertices but lists one solid after the other: a piece ends where all edges
// have been met an even number of times, so that it is closed.
std::vector<std::vector<FaceIndex>> closed_runs(const PolygonSoup& soup) {
  const std::vector<VertexIndex> place = coincident_points(soup.points).representative;
  std::unordered_set<std::uint64_t> open;  // edges
  std::vector<std::vector<FaceIndex>> pieces;
  for (FaceIndex face = 0; face < soup.faces(); ++face) {
    if (open.empty()) pieces.emplace_back();
    if (pieces.size() > most_pieces) return {};
    pieces.back().push_back(face);
    const auto corners = soup.face(face);
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const auto [low, high] = std::minmax({place[corners[k]], place[corners[(k + 1) % corners.size()]]});
      const std::uint64_t edge = std::uint64_t{low} << 32 | high;
      if (low != high && !open.insert(edge).second) open.erase(edge);
    }
  }
  if (pieces.size() < 2 || !open.empty()) pieces.clear();
  return pieces;
}

PolygonSoup soup_of_faces(const PolygonSoup& soup, const std::vector<FaceIndex>& faces) {
  PolygonSoup part;
  std::map<VertexIndex, VertexIndex> renumbered;
  for (const FaceIndex face : faces) {
    for (const VertexIndex v : soup.face(face)) {
      const auto [found, is_new] = renumbered.try_emplace(v, static_cast<VertexIndex>(part.points.size()));
      if (is_new) part.points.push_back(soup.points[v]);
      part.corners.push_back(found->second);
    }
    part.close_face();
  }
  return part;
}

// What was done to several pieces, each once.
void add_new(std::vector<std::string>& repairs, const std::vector<std::string>& more) {
  for (const std::string& repair : more)
    if (std::find(repairs.begin(), repairs.end(), repair) == repairs.end()) repairs.push_back(repair);
}

std::optional<RepairedSolids> piece_by_piece(const PolygonSoup& soup,
                                             const std::vector<std::vector<FaceIndex>>& pieces,
                                             double close_holes) {
  RepairedSolids solids{{}, soup.notes, true};
  for (const std::vector<FaceIndex>& faces : pieces) {
    const RepairedSurface piece = repair_surface(soup_of_faces(soup, faces), close_holes);
    const MeshTopology& topology = piece.diagnosis.topology;
    if (!topology.manifold() || !topology.closed() || piece.mesh.triangles.empty()) return {};
    append(solids.mesh, piece.mesh);
    add_new(solids.repairs, piece.repairs);
  }
  if (solids.mesh.triangles.empty()) return {};
  return solids;
}

}  // namespace

RepairedSolids repair_solids(const PolygonSoup& soup, double close_holes) {
  if (auto solids = piece_by_piece(soup, pieces_of(soup), close_holes)) return *std::move(solids);
  if (auto solids = piece_by_piece(soup, closed_runs(soup), close_holes)) return *std::move(solids);
  RepairedSurface all = repair_surface(soup, close_holes, CrossingSheets::go_on);
  return {std::move(all.mesh), std::move(all.repairs), all.diagnosis.topology.manifold()};
}

}  // namespace nanocarbon::mesh
