// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/grids/read_msh.h"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>
#include <utility>
#include <vector>

#include "nanocarbon/core/text_numbers.h"
#include "nanocarbon/mesh/grids/msh_elements.h"
#include "nanocarbon/mesh/parsing/byte_order.h"
#include "nanocarbon/mesh/parsing/text_scanner.h"
#include "nanocarbon/mesh/parsing/value_cursor.h"

namespace nanocarbon::mesh {
namespace {

constexpr std::string_view magic = "$MeshFormat";

class Reader {
 public:
  Reader(std::string_view contents, const std::string& file) : contents_(contents), cursor_(contents, file) {}

  PolygonSoup read() {
    read_format();
    bool nodes = false, elements = false;
    for (std::string_view section = next_section(); !section.empty(); section = next_section()) {
      // What follows is binary at once, but for the counts of version 2.
      if (version_ >= 4) cursor_.line();
      if (section == "$Nodes") {
        version_ < 4 ? read_nodes_2() : read_nodes_4();
        nodes = true;
      } else if (section == "$Elements") {
        if (!nodes) cursor_.fail("$Elements stand before $Nodes");
        version_ < 4 ? read_elements_2() : read_elements_4();
        elements = true;
      } else {
        skip(section);
        continue;
      }
      if (cursor_.word() != "$End" + std::string(section.substr(1)))
        cursor_.fail(fmt::format("the section {} does not end where its counts say", section));
    }
    if (!nodes || !elements) cursor_.fail("the file ends without $Nodes and $Elements");
    if (surface_.empty()) cursor_.fail("the file has neither faces nor cells that have some", "give a mesh");
    return std::move(surface_).on(std::move(points_));
  }

 private:
  void read_format() {
    if (cursor_.word() != magic) cursor_.fail(fmt::format("the file does not begin with '{}'", magic));
    const std::string_view version = cursor_.word();
    read_real(version, version_);
    if (!(version_ >= 2 && version_ < 3) && version_ != 4.1)
      cursor_.fail(fmt::format("the version of the MSH file is {}", mesh::quoted(version)),
                   "save it as version 4.1 or 2.2 (in Gmsh: Mesh.MshFileVersion = 4.1)");
    binary_ = cursor_.count("file type") == 1;
    if (cursor_.count("size of numbers") != 8)
      cursor_.fail("numbers are not of 8 bytes", "save it with Gmsh 2 or newer");
    cursor_.line();
    if (binary_) {
      const std::string_view one = cursor_.bytes(4, "number one");
      if (load<std::int32_t>(one.data(), ByteOrder::little) != 1) order_ = ByteOrder::big;
      if (load<std::int32_t>(one.data(), order_) != 1)
        cursor_.fail("there is no number one after the binary file's format");
    }
    if (cursor_.word() != "$EndMeshFormat") cursor_.fail("$EndMeshFormat is missing");
  }

  std::string_view next_section() {
    const std::string_view word = cursor_.word();
    if (!word.empty() && !word.starts_with('$'))
      cursor_.fail(fmt::format("expected a section ($...), found {}", mesh::quoted(word)));
    return word;
  }

  void skip(std::string_view section) {
    const std::string end = "$End" + std::string(section.substr(1));
    const std::size_t at = contents_.find(end, cursor_.offset());
    if (at == contents_.npos) cursor_.fail(fmt::format("{} is missing", mesh::quoted(end)));
    cursor_.go_to(at + end.size());
  }

  template <typename Number>
  Number binary(const char* what) {
    return load<Number>(cursor_.bytes(sizeof(Number), what).data(), order_);
  }
  // "int" and "size_t" of the manual.
  std::int64_t integer(const char* what) {
    return binary_ ? binary<std::int32_t>(what) : cursor_.integer(what);
  }
  std::uint64_t size(const char* what) { return binary_ ? binary<std::uint64_t>(what) : cursor_.count(what); }
  double coordinate() {
    if (!binary_) return cursor_.coordinate("coordinate");
    const double value = binary<double>("coordinate");
    if (const char* fault = coordinate_fault(value))
      cursor_.fail(fmt::format("the coordinate {} {}", value, fault));
    return value;
  }

  void add_node(std::uint64_t tag) {
    Vec3 point;
    for (double& x : point) x = coordinate();
    if (!index_of_.emplace(tag, static_cast<VertexIndex>(points_.size())).second)
      cursor_.fail(fmt::format("there are two nodes with the number {}", tag));
    points_.push_back(point);
  }

