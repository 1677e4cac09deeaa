// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/repair/zip_seams.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>

#include "nanocarbon/core/neighbours_within.h"
#include "nanocarbon/mesh/edge_table.h"

namespace nanocarbon::mesh {
namespace {

using Image = std::array<std::int32_t, 3>;
constexpr Image here = {0, 0, 0};

// Of the mean length of edges: what the vertices of a line may lie from the other line, in the root mean square; over
// that, what one of them may; and from a vertex that it joins rather than being given to the other side.
constexpr double share_apart = 0.25, times_apart = 3, share_single = 0.2;
// Of the distance between opposite faces of the cell: where images are looked for at most.
constexpr double share_reach = 0.25;
// Pairs of vertices that are looked at for two lines, at most.
constexpr double most_pairs = 2e7;

double distance_to_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 along = b - a;
  const double place = std::clamp((p - a).dot(along) / std::max(along.squaredNorm(), 1e-300), 0.0, 1.0);
  return (a + place * along - p).norm();
}

// A part of a boundary between vertices that have partners; along the winding of its triangles.
struct Chain {
  std::vector<VertexIndex> vertices;  // the first and the last have partners; they may be the same
  bool done = false;
};

// What becomes of two lines: partners, and vertices of one that come between two of the other.
struct Alignment {
  struct Step {
    bool one, other;  // which line the vertex is of; both where two are joined
  };
  double cost = std::numeric_limits<double>::infinity();
  std::vector<Step> steps;  // without the ends
};

class Zipping {
 public:
  Zipping(TriangleMesh& mesh, Partners& partners, const Cell& cell, double same_line, bool corners_first)
      : mesh_(mesh), partners_(partners), cell_(cell), same_line_(same_line), corners_first_(corners_first) {}

  ZippedSeams run() {
    list_boundary();
    if (lonely_.empty()) return result_;
    find_near_images();
    join_at_edges_of_the_cell();
    give_loops_a_partner();
    list_chains();
    for (std::size_t c = 0; c < chains_.size(); ++c)
      if (!chains_[c].done) zip(c);
    return result_;
  }

 private:
  void list_boundary() {
    const EdgeTable edges = edge_table(soup_of(mesh_));
    for (std::size_t e = 0; e < edges.size(); ++e) {
      const auto uses = edges.uses_of(e);
      if (uses.size() != 1) continue;
      const std::size_t side = uses[0].corner % 3;
      const Triangle& t = mesh_.triangles[uses[0].face];
      face_of_[{t[side], t[(side + 1) % 3]}] = uses[0].face;
      next_[t[side]].push_back(t[(side + 1) % 3]);
    }
    for (const auto& [v, next] : next_)
      if (partners_[v].empty()) lonely_.push_back(v);
  }
  bool ends_chains(VertexIndex v) const { return !partners_[v].empty() || next_.at(v).size() > 1; }

  void make_partners(VertexIndex one, VertexIndex other, double distance) {
    partners_[one].push_back(other);
    partners_[other].push_back(one);
    ++result_.joined;
    result_.farthest = std::max(result_.farthest, distance);
  }
  // A vertex and all that it is one with.
  std::vector<VertexIndex> all_of(VertexIndex v) const {
    std::vector<VertexIndex> all = {v};
    for (std::size_t k = 0; k < all.size(); ++k)
      for (const VertexIndex next : partners_[all[k]])
        if (std::find(all.begin(), all.end(), next) == all.end()) all.push_back(next);
    return all;
  }

  void find_near_images() {
    for (const auto& [v, next] : next_) {
      boundary_.push_back(v);
      points_.push_back(mesh_.points[v]);
      mean_edge_ += (mesh_.points[next.front()] - mesh_.points[v]).norm() / static_cast<double>(next_.size());
    }
    reach_ = times_apart * std::max(same_line_, share_apart * mean_edge_);
    // Edges may be longer than a cell is wide: everything would be near everything.
    const Vec3 heights = face_distances(cell_);
    for (std::size_t d = 0; d < 3; ++d)
      if (cell_.periodic[d]) reach_ = std::min(reach_, share_reach * heights[static_cast<Eigen::Index>(d)]);
    near_ = neighbours_within(points_, &cell_, reach_);
  }
  double distance(std::size_t i, const Neighbour& n) const {
    return (points_[n.atom] + image_shift(cell_, n.image) - points_[i]).norm();
  }

