// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/formats/read_ply.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "nanocarbon/core/error.h"
#include "nanocarbon/mesh/formats/ply_header.h"
#include "nanocarbon/mesh/parsing/byte_order.h"
#include "nanocarbon/mesh/parsing/text_scanner.h"

namespace nanocarbon::mesh {
namespace {

// The two kinds of body have the same members, and read_body below is written once for both.

class TextBody {
 public:
  TextBody(std::string_view contents, const PlyHeader& header, const std::string& file)
      : scanner_(contents.substr(header.bytes), file, {'\0', false, header.lines}) {}

  void begin(const PlyElement& element, std::uint64_t index) {
    if (!scanner_.next_line())
      fail(fmt::format("the file ends after {} of {} elements '{}'", index, element.count, element.name));
    if (index == 0) extra_ = 0;
    index_ = index;
    name_ = element.name;
    wrapped_ = false;
  }
  // Lines with more values than the header promises are taken where all of an element have the same number
  // more, and each element is a line; otherwise a value that is missing would go unseen.
  void end() {
    std::size_t extra = 0;
    while (!scanner_.word().empty()) ++extra;
    if (index_ == 0 && !wrapped_) {
      extra_ = extra;
      if (extra > 0)
        notes_.push_back(
            fmt::format("skipped {} value(s) on each line of element '{}' that the header does not mention",
                        extra, name_));
    }
    if (extra > extra_ || (wrapped_ && extra > 0))
      fail("the line has more values than the element has properties");
    if (extra < extra_ && !wrapped_)
      fail(fmt::format("the line has {} value(s) more than the element has properties, earlier lines have {}",
                       extra, extra_));
  }
  double coordinate(PlyType) {
    go_on();
    return scanner_.coordinate("coordinate");
  }
  double integer(PlyType type) {
    go_on();
    if (type == PlyType::float32 || type == PlyType::float64) return scanner_.coordinate("integer");
    return static_cast<double>(scanner_.integer("integer"));
  }
  void skip(PlyType, std::uint64_t values) {
    for (std::uint64_t i = 0; i < values; ++i) {
      go_on();
      if (scanner_.word().empty()) fail("the line has fewer values than the element has properties");
    }
  }
  std::vector<std::string> notes() { return std::move(notes_); }
  bool rest_is_empty() { return !scanner_.next_line(); }
  [[noreturn]] void fail(const std::string& what) { scanner_.fail(what); }

 private:
  // To the next line, where the element's values go on there.
  void go_on() {
    if (!scanner_.at_line_end()) return;
    TextScanner next = scanner_;
    if (!next.next_line()) return;
    scanner_ = std::move(next);
    wrapped_ = true;
  }

  TextScanner scanner_;
  std::string name_;
  std::uint64_t index_ = 0;
  std::size_t extra_ = 0;  // values a line, beyond those announced
  bool wrapped_ = false;
  std::vector<std::string> notes_;
};

class BinaryBody {
 public:
  BinaryBody(std::string_view contents, const PlyHeader& header, const std::string& file)
      : contents_(contents),
        file_(file),
        order_(header.encoding == PlyEncoding::little_endian ? ByteOrder::little : ByteOrder::big),
        at_(header.bytes) {}

  void begin(const PlyElement& element, std::uint64_t index) {
    element_ = &element;
    index_ = index;
  }
  void end() {}
  std::vector<std::string> notes() const { return {}; }
  double coordinate(PlyType type) {
    const double value = integer(type);
    if (const char* fault = coordinate_fault(value))
      fail(fmt::format("a coordinate of vertex {} {}", index_, fault));
    return value;
  }
  double integer(PlyType type) {
    need(1, size_of(type));
    const char* const at = contents_.data() + at_;
    at_ += size_of(type);
    switch (type) {
      case PlyType::int8:
        return load<std::int8_t>(at, order_);
      case PlyType::uint8:
        return load<std::uint8_t>(at, order_);
      case PlyType::int16:
        return load<std::int16_t>(at, order_);
      case PlyType::uint16:
        return load<std::uint16_t>(at, order_);
      case PlyType::int32:
        return load<std::int32_t>(at, order_);
      case PlyType::uint32:
        return load<std::uint32_t>(at, order_);
      case PlyType::int64:
        return static_cast<double>(load<std::int64_t>(at, order_));
      case PlyType::uint64:
        return static_cast<double>(load<std::uint64_t>(at, order_));
      case PlyType::float32:
        return load<float>(at, order_);
      case PlyType::float64:
        break;
    }
    return load<double>(at, order_);
  }
  void skip(PlyType type, std::uint64_t values) {
    need(values, size_of(type));
    at_ += values * size_of(type);
  }
  bool rest_is_empty() const { return at_ == contents_.size(); }
  [[noreturn]] void fail(const std::string& what) const {
    throw UserError(Failure::malformed,
                    fmt::format("{}: byte {}: {}; repair the file or export it again", file_, at_, what));
  }

 private:
  void need(std::uint64_t values, std::size_t size) const {
    if (values > (contents_.size() - at_) / size)
      fail(
          fmt::format("the file ends after {} of {} elements '{}'", index_, element_->count, element_->name));
  }

