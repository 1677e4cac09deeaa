// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/repair/separate_sheets.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "nanocarbon/mesh/edge_table.h"
#include "nanocarbon/mesh/measures.h"

namespace nanocarbon::mesh {
namespace {

constexpr VertexIndex none = std::numeric_limits<VertexIndex>::max();

using Pair = std::array<EdgeUse, 2>;

// The faces at an edge two by two as they bound the same material; none where that cannot be said.
std::vector<Pair> pairs_around(const PolygonSoup& soup, const EdgeTable& edges, std::size_t edge,
                               bool inside_out, CrossingSheets crossing) {
  const auto uses = edges.uses_of(edge);
  if (uses.size() == 2) return {{uses[0], uses[1]}};
  if (uses.size() % 2 != 0) return {};
  const Vec3 axis = (soup.points[edges.high[edge]] - soup.points[edges.low[edge]]).normalized();
  const Vec3 right = axis.unitOrthogonal(), up = axis.cross(right);
  struct Around {
    double angle;
    EdgeUse use;
  };
  std::vector<Around> around;
  for (const EdgeUse& use : uses) {
    const Vec3 inward =
        newell_normal(soup.points, soup.face(use.face)).cross(use.forward ? axis : Vec3(-axis));
    if (!(inward.norm() > 0.0)) return {};
    around.push_back({std::atan2(inward.dot(up), inward.dot(right)), use});
  }
  std::sort(around.begin(), around.end(), [](const Around& a, const Around& b) {
    return a.angle != b.angle ? a.angle < b.angle : a.use.corner < b.use.corner;
  });
  // Material lies behind a face that runs backwards along the edge and before the next that runs forwards.
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < around.size(); ++i) {
    const EdgeUse &use = around[i].use, &next = around[(i + 1) % around.size()].use;
    if (use.forward == next.forward) {
      const bool cross = crossing == CrossingSheets::go_on && around.size() == 4 &&
                         around[0].use.forward != around[2].use.forward &&
                         around[1].use.forward != around[3].use.forward;
      return cross ? std::vector<Pair>{{around[0].use, around[2].use}, {around[1].use, around[3].use}}
                   : std::vector<Pair>{};
    }
    if (use.forward == inside_out) pairs.push_back({use, next});
  }
  return pairs;
}

class Separation {
 public:
  Separation(const PolygonSoup& soup, CrossingSheets crossing)
      : soup_(soup), edges_(edge_table(soup)), crossing_(crossing), fans_(soup.corners.size()) {}

  SeparatedSheets run(PolygonSoup& result) {
    find_fans();
    name_fans();
    if (done_.vertices == 0 && several_.empty()) return {};
    find_middles();
    if (done_.vertices + done_.edges == 0) return {};
    PolygonSoup separated;
    for (FaceIndex face = 0; face < soup_.faces(); ++face) {
      for (std::uint32_t corner = soup_.offsets[face]; corner < soup_.offsets[face + 1]; ++corner) {
        separated.corners.push_back(vertex_[corner]);
        if (!middle_.empty() && middle_[corner] != none) separated.corners.push_back(middle_[corner]);
      }
      separated.close_face();
    }
    result.points.insert(result.points.end(), added_.begin(), added_.end());
    result.corners = std::move(separated.corners);
    result.offsets = std::move(separated.offsets);
    return done_;
  }

 private:
  struct Ends {
    std::uint32_t low, high;
  };
  Ends ends_of(const EdgeUse& use) const {
    const std::uint32_t next = next_corner(soup_, use.face, use.corner);
    return use.forward ? Ends{use.corner, next} : Ends{next, use.corner};
  }
  void join(const EdgeUse& one, const EdgeUse& other) {
    const Ends a = ends_of(one), b = ends_of(other);
    fans_.join(a.low, b.low);
    fans_.join(a.high, b.high);
  }

  void find_fans() {
    bool closed = true, any = false;
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      closed = closed && edges_.uses_of(e).size() > 1;
      any = any || edges_.uses_of(e).size() > 2;
    }
    const bool inside_out = any && closed && signed_volume(soup_) < 0.0;
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      const auto uses = edges_.uses_of(e);
      if (uses.size() == 2) join(uses[0], uses[1]);
      if (uses.size() <= 2) continue;
      std::vector<Pair> pairs = pairs_around(soup_, edges_, e, inside_out, crossing_);
      for (const Pair& pair : pairs) join(pair[0], pair[1]);
      if (pairs.empty())
        for (const EdgeUse& use : uses) join(uses[0], use);
      else
        several_.push_back(std::move(pairs));
    }
  }

  // The first fan at a vertex keeps its number.
  void name_fans() {
    std::vector<bool> taken(soup_.points.size(), false), split(soup_.points.size(), false);
    vertex_.resize(soup_.corners.size(), none);
    for (std::uint32_t corner = 0; corner < soup_.corners.size(); ++corner) {
      VertexIndex& name = vertex_[fans_.find(corner)];
      const VertexIndex old = soup_.corners[corner];
      if (name == none) {
        name = old;
        if (taken[old]) {
          name = add(soup_.points[old]);
          if (!split[old]) ++done_.vertices;
          split[old] = true;
        }
        taken[old] = true;
      }
      vertex_[corner] = name;
    }
  }

  void find_middles() {
    for (const std::vector<Pair>& pairs : several_) {
      ++done_.edges;
      std::vector<std::pair<VertexIndex, VertexIndex>> seen;
      for (const Pair& pair : pairs) {
        const Ends ends = ends_of(pair[0]);
        const std::pair<VertexIndex, VertexIndex> edge(vertex_[ends.low], vertex_[ends.high]);
        if (std::find(seen.begin(), seen.end(), edge) == seen.end()) {
          seen.push_back(edge);
          continue;
        }
        middle_.resize(soup_.corners.size(), none);
        const VertexIndex middle =
            add(0.5 * (soup_.points[soup_.corners[ends.low]] + soup_.points[soup_.corners[ends.high]]));
        for (const EdgeUse& use : pair) middle_[use.corner] = middle;
      }
    }
  }

  VertexIndex add(const Vec3& point) {
    added_.push_back(point);
    return static_cast<VertexIndex>(soup_.points.size() + added_.size() - 1);
  }

  const PolygonSoup soup_;
  const EdgeTable edges_;
  const CrossingSheets crossing_;
  DisjointSets fans_;
  std::vector<std::vector<Pair>> several_;  // at edges with more than two faces
  std::vector<VertexIndex> vertex_;         // each corner's
  std::vector<VertexIndex> middle_;         // behind each corner, where there is one
  std::vector<Vec3> added_;
  SeparatedSheets done_;
};

}  // namespace

SeparatedSheets separate_sheets(PolygonSoup& soup, CrossingSheets crossing) {
  return Separation(soup, crossing).run(soup);
}

}  // namespace nanocarbon::mesh
