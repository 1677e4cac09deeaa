// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/periodic_mesh.h"

#include <array>
#include <cstdint>
#include <map>
#include <numeric>

#include "nanocarbon/core/disjoint_sets.h"
#include "nanocarbon/mesh/edge_table.h"

namespace nanocarbon::mesh {
namespace {

using Image = std::array<std::int32_t, 3>;

Image operator+(const Image& a, const Image& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Image operator-(const Image& a, const Image& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Image operator*(std::int32_t n, const Image& a) { return {n * a[0], n * a[1], n * a[2]}; }

// Where the cut leaves parts that hang together by a vertex alone, each gets a vertex of its own.
void part_fans(Unfolded& open) {
  TriangleMesh& mesh = open.mesh;
  const PolygonSoup soup = soup_of(mesh);
  const EdgeTable edges = edge_table(soup);
  DisjointSets fans(3 * mesh.triangles.size());  // of corners
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto uses = edges.uses_of(e);
    if (uses.size() != 2) continue;
    for (const VertexIndex v : {edges.low[e], edges.high[e]}) {
      const auto corner = [&](const EdgeUse& use) {
        return soup.corners[use.corner] == v ? use.corner : next_corner(soup, use.face, use.corner);
      };
      fans.join(corner(uses[0]), corner(uses[1]));
    }
  }
  constexpr VertexIndex none = 0xffffffffu;
  std::vector<VertexIndex> of_fan(3 * mesh.triangles.size(), none), first(mesh.points.size(), none);
  for (std::uint32_t corner = 0; corner < of_fan.size(); ++corner) {
    VertexIndex& v = mesh.triangles[corner / 3][corner % 3];
    VertexIndex& own = of_fan[fans.find(corner)];
    if (own == none) {
      own = v;
      if (first[v] != none) {
        own = static_cast<VertexIndex>(mesh.points.size());
        mesh.points.push_back(Vec3(mesh.points[v]));
        open.source.push_back(VertexIndex(open.source[v]));
      } else {
        first[v] = v;
      }
    }
    v = own;
  }
}

}  // namespace

// Euclid's algorithm, one coordinate after the other.
void Translations::add(Image image) {
  for (std::size_t d = 0; d < 3; ++d)
    while (image[d] != 0) {
      if (rows_[d][d] == 0) {
        rows_[d] = image;
        return;
      }
      const Image rest = rows_[d] - rows_[d][d] / image[d] * image;
      rows_[d] = image;
      image = rest;
    }
}

bool Translations::contains(Image image) const {
  for (std::size_t d = 0; d < 3; ++d) {
    if (image[d] == 0) continue;
    if (rows_[d][d] == 0 || image[d] % rows_[d][d] != 0) return false;
    image = image - image[d] / rows_[d][d] * rows_[d];
  }
  return true;
}

int Translations::rank() const { return (rows_[0][0] != 0) + (rows_[1][1] != 0) + (rows_[2][2] != 0); }

Wrapping wrapping(const TriangleMesh& mesh, const MeshTopology& topology) {
  Wrapping result{std::vector<Image>(mesh.points.size()), std::vector<Translations>(topology.components)};
  if (!mesh.space.periodic()) return result;
  std::vector<std::vector<VertexIndex>> neighbours(mesh.points.size());
  for (const Triangle& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      neighbours[t[k]].push_back(t[(k + 1) % 3]);
      neighbours[t[(k + 1) % 3]].push_back(t[k]);
    }
  std::vector<Image>& image = result.image;
  std::vector<bool> seen(mesh.points.size(), false);
  for (std::size_t c = 0; c < topology.components; ++c) {
    std::vector<VertexIndex> waiting = {mesh.triangles[topology.component[c].first_face][0]};
    seen[waiting.front()] = true;
    for (std::size_t next = 0; next < waiting.size(); ++next) {
      const VertexIndex v = waiting[next];
      for (const VertexIndex u : neighbours[v]) {
        const Image there = image[v] + mesh.space.image(mesh.points[v], mesh.points[u]);
        if (seen[u]) {
          result.translations[c].add(there - image[u]);
          continue;
        }
        seen[u] = true;
        image[u] = there;
        waiting.push_back(u);
      }
    }
  }
  return result;
}

std::vector<int> wrapping_ranks(const TriangleMesh& mesh, const MeshTopology& topology) {
  std::vector<int> ranks;
  for (const Translations& translations : wrapping(mesh, topology).translations)
    ranks.push_back(translations.rank());
  return ranks;
}

TriangleMesh repeated(const TriangleMesh& mesh, const std::array<int, 3>& cells) {
  TriangleMesh result;
  if (!mesh.space.periodic()) return mesh;
  Cell cell = *mesh.space.cell();
  const auto number = [&](const Image& at) {
    const auto inside = [&](std::size_t d) { return ((at[d] % cells[d]) + cells[d]) % cells[d]; };
    return static_cast<std::size_t>((inside(2) * cells[1] + inside(1)) * cells[0] + inside(0));
  };
  for (int k = 0; k < cells[2]; ++k)
    for (int j = 0; j < cells[1]; ++j)
      for (int i = 0; i < cells[0]; ++i) {
        const Vec3 shift = image_shift(cell, {i, j, k});
        for (const Vec3& p : mesh.points) result.points.push_back(p + shift);
        for (const Triangle& t : mesh.triangles) {
          Triangle copy;
          for (std::size_t c = 0; c < 3; ++c) {
            const Image at = Image{i, j, k} + mesh.space.image(mesh.points[t[0]], mesh.points[t[c]]);
            copy[c] = static_cast<VertexIndex>(number(at) * mesh.points.size() + t[c]);
          }
          result.triangles.push_back(copy);
        }
      }
  for (int d = 0; d < 3; ++d) cell.vectors.col(d) *= cells[static_cast<std::size_t>(d)];
  result.space = Space(cell);
  return result;
}

void deform(TriangleMesh& mesh, const Mat3& deformation) {
  for (Vec3& p : mesh.points) p = deformation * p;
  mesh.space = mesh.space.strained(deformation);
}

Unfolded unfolded(const TriangleMesh& mesh) {
  Unfolded result;
  if (!mesh.space.periodic()) {
    result.mesh = mesh;
    result.source.resize(mesh.points.size());
    std::iota(result.source.begin(), result.source.end(), 0u);
    return result;
  }
  std::map<std::pair<VertexIndex, Image>, VertexIndex> index;
  const auto vertex = [&](VertexIndex v, const Vec3& place) {
    // place - point is a lattice vector: the nearest image of the point to the place is the place itself.
    const Image image = mesh.space.image(place, mesh.points[v]);
    const auto [entry, added] = index.try_emplace({v, image}, static_cast<VertexIndex>(result.source.size()));
    if (added) {
      result.source.push_back(v);
      result.mesh.points.push_back(place);
    }
    return entry->second;
  };
  for (const Triangle& t : mesh.triangles) {
    const std::array<Vec3, 3> corners = corners_of(mesh, t);
    const Vec3 centre = (corners[0] + corners[1] + corners[2]) / 3;
    const Vec3 shift = mesh.space.wrapped(centre) - centre;
    Triangle unfolded_triangle;
    for (std::size_t k = 0; k < 3; ++k) unfolded_triangle[k] = vertex(t[k], corners[k] + shift);
    result.mesh.triangles.push_back(unfolded_triangle);
  }
  part_fans(result);
  return result;
}

}  // namespace nanocarbon::mesh