  // Where the surface goes through an edge of the cell, boundaries in several directions meet: four vertices are one,
  // or, at a corner of the cell, as many as there are.
  void join_at_edges_of_the_cell() {
    std::vector<Meeting> at_edges, at_corners;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const std::array<bool, 3> near = faces_near(points_[i]);
      if (near[0] + near[1] + near[2] < 2) continue;
      std::map<Image, Neighbour> nearest;
      for (const Neighbour& n : near_.of(i)) {
        if (n.image == here || n.atom == i) continue;
        const auto [entry, added] = nearest.try_emplace(n.image, n);
        if (!added && distance(i, n) < distance(i, entry->second)) entry->second = n;
      }
      for (const auto& [image, n] : nearest)
        for (std::size_t d = 0; d < 3; ++d) {  // the image in one of two directions, and in both
          Image along = here, across = image;
          along[d] = image[d];
          across[d] = 0;
          if (along == here || across == here || !nearest.count(along) || !nearest.count(across)) continue;
          if ((across[0] != 0) + (across[1] != 0) + (across[2] != 0) == 1)
            at_edges.push_back(meeting(i, {nearest.at(along), nearest.at(across), n}));
        }
      std::vector<Neighbour> all;
      for (const auto& [image, n] : nearest) all.push_back(n);
      if (near[0] && near[1] && near[2] && all.size() > 2) at_corners.push_back(meeting(i, all));
    }
    std::vector<bool> used(mesh_.points.size(), false);
    join(corners_first_ ? at_corners : at_edges, used);
    join(corners_first_ ? at_edges : at_corners, used);
  }
  std::array<bool, 3> faces_near(const Vec3& p) const {
    const Vec3 at = cell_.vectors.inverse() * (p - cell_.origin), heights = face_distances(cell_);
    std::array<bool, 3> near;
    for (std::size_t d = 0; d < 3; ++d) {
      const auto k = static_cast<Eigen::Index>(d);
      near[d] = cell_.periodic[d] && std::min(std::abs(at[k]), std::abs(at[k] - 1)) * heights[k] < reach_;
    }
    return near;
  }
  struct Meeting {
    std::size_t at;
    std::vector<Neighbour> images;
    double apart;
  };
  Meeting meeting(std::size_t at, std::vector<Neighbour> images) const {
    double apart = 0;
    for (const Neighbour& n : images) apart += distance(at, n) / static_cast<double>(images.size());
    return {at, std::move(images), apart};
  }
  // The nearest first; no vertex is in two of them.
  void join(std::vector<Meeting>& meetings, std::vector<bool>& used) {
    std::stable_sort(meetings.begin(), meetings.end(),
                     [](const Meeting& a, const Meeting& b) { return a.apart < b.apart; });
    for (const Meeting& meeting : meetings) {
      const VertexIndex v = boundary_[meeting.at];
      if (used[v] || std::any_of(meeting.images.begin(), meeting.images.end(),
                                 [&](const Neighbour& n) { return bool(used[boundary_[n.atom]]); }))
        continue;
      used[v] = true;
      for (const Neighbour& n : meeting.images) {
        const VertexIndex other = boundary_[n.atom];
        used[other] = true;
        const std::vector<VertexIndex> all = all_of(v);
        if (std::find(all.begin(), all.end(), other) == all.end())
          make_partners(v, other, distance(meeting.at, n));
      }
    }
  }

  // A loop none of whose vertices has a partner gets one where it is nearest to an image of another such.
  void give_loops_a_partner() {
    std::vector<bool> seen(mesh_.points.size(), false);
    for (const VertexIndex start : boundary_) {
      if (seen[start]) continue;
      double least = std::numeric_limits<double>::infinity();
      std::pair<VertexIndex, VertexIndex> closest;
      bool has_partner = false;
      for (VertexIndex v = start; !seen[v]; v = next_.at(v).front()) {
        seen[v] = true;
        has_partner |= ends_chains(v);
        const auto i = static_cast<std::size_t>(std::lower_bound(boundary_.begin(), boundary_.end(), v) -
                                                boundary_.begin());
        for (const Neighbour& n : near_.of(i)) {
          if (n.image == here || n.atom == i || distance(i, n) >= least) continue;
          if (!partners_[boundary_[n.atom]].empty()) continue;  // not so the rim of a hole beside a seam
          least = distance(i, n);
          closest = {v, boundary_[n.atom]};
        }
      }
      if (!has_partner && std::isfinite(least)) make_partners(closest.first, closest.second, least);
    }
  }

