// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/formats/read_binary_off.h"

#include <fmt/format.h>

#include <cstdint>

#include "nanocarbon/mesh/parsing/byte_order.h"
#include "nanocarbon/mesh/parsing/text_scanner.h"

namespace nanocarbon::mesh {
namespace {

constexpr std::size_t word = 4;  // bytes

std::uint32_t whole_number(ValueCursor& cursor, ByteOrder order, const char* what) {
  return load<std::uint32_t>(cursor.bytes(word, what).data(), order);
}

// Numbers of vertices and faces, in one order of bytes.
struct Counts {
  Counts(std::string_view from, ByteOrder order)
      : vertices(load<std::uint32_t>(from.data(), order)),
        faces(load<std::uint32_t>(from.data() + word, order)) {}
  // Whether a file has room for them: no face has fewer than three corners, and how many it has and its colour.
  bool fit(std::size_t bytes, std::size_t reals) const {
    return word * (reals * vertices + 5 * faces) <= bytes;
  }
  std::uint64_t vertices, faces;
};

Vec3 read_vertex(ValueCursor& cursor, ByteOrder order, std::size_t reals, std::size_t index) {
  const char* const at = cursor.bytes(word * reals, "vertices").data();
  Vec3 point;
  for (int d = 0; d < 3; ++d) {
    point[d] = load<float>(at + word * static_cast<std::size_t>(d), order);
    if (const char* fault = coordinate_fault(point[d]))
      cursor.fail(fmt::format("a coordinate of vertex {} {}", index, fault));
  }
  return point;
}

void read_face(ValueCursor& cursor, ByteOrder order, PolygonSoup& soup) {
  const std::size_t corners = whole_number(cursor, order, "faces");
  if (corners < 3)
    cursor.fail(fmt::format("face {} has {} corners", soup.faces(), corners), "remove this face");
  const std::string_view numbers = cursor.bytes(word * corners, "faces");
  for (std::size_t k = 0; k < corners; ++k) {
    const auto vertex = load<std::uint32_t>(numbers.data() + word * k, order);
    if (vertex >= soup.points.size())
      cursor.fail(fmt::format("face {} uses vertex {}, but there are {} vertices, counted from 0",
                              soup.faces(), vertex, soup.points.size()));
    soup.corners.push_back(vertex);
  }
  soup.close_face();
  cursor.bytes(word * std::size_t{whole_number(cursor, order, "faces")}, "faces");
}

}  // namespace

PolygonSoup read_binary_off(ValueCursor cursor, std::size_t reals) {
  const std::string_view counts = cursor.bytes(3 * word, "counts");
  const Counts big(counts, ByteOrder::big), little(counts, ByteOrder::little);
  const bool is_big = big.fit(cursor.remaining(), reals) || !little.fit(cursor.remaining(), reals);
  const ByteOrder order = is_big ? ByteOrder::big : ByteOrder::little;
  const auto [vertices, faces] = is_big ? big : little;
  PolygonSoup soup;
  while (soup.points.size() < vertices)
    soup.points.push_back(read_vertex(cursor, order, reals, soup.points.size()));
  while (soup.faces() < faces) read_face(cursor, order, soup);
  if (!is_big) soup.notes.push_back("the file is in little-endian byte order, which binary OFF is not");
  if (cursor.remaining() > 0)
    soup.notes.push_back(fmt::format("skipped {} bytes after the last face", cursor.remaining()));
  return soup;
}

}  // namespace nanocarbon::mesh
