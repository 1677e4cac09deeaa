// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/repair/sew_in_cell.h"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "nanocarbon/core/disjoint_sets.h"
#include "nanocarbon/core/error.h"
#include "nanocarbon/mesh/edge_table.h"
#include "nanocarbon/mesh/measures.h"
#include "nanocarbon/mesh/mesh_topology.h"
#include "nanocarbon/mesh/repair/match_images.h"
#include "nanocarbon/mesh/repair/merge_close_vertices.h"
#include "nanocarbon/mesh/repair/place_cell.h"
#include "nanocarbon/mesh/repair/zip_seams.h"
#include "nanocarbon/mesh/winding.h"

namespace nanocarbon::mesh {
namespace {

// In mean edges: boundaries this near to the image of another, in the root mean square, are the same line.
constexpr double same_line = 0.25;
// In mean edges: vertices without a counterpart that are this near each other along a seam are merged.
constexpr double close_along = 0.25;
// In mean edges: pieces at faces of the cell that reach no farther than this from one of their vertices are no pieces.
constexpr double speck = 0.5;
// Of the mesh: slivers and specks are no more than what these leave over.
constexpr double least_area = 0.98, least_faces = 0.8;
// Rise for length: edges that are steeper against a face of the cell do not lie in it.
constexpr double steepest = 0.5;
// In least widths.
constexpr double longest_edge = 0.25;
// Triangles that a mesh is split into at most, and as many more for each that it has: a file of a few lines can ask for
// any number.
constexpr double most_parts = 50'000, most_parts_of_one = 100;

struct BoundaryEdge {
  VertexIndex from, to;
  FaceIndex face;
  std::size_t side;  // of the face, from its corner `side`
};

std::vector<BoundaryEdge> boundary_edges(const TriangleMesh& mesh) {
  const EdgeTable edges = edge_table(soup_of(mesh));
  std::vector<BoundaryEdge> boundary;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto uses = edges.uses_of(e);
    if (uses.size() != 1) continue;
    const std::size_t side = uses[0].corner % 3;
    const Triangle& t = mesh.triangles[uses[0].face];
    boundary.push_back({t[side], t[(side + 1) % 3], uses[0].face, side});
  }
  return boundary;
}

class Sewing {
 public:
  Sewing(const TriangleMesh& mesh, const Cell& cell, double match)
      : mesh_(mesh), cell_(cell), space_(cell), to_fractional_(cell.vectors.inverse()) {
    mean_edge_ = edge_lengths(mesh).mean;
    tolerance_ = match * mean_edge_;
  }

  SewnSurface run() {
    const std::size_t copies = place_cell(mesh_, cell_, tolerance_, same_line * mean_edge_);
    if (copies > 0) note(fmt::format("dropped faces beyond the cell that are images of others: {}", copies));
    drop_caps();
    split_long_edges();
    return first_that_works();
  }

 private:
  // Noise, and vertices near edges and corners of the cell, leave it open what is meant to be the same: another reading where
  // the plain one comes to nothing, of which the first failure is told.
  SewnSurface first_that_works() {
    const TriangleMesh cut = mesh_;
    const std::size_t notes = result_.notes.size();
    std::optional<UserError> failure;
    for (const bool merging : {false, true})
      for (const bool corners_first : {false, true}) {
        mesh_ = cut;
        result_.mesh = {};
        result_.notes.resize(notes);
        try {
          sew(merging, corners_first);
          return std::move(result_);
        } catch (const UserError& error) {
          if (!failure) failure = error;
        }
      }
    throw UserError(*failure);
  }

  void sew(bool merging, bool corners_first) {
    if (merging) {
      const double all = area(mesh_);
      const std::size_t faces = mesh_.triangles.size();
      drop_specks_at_faces();
      // Vertices at nodes of the grid, but for rounding.
      merge_close_vertices(mesh_, 4 * tolerance_, MergedEdges::all,
                           [&](VertexIndex v) { return face_of(mesh_.points[v], 4 * tolerance_) >= 0; });
      // Not told: the plain reading has failed before.
      if (area(mesh_) < least_area * all ||
          static_cast<double>(mesh_.triangles.size()) < least_faces * static_cast<double>(faces))
        throw UserError(Failure::unsuitable, "what lies at faces of the cell is more than slivers");
    }
    match_vertices();
    if (merging) merge_along_seams();
    zip(corners_first);
    require_partners();
    identify();
    check();
  }