  void list_chains() {
    for (const auto& [v, next] : next_) {
      if (!ends_chains(v)) continue;
      for (VertexIndex to : next) {
        Chain chain{{v, to}};
        while (!ends_chains(to)) chain.vertices.push_back(to = next_.at(to).front());
        chains_at_[v].push_back(chains_.size());
        if (to != v) chains_at_[to].push_back(chains_.size());
        chains_.push_back(std::move(chain));
      }
    }
  }

  // Multiples of the cell's edges that lead from a vertex to where its partner is seen.
  Image image_between(VertexIndex from, VertexIndex to) const {
    const Vec3 apart = cell_.vectors.inverse() * (mesh_.points[to] - mesh_.points[from]);
    Image image = here;
    for (std::size_t d = 0; d < 3; ++d)
      if (cell_.periodic[d])
        image[d] = static_cast<std::int32_t>(std::lround(apart[static_cast<Eigen::Index>(d)]));
    return image;
  }

  double mean_edge(const std::vector<VertexIndex>& line) const {
    double length = 0;
    for (std::size_t k = 1; k < line.size(); ++k)
      length += (mesh_.points[line[k]] - mesh_.points[line[k - 1]]).norm();
    return length / static_cast<double>(line.size() - 1);
  }

  // Aligns the chain with that which lies along an image of it.
  void zip(std::size_t c) {
    const VertexIndex begin = chains_[c].vertices.front(), end = chains_[c].vertices.back();
    if (partners_[begin].empty() || partners_[end].empty()) return;
    const std::vector<VertexIndex> at_end = all_of(end);
    Alignment best;
    std::size_t other = 0;
    std::vector<VertexIndex> line;  // of the best, in the direction of this one
    for (const VertexIndex w : all_of(begin)) {
      const Image image = image_between(begin, w);
      if (image == here || chains_at_.count(w) == 0) continue;
      for (const std::size_t d : chains_at_.at(w))
        for (const bool backwards : {true, false}) {
          if (chains_[d].done || d == c) continue;
          std::vector<VertexIndex> there = chains_[d].vertices;
          if (backwards) std::reverse(there.begin(), there.end());
          if (there.front() != w || std::find(at_end.begin(), at_end.end(), there.back()) == at_end.end() ||
              image_between(end, there.back()) != image)
            continue;
          Alignment found = aligned(chains_[c].vertices, there, image_shift(cell_, image));
          if (!(found.cost < best.cost)) continue;
          best = std::move(found);
          other = d;
          line = std::move(there);
        }
    }
    if (!std::isfinite(best.cost)) return;
    chains_[c].done = chains_[other].done = true;
    carry_out(best, chains_[c].vertices, line);
  }

