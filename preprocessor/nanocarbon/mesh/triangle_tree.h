// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "nanocarbon/mesh/measures.h"
#include "nanocarbon/mesh/triangle_mesh.h"

namespace nanocarbon::mesh {

//! \brief A tree of axis-aligned boxes over the triangles of a mesh, for searches near a place.
//! \details Binary, split by the surface area heuristic on 16 bins (Wald 2007), at most 96 levels deep. The
//! root is node 0; the two children of an inner node stand side by side.
struct TriangleTree {
  struct Node {
    BoundingBox box;
    std::uint32_t first;  //!< inner node: its first child; leaf: its first place in `triangles`
    std::uint32_t count;  //!< triangles of a leaf, 0 for an inner node
    bool leaf() const { return count > 0; }
  };
  static constexpr std::size_t deepest = 96;

  std::vector<Node> nodes;  //!< empty for a mesh without triangles
  std::vector<std::uint32_t> triangles;
};

//! O(n log n) in triangles. Points must be finite. In a cell each triangle is in one of its places, that of
//! corners_in_cell(): searches visit the tree from the images of where they look (Space::for_images()).
TriangleTree triangle_tree(const TriangleMesh& mesh);

//! \brief Visits every triangle in a leaf whose path is acceptable.
//! \param enter decides whether what lies in a box is of interest
//! \param visit gets the number of a triangle
template <typename Enter, typename Visit>
void visit_triangles(const TriangleTree& tree, const Enter& enter, const Visit& visit) {
  if (tree.nodes.empty()) return;
  std::array<std::uint32_t, TriangleTree::deepest + 1> stack;
  std::size_t height = 0;
  stack[height++] = 0;
  while (height > 0) {
    const TriangleTree::Node& node = tree.nodes[stack[--height]];
    if (!enter(node.box)) continue;
    if (node.leaf()) {
      for (std::uint32_t i = node.first; i < node.first + node.count; ++i) visit(tree.triangles[i]);
    } else {
      stack[height++] = node.first;
      stack[height++] = node.first + 1;
    }
  }
}

}  // namespace nanocarbon::mesh