  const Cell& cell() const { return cell_; }
  bool periodic(int d) const { return cell().periodic[static_cast<std::size_t>(d)]; }
  Vec3 fractional(const Vec3& p) const { return to_fractional_ * (p - cell().origin); }
  std::string place(const Vec3& p) const {
    return fmt::format("({:.6g}, {:.6g}, {:.6g})", p.x(), p.y(), p.z());
  }

  // Twice the direction, and one more for the upper face; -1 for no face of the cell.
  int face_of(const Vec3& p, double within) const {
    const Vec3 f = fractional(p), heights = face_distances(cell());
    for (int d = 0; d < 3; ++d)
      for (const int upper : {0, 1})
        if (periodic(d) && std::abs(f[d] - upper) * heights[d] < within) return 2 * d + upper;
    return -1;
  }
  bool in_face(const Vec3& p, int face, double within) const {
    return std::abs(fractional(p)[face / 2] - face % 2) * face_distances(cell())[face / 2] < within;
  }

  void drop_caps() {
    const double flat = 1e-4 * mean_edge_;
    std::array<std::size_t, 6> in{};
    std::vector<int> cap(mesh_.triangles.size(), -1);
    for (std::size_t t = 0; t < cap.size(); ++t)
      for (int face = 0; face < 6; ++face) {
        if (!periodic(face / 2)) continue;
        const auto lies = [&](VertexIndex v) { return in_face(mesh_.points[v], face, flat); };
        const Triangle& corners = mesh_.triangles[t];
        if (!lies(corners[0]) || !lies(corners[1]) || !lies(corners[2])) continue;
        cap[t] = face;
        ++in[static_cast<std::size_t>(face)];
      }
    std::vector<Triangle> kept;
    for (std::size_t t = 0; t < cap.size(); ++t) {
      const bool both = cap[t] >= 0 && in[static_cast<std::size_t>(cap[t])] > 0 &&
                        in[static_cast<std::size_t>(cap[t] ^ 1)] > 0;
      if (!both) kept.push_back(mesh_.triangles[t]);
    }
    if (kept.size() == mesh_.triangles.size()) return;
    note(fmt::format("dropped flat faces in the faces of the cell, which closed a solid: {}",
                     mesh_.triangles.size() - kept.size()));
    mesh_.triangles = std::move(kept);
    if (mesh_.triangles.empty())
      fail("nothing but flat faces in the faces of the cell", "is this the right cell?");
  }