  std::string_view contents_;
  std::string file_;
  ByteOrder order_;
  std::size_t at_;
  const PlyElement* element_ = nullptr;
  std::uint64_t index_ = 0;
};

template <typename Body>
std::uint64_t read_index(Body& body, PlyType type, const char* what) {
  const double value = body.integer(type);
  if (!(value >= 0.0 && value <= std::numeric_limits<VertexIndex>::max()) || value != std::floor(value))
    body.fail(fmt::format("{} {} is not possible", what, value));
  return static_cast<std::uint64_t>(value);
}

template <typename Body>
void pass_over(Body& body, const PlyProperty& property) {
  std::uint64_t values = 1;
  if (property.list_count_type) values = read_index(body, *property.list_count_type, "a list of length");
  body.skip(property.type, values);
}

template <typename Body>
void read_vertices(Body& body, const PlyElement& element, PolygonSoup& soup) {
  std::array<std::size_t, 3> xyz;
  for (std::size_t d = 0; d < 3; ++d) {
    const std::string_view name = std::string_view("xyz").substr(d, 1);
    const auto found = element.find(name, name);
    if (!found || element.properties[*found].list_count_type)
      body.fail(fmt::format("the vertices have no property {}", name));
    xyz[d] = *found;
  }
  for (std::uint64_t i = 0; i < element.count; ++i) {
    body.begin(element, i);
    Vec3 point;
    for (std::size_t p = 0; p < element.properties.size(); ++p) {
      if (p == xyz[0] || p == xyz[1] || p == xyz[2])
        point[p == xyz[0] ? 0 : p == xyz[1] ? 1 : 2] = body.coordinate(element.properties[p].type);
      else
        pass_over(body, element.properties[p]);
    }
    body.end();
    soup.points.push_back(point);
  }
}

template <typename Body>
void read_faces(Body& body, const PlyElement& element, PolygonSoup& soup) {
  const auto list = element.find("vertex_indices", "vertex_index");
  if (!list || !element.properties[*list].list_count_type) body.fail("the faces have no list vertex_indices");
  for (std::uint64_t i = 0; i < element.count; ++i) {
    body.begin(element, i);
    for (std::size_t p = 0; p < element.properties.size(); ++p) {
      const PlyProperty& property = element.properties[p];
      if (p != *list) {
        pass_over(body, property);
        continue;
      }
      const std::uint64_t corners = read_index(body, *property.list_count_type, "a list of length");
      if (corners < 3) body.fail(fmt::format("face {} has {} corners", i, corners));
      for (std::uint64_t c = 0; c < corners; ++c)
        soup.corners.push_back(static_cast<VertexIndex>(read_index(body, property.type, "vertex number")));
    }
    body.end();
    soup.close_face();
  }
}

// Each list is a strip: a triangle for each three vertices that follow each other, every second one turned. -1
// ends a strip. Triangles that repeat a vertex only join stretches of a strip.
template <typename Body>
void read_strips(Body& body, const PlyElement& element, PolygonSoup& soup) {
  const auto list = element.find("vertex_indices", "vertex_index");
  if (!list || !element.properties[*list].list_count_type)
    body.fail("the triangle strips have no list vertex_indices");
  for (std::uint64_t i = 0; i < element.count; ++i) {
    body.begin(element, i);
    for (std::size_t p = 0; p < element.properties.size(); ++p) {
      const PlyProperty& property = element.properties[p];
      if (p != *list) {
        pass_over(body, property);
        continue;
      }
      std::uint64_t left = read_index(body, *property.list_count_type, "a list of length");
      std::array<VertexIndex, 2> before = {0, 0};
      for (std::uint64_t length = 0; left > 0; --left) {
        const double number = body.integer(property.type);
        if (number == -1.0) {
          length = 0;
          continue;
        }
        if (!(number >= 0.0 && number <= std::numeric_limits<VertexIndex>::max()) ||
            number != std::floor(number))
          body.fail(fmt::format("vertex number {} is not possible", number));
        const auto vertex = static_cast<VertexIndex>(number);
        const auto [a, b] = before;
        if (length >= 2 && a != b && b != vertex && vertex != a) {
          const bool turned = length % 2 == 1;
          for (const VertexIndex v : {turned ? b : a, turned ? a : b, vertex}) soup.corners.push_back(v);
          soup.close_face();
        }
        before = {b, vertex};
        ++length;
      }
    }
    body.end();
  }
}

template <typename Body>
void skip_element(Body& body, const PlyElement& element) {
  if (element.properties.empty()) return;
  for (std::uint64_t i = 0; i < element.count; ++i) {
    body.begin(element, i);
    for (const PlyProperty& property : element.properties) pass_over(body, property);
    body.end();
  }
}

template <typename Body>
PolygonSoup read_body(Body body, const PlyHeader& header) {
  PolygonSoup soup;
  bool has_vertices = false;
  bool has_faces = false;
  for (const PlyElement& element : header.elements) {
    if (element.name == "vertex" && !std::exchange(has_vertices, true))
      read_vertices(body, element, soup);
    else if (element.name == "face" && !std::exchange(has_faces, true))
      read_faces(body, element, soup);
    else if (element.name == "tristrips")
      read_strips(body, element, soup);
    else
      skip_element(body, element);
  }
  if (!has_vertices) body.fail("the file has no element 'vertex'");
  for (std::size_t face = 0; face < soup.faces(); ++face)
    for (const VertexIndex corner : soup.face(face))
      if (corner >= soup.points.size())
        body.fail(fmt::format("face {} uses vertex {}, but there are {} vertices, counted from 0", face,
                              corner, soup.points.size()));
  soup.notes = body.notes();
  if (!body.rest_is_empty()) soup.notes.push_back("skipped everything after the last element");
  return soup;
}

}  // namespace

PolygonSoup read_ply(std::string_view contents, const std::string& file) {
  const PlyHeader header = read_ply_header(contents, file);
  return header.encoding == PlyEncoding::text ? read_body(TextBody(contents, header, file), header)
                                              : read_body(BinaryBody(contents, header, file), header);
}

}  // namespace nanocarbon::mesh