  // In order along both lines, with the least squares of what lies between them.
  Alignment aligned(const std::vector<VertexIndex>& one, const std::vector<VertexIndex>& other,
                    const Vec3& shift) const {
    const std::size_t n = one.size(), m = other.size();
    Alignment result;
    if (static_cast<double>(n) * static_cast<double>(m) > most_pairs) return result;
    const double length = mean_edge(one), other_length = mean_edge(other);
    const double apart = std::max(same_line_, share_apart * std::max(length, other_length));
    const double reach = times_apart * apart;
    const double single = std::pow(share_single * std::min(length, other_length), 2);
    constexpr double never = std::numeric_limits<double>::infinity();
    const auto squared = [&](double distance) { return distance <= reach ? distance * distance : never; };
    const auto a = [&](std::size_t i) -> const Vec3& { return mesh_.points[one[i]]; };
    const auto b = [&](std::size_t j) -> Vec3 { return mesh_.points[other[j]] - shift; };
    enum class Way : char { none, joined, of_one, of_other };
    std::vector<double> cost(n * m, never);
    std::vector<Way> way(n * m, Way::none);
    cost[0] = 0;
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < m; ++j) {
        const bool end = i + 1 == n || j + 1 == m;
        const auto offer = [&](double before, double more, Way how) {
          if (before + more >= cost[i * m + j]) return;
          cost[i * m + j] = before + more;
          way[i * m + j] = how;
        };
        if (i > 0 && j > 0 && (i + 1 == n) == (j + 1 == m))
          offer(cost[(i - 1) * m + j - 1], i + 1 == n ? 0 : squared((a(i) - b(j)).norm()), Way::joined);
        if (end) continue;
        if (i > 0)
          offer(cost[(i - 1) * m + j], single + squared(distance_to_segment(a(i), b(j), b(j + 1))),
                Way::of_one);
        if (j > 0)
          offer(cost[i * m + j - 1], single + squared(distance_to_segment(b(j), a(i), a(i + 1))),
                Way::of_other);
      }
    if (!std::isfinite(cost.back())) return result;
    for (std::size_t i = n - 2, j = m - 2; i > 0 || j > 0;) {
      const Way how = way[i * m + j];
      result.steps.push_back({how != Way::of_other, how != Way::of_one});
      i -= how != Way::of_other;
      j -= how != Way::of_one;
    }
    std::reverse(result.steps.begin(), result.steps.end());
    if (cost.back() <= static_cast<double>(result.steps.size()) * apart * apart) result.cost = cost.back();
    return result;
  }

  void carry_out(const Alignment& alignment, const std::vector<VertexIndex>& one,
                 const std::vector<VertexIndex>& other) {
    const Vec3 shift = image_shift(cell_, image_between(one.front(), other.front()));
    std::vector<std::vector<VertexIndex>> into_one(one.size()), into_other(other.size());
    std::size_t i = 0, j = 0;
    for (const Alignment::Step& step : alignment.steps) {
      i += step.one;
      j += step.other;
      if (step.one && step.other)
        make_partners(one[i], other[j], (mesh_.points[one[i]] + shift - mesh_.points[other[j]]).norm());
      else if (step.one)
        into_other[j].push_back(copied(one[i], shift));
      else
        into_one[i].push_back(copied(other[j], -shift));
    }
    for (std::size_t k = 0; k + 1 < one.size(); ++k) give(one[k], one[k + 1], into_one[k]);
    for (std::size_t k = 0; k + 1 < other.size(); ++k) give(other[k], other[k + 1], into_other[k]);
  }

  // A vertex on the image of another.
  VertexIndex copied(VertexIndex of, const Vec3& shift) {
    const auto v = static_cast<VertexIndex>(mesh_.points.size());
    mesh_.points.push_back(mesh_.points[of] + shift);
    partners_.push_back({of});
    partners_[of].push_back(v);
    ++result_.added;
    return v;
  }

  // Cuts the triangle at a boundary edge so that vertices lie on that, in order.
  void give(VertexIndex from, VertexIndex to, std::vector<VertexIndex> vertices) {
    if (vertices.empty()) return;
    auto at = face_of_.find({from, to});
    if (at == face_of_.end()) {
      std::swap(from, to);
      std::reverse(vertices.begin(), vertices.end());
      at = face_of_.find({from, to});
    }
    const FaceIndex face = at->second;
    const Triangle t = mesh_.triangles[face];
    std::size_t side = 0;
    while (t[side] != from) ++side;
    const VertexIndex apex = t[(side + 2) % 3];
    mesh_.triangles[face] = {from, vertices.front(), apex};
    for (std::size_t k = 0; k < vertices.size(); ++k) {
      const VertexIndex next = k + 1 < vertices.size() ? vertices[k + 1] : to;
      mesh_.triangles.push_back({vertices[k], next, apex});
    }
    // Its other side may be at the boundary, too.
    if (const auto beside = face_of_.find({to, apex}); beside != face_of_.end())
      beside->second = static_cast<FaceIndex>(mesh_.triangles.size() - 1);
  }

  TriangleMesh& mesh_;
  Partners& partners_;
  const Cell& cell_;
  const double same_line_;
  const bool corners_first_;
  std::map<std::pair<VertexIndex, VertexIndex>, FaceIndex> face_of_;  // by boundary edge
  std::map<VertexIndex, std::vector<VertexIndex>> next_;              // along boundaries
  std::vector<VertexIndex> lonely_;
  std::vector<VertexIndex> boundary_;  // in order, and where they are
  std::vector<Vec3> points_;
  double mean_edge_ = 0, reach_ = 0;
  NeighbourList near_;
  std::vector<Chain> chains_;
  std::map<VertexIndex, std::vector<std::size_t>> chains_at_;
  ZippedSeams result_;
};

}  // namespace

ZippedSeams zip_seams(TriangleMesh& mesh, Partners& partners, const Cell& cell, double same_line,
                      bool corners_first) {
  return Zipping(mesh, partners, cell, same_line, corners_first).run();
}

}  // namespace nanocarbon::mesh