  VertexIndex node(std::uint64_t tag) {
    const auto found = index_of_.find(tag);
    if (found == index_of_.end())
      cursor_.fail(fmt::format("an element uses node {}, which there is not", tag));
    return found->second;
  }

  std::size_t nodes_of(std::uint64_t type) {
    const auto count = msh_nodes(type);
    if (!count)
      cursor_.fail(fmt::format("elements of Gmsh's type {} are not known", type),
                   "save the surface alone, with elements of first order (in Gmsh: Mesh.ElementOrder = 1)");
    return *count;
  }

  void read_nodes_2() {
    const std::uint64_t count = cursor_.count("number of nodes");
    if (binary_) cursor_.line();
    for (std::uint64_t i = 0; i < count; ++i)
      add_node(static_cast<std::uint64_t>(integer("number of a node")));
  }

  void read_elements_2() {
    const std::uint64_t count = cursor_.count("number of elements");
    if (binary_) cursor_.line();
    for (std::uint64_t done = 0; done < count;) {
      if (!binary_) cursor_.integer("number of an element");
      const auto type = static_cast<std::uint64_t>(integer("type of an element"));
      const std::int64_t follow = binary_ ? integer("number of elements that follow") : 1;
      const std::int64_t tags = integer("number of tags");
      if (follow < 1 || tags < 0) cursor_.fail(fmt::format("{} elements with {} tags", follow, tags));
      nodes_of(type);
      for (std::int64_t i = 0; i < follow && done < count; ++i, ++done) {
        if (binary_) integer("number of an element");
        for (std::int64_t tag = 0; tag < tags; ++tag) integer("tag of an element");
        add_element(type, [&] { return static_cast<std::uint64_t>(integer("node of an element")); });
      }
    }
  }

  void read_nodes_4() {
    const std::uint64_t blocks = size("number of blocks of nodes");
    for (int i = 0; i < 3; ++i) size("number of nodes");
    std::vector<std::uint64_t> tags;
    for (std::uint64_t block = 0; block < blocks; ++block) {
      const std::int64_t dimension = integer("dimension of a block");
      integer("number of an entity");
      const bool parametric = integer("whether a block is parametric") == 1;
      const std::uint64_t count = size("number of nodes in a block");
      tags.clear();
      for (std::uint64_t i = 0; i < count; ++i) tags.push_back(size("number of a node"));
      for (const std::uint64_t tag : tags) {
        add_node(tag);
        for (std::int64_t d = 0; parametric && d < std::min<std::int64_t>(dimension, 3); ++d) coordinate();
      }
    }
  }

  void read_elements_4() {
    const std::uint64_t blocks = size("number of blocks of elements");
    for (int i = 0; i < 3; ++i) size("number of elements");
    for (std::uint64_t block = 0; block < blocks; ++block) {
      integer("dimension of a block");
      integer("number of an entity");
      const auto type = static_cast<std::uint64_t>(integer("type of a block's elements"));
      const std::uint64_t count = size("number of elements in a block");
      nodes_of(type);
      for (std::uint64_t i = 0; i < count; ++i) {
        size("number of an element");
        add_element(type, [&] { return size("node of an element"); });
      }
    }
  }

  template <typename Next>
  void add_element(std::uint64_t type, const Next& next) {
    nodes_.clear();
    for (std::size_t i = nodes_of(type); i > 0; --i) nodes_.push_back(node(next()));
    add_msh_element(surface_, type, nodes_);
  }

  std::string_view contents_;
  ValueCursor cursor_;
  double version_ = 0.0;
  bool binary_ = false;
  ByteOrder order_ = ByteOrder::little;
  std::vector<Vec3> points_;
  std::unordered_map<std::uint64_t, VertexIndex> index_of_;  // looked up only, never walked through
  std::vector<VertexIndex> nodes_;
  GridSurface surface_;
};

}  // namespace

PolygonSoup read_msh(std::string_view contents, const std::string& file) {
  return Reader(contents, file).read();
}

bool begins_like_msh(std::string_view contents) {
  const std::size_t begin = contents.find_first_not_of(" \t\r\n");
  return begin != contents.npos && contents.substr(begin).starts_with(magic);
}

}  // namespace nanocarbon::mesh