  void split_long_edges() {
    const double limit = longest_edge * space_.least_width();
    double parts = 0.0;
    for (const Triangle& t : mesh_.triangles) {
      const auto [a, b, c] = corners_of(mesh_, t);
      parts += 1.0 + std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()}) /
                         (limit * limit);
    }
    if (!(parts <= most_parts + most_parts_of_one * static_cast<double>(mesh_.triangles.size())))
      fail(fmt::format("its edges are so long against the cell that it would be split into {:.1e} triangles",
                       parts),
           "is this the right cell?");
    for (bool split = true; split;) {
      split = false;
      const EdgeTable edges = edge_table(soup_of(mesh_));
      std::vector<bool> touched(mesh_.triangles.size(), false);
      for (std::size_t e = 0; e < edges.size(); ++e) {
        const Vec3 low = mesh_.points[edges.low[e]], high = mesh_.points[edges.high[e]];
        if ((high - low).norm() <= limit) continue;
        split = true;
        const auto uses = edges.uses_of(e);
        if (std::any_of(uses.begin(), uses.end(), [&](const EdgeUse& use) { return touched[use.face]; }))
          continue;
        const auto middle = static_cast<VertexIndex>(mesh_.points.size());
        mesh_.points.push_back(0.5 * (low + high));
        for (const EdgeUse& use : uses) {
          touched[use.face] = true;
          insert(use.face, use.corner % 3, {middle});
          touched.push_back(true);
        }
      }
    }
  }

  // Cuts a face so that vertices lie on one of its sides, in order.
  void insert(FaceIndex face, std::size_t side, const std::vector<VertexIndex>& vertices) {
    const Triangle t = mesh_.triangles[face];
    VertexIndex from = t[side];
    const VertexIndex to = t[(side + 1) % 3], apex = t[(side + 2) % 3];
    mesh_.triangles[face] = {from, vertices.front(), apex};
    for (std::size_t k = 0; k < vertices.size(); ++k)
      mesh_.triangles.push_back({vertices[k], k + 1 < vertices.size() ? vertices[k + 1] : to, apex});
  }

  // What lies on an image of what: boundary vertices only, and never two of the same place.
  void match_vertices() {
    boundary_.clear();
    for (const BoundaryEdge& edge : boundary_edges(mesh_)) boundary_.push_back(edge.from);
    std::sort(boundary_.begin(), boundary_.end());
    boundary_.erase(std::unique(boundary_.begin(), boundary_.end()), boundary_.end());
    partner_ = match_images(mesh_, cell(), boundary_, tolerance_);
  }

  // Pieces smaller than an edge where the surface goes through an edge or a corner of the cell: what a grid's node left there
  // of the surface beyond.
  void drop_specks_at_faces() {
    const double size = speck * mean_edge_;
    DisjointSets pieces(mesh_.points.size());
    for (const Triangle& t : mesh_.triangles) {
      pieces.join(t[0], t[1]);
      pieces.join(t[0], t[2]);
    }
    std::vector<bool> large(mesh_.points.size(), false);
    for (VertexIndex v = 0; v < mesh_.points.size(); ++v) {
      const std::size_t first = pieces.find(v);
      if ((mesh_.points[v] - mesh_.points[first]).norm() > size || face_of(mesh_.points[v], size) < 0)
        large[first] = true;
    }
    const std::size_t dropped =
        std::erase_if(mesh_.triangles, [&](const Triangle& t) { return !large[pieces.find(t[0])]; });
    if (dropped > 0) note(fmt::format("dropped faces of specks at faces of the cell: {}", dropped));
  }

  // Vertices without a counterpart that are so near each other along the boundary that their order says nothing.
  void merge_along_seams() {
    std::vector<bool> lonely(mesh_.points.size(), false);
    for (const VertexIndex v : boundary_)
      lonely[v] = partner_[v].empty() && face_of(mesh_.points[v], same_line * mean_edge_) >= 0;
    const std::size_t merged = merge_close_vertices(mesh_, close_along * mean_edge_, MergedEdges::boundary,
                                                    [&](VertexIndex v) { return bool(lonely[v]); });
    if (merged == 0) return;
    note(fmt::format("merged vertices near each other along seams: {}", merged));
    match_vertices();
  }

  // Boundaries that lie along images of others, but have other vertices.
  void zip(bool corners_first) {
    const ZippedSeams zipped = zip_seams(mesh_, partner_, cell(), same_line * mean_edge_, corners_first);
    if (zipped.joined > 0)
      note(fmt::format("joined boundary vertices that lie up to {:.2g} mean edges from images of others: {}",
                       zipped.farthest / mean_edge_, zipped.joined));
    if (zipped.added > 0)
      note(fmt::format("cut the triangles along seams so that their vertices meet: {} vertices added",
                       zipped.added));
  }

  // A boundary edge that the cell's face cut: along that face, near it, with the surface on the inner side. So is no edge of
  // a hole that reaches the face, or nearly so. As face_of().
  int cut_by(const BoundaryEdge& edge) const {
    const Vec3 from = fractional(mesh_.points[edge.from]), to = fractional(mesh_.points[edge.to]),
               apex = fractional(mesh_.points[mesh_.triangles[edge.face][(edge.side + 2) % 3]]),
               heights = face_distances(cell());
    const double length = (mesh_.points[edge.to] - mesh_.points[edge.from]).norm();
    const double near = same_line * mean_edge_;
    for (int face = 0; face < 6; ++face) {
      const int d = face / 2, upper = face % 2;
      if (!periodic(d)) continue;
      const auto inside = [&](const Vec3& p) { return (upper ? 1 - p[d] : p[d]) * heights[d]; };
      const double a = inside(from), b = inside(to);
      if (std::abs(a) < near && std::abs(b) < near && std::abs(a - b) <= steepest * length &&
          inside(apex) > 0.5 * (a + b) - 0.2 * near)
        return face;
    }
    return -1;
  }

  // Vertices of the boundary that the cell's faces cut, and those of them without a counterpart.
  struct CutBoundary {
    std::vector<bool> in_face, lonely;
  };

  // Lines along one face, with what has no counterpart in them: parts shorter than an edge, of the mesh and of the
  // boundary there, are rounded corners of holes.
  CutBoundary cut_boundary() const {
    std::vector<DisjointSets> lines(6, DisjointSets(mesh_.points.size()));
    std::vector<std::pair<BoundaryEdge, int>> cut;
    CutBoundary found{std::vector<bool>(mesh_.points.size(), false),
                      std::vector<bool>(mesh_.points.size(), false)};
    std::array<double, 6> longest{};  // of the boundary's edges in each face
    for (const BoundaryEdge& edge : boundary_edges(mesh_)) {
      const int face = cut_by(edge);
      if (face < 0) continue;
      found.in_face[edge.from] = found.in_face[edge.to] = true;
      double& here = longest[static_cast<std::size_t>(face)];
      here = std::max(here, length_of(edge));
      if (!partner_[edge.from].empty() && !partner_[edge.to].empty()) continue;
      cut.emplace_back(edge, face);
      // Others are where a line ends.
      if (partner_[edge.from].empty() && partner_[edge.to].empty())
        lines[static_cast<std::size_t>(face)].join(edge.from, edge.to);
    }
    std::map<std::pair<int, std::uint32_t>, double> lengths;
    const auto line_of = [&](const std::pair<BoundaryEdge, int>& c) {
      const VertexIndex v = partner_[c.first.from].empty() ? c.first.from : c.first.to;
      return std::pair(c.second, lines[static_cast<std::size_t>(c.second)].find(v));
    };
    for (const auto& c : cut) lengths[line_of(c)] += length_of(c.first);
    for (const auto& c : cut)
      if (lengths[line_of(c)] > std::min(mean_edge_, longest[static_cast<std::size_t>(c.second)]))
        for (const VertexIndex v : {c.first.from, c.first.to}) found.lonely[v] = partner_[v].empty();
    return found;
  }
  double length_of(const BoundaryEdge& edge) const {
    return (mesh_.points[edge.to] - mesh_.points[edge.from]).norm();
  }

  // The image of the boundary, of another place, that is nearest to a point of it.
  std::string nearest_image(const Vec3& p) const {
    double nearest = std::numeric_limits<double>::infinity();
    Vec3 where = p;
    for (const VertexIndex v : boundary_) {
      const Vec3 there = space_.displacement(p, mesh_.points[v]);
      if ((there - (mesh_.points[v] - p)).norm() < mean_edge_ || there.norm() >= nearest) continue;
      nearest = there.norm();
      where = mesh_.points[v];
    }
    if (!std::isfinite(nearest)) return "there is no boundary at the opposite face";
    return fmt::format("the nearest image of the boundary is {:.3g} mean edges from it, of {}",
                       nearest / mean_edge_, place(where));
  }

  void require_partners() const {
    const CutBoundary cut = cut_boundary();
    const auto first = std::find(cut.lonely.begin(), cut.lonely.end(), true);
    if (first == cut.lonely.end()) return;
    const Vec3& p = mesh_.points[static_cast<std::size_t>(first - cut.lonely.begin())];
    fail(fmt::format(
             "{} of {} boundary vertices in the faces of the cell have no counterpart in the opposite face; "
             "the first is at {}: {}",
             std::count(cut.lonely.begin(), cut.lonely.end(), true),
             std::count(cut.in_face.begin(), cut.in_face.end(), true), place(p), nearest_image(p)),
         "is the cell right? Is a part of the surface missing? Cut the surface by the cell's faces alone, or "
         "give --cell and --periodic");
  }

  void identify() {
    DisjointSets sets(mesh_.points.size());
    for (VertexIndex v = 0; v < partner_.size(); ++v)
      for (const VertexIndex other : partner_[v]) sets.join(v, other);
    std::vector<VertexIndex> index(mesh_.points.size(), none);
    std::vector<Vec3> sum;
    std::vector<double> count;
    TriangleMesh& sewn = result_.mesh;
    sewn.space = space_;
    std::vector<bool> used(mesh_.points.size(), false);
    for (const Triangle& t : mesh_.triangles)
      for (const VertexIndex v : t) used[v] = true;
    for (VertexIndex v = 0; v < mesh_.points.size(); ++v) {
      if (!used[v]) continue;
      const auto root = static_cast<VertexIndex>(sets.find(v));
      if (index[root] == none) {
        index[root] = static_cast<VertexIndex>(sewn.points.size());
        sewn.points.push_back(mesh_.points[v]);
        sum.push_back(Vec3::Zero());
        count.push_back(0);
      }
      const VertexIndex i = index[root];
      sum[i] += space_.displacement(sewn.points[i], mesh_.points[v]);
      count[i] += 1;
      index[v] = i;
    }
    for (std::size_t i = 0; i < sewn.points.size(); ++i) sewn.points[i] += sum[i] / count[i];
    for (const Triangle& t : mesh_.triangles) {
      const Triangle corners = {index[t[0]], index[t[1]], index[t[2]]};
      if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) {
        // A sliver whose vertices are as near to each other as they may be to images.
        const auto apart = [&](std::size_t k) {
          const VertexIndex a = t[k], b = t[(k + 1) % 3];
          return index[a] == index[b] ? (mesh_.points[a] - mesh_.points[b]).norm() : 0.0;
        };
        if (std::max({apart(0), apart(1), apart(2)}) <= 4 * tolerance_) continue;
        fail(fmt::format("two corners of the triangle at {} would be images of the same point",
                         place(mesh_.points[t[0]])),
             "is the cell right, its angles too? If it is, give a finer mesh");
      }
      sewn.triangles.push_back(corners);
    }
  }

  void check() {
    TriangleMesh& sewn = result_.mesh;
    const EdgeTable edges = edge_table(soup_of(sewn));
    const MeshTopology topology = mesh_topology(soup_of(sewn), edges);
    for (const std::size_t e : topology.non_manifold_edges)
      fail(fmt::format("the edge from {} to {} has more than two faces once the cell's faces are joined",
                       place(sewn.points[edges.low[e]]), place(sewn.points[edges.high[e]])),
           "faces of the mesh that lie in a face of the cell must be there once or not at all");
    for (const VertexIndex v : topology.non_manifold_vertices)
      fail(fmt::format("parts of the surface meet at a single point at {} once the cell's faces are joined",
                       place(sewn.points[v])),
           "is the cell right?");
    if (!topology.orientable)
      fail("the surface has no two sides in this cell: going through it leads to the other side",
           "use a cell twice as large (--cells 2)");
    if (const std::size_t turned = wind_alike(sewn, topology, edges))
      note(fmt::format("turned faces that were wound against the others across the cell: {}", turned));
    const double longest = edge_lengths(sewn).max;
    if (longest > space_.least_width() / 3)
      fail("edges are too long for a cell this narrow",
           "treat several cells as one (--cells 2), or give a finer mesh");
  }

  void note(std::string text) { result_.notes.push_back(std::move(text)); }
  [[noreturn]] static void fail(const std::string& what, const std::string& remedy) {
    throw UserError(Failure::unsuitable,
                    fmt::format("the mesh cannot be used in this cell: {}; {}", what, remedy));
  }

  static constexpr VertexIndex none = std::numeric_limits<VertexIndex>::max();
  TriangleMesh mesh_;
  Cell cell_;    // where it is sewn
  Space space_;  // where it was asked for
  Mat3 to_fractional_;
  double mean_edge_ = 0.0, tolerance_ = 0.0;
  std::vector<VertexIndex> boundary_;
  Partners partner_;
  SewnSurface result_;
};

}  // namespace

SewnSurface sew_in_cell(const TriangleMesh& mesh, const Cell& cell, double match) {
  return Sewing(mesh, cell, match).run();
}

}  // namespace nanocarbon::mesh
