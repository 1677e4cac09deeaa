// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/formats/read_off.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "nanocarbon/core/error.h"
#include "nanocarbon/core/text_numbers.h"
#include "nanocarbon/mesh/formats/read_binary_off.h"
#include "nanocarbon/mesh/parsing/text_scanner.h"
#include "nanocarbon/mesh/parsing/value_cursor.h"

namespace nanocarbon::mesh {
namespace {

struct Counts {
  std::uint64_t vertices;
  std::uint64_t faces;
  bool plain;  // nothing but coordinates belongs to a vertex
};

// Length of the header word that the text begins with, 0 for none. Geomview's order is [ST][C][N][4][n]OFF, MeshLab's
// [N][C][ST]OFF.
std::size_t header_length(std::string_view text) {
  if (text.starts_with("off") && (text.size() == 3 || text.find_first_of(" \t\r\n") == 3)) return 3;
  std::size_t length = 0;
  for (bool found = true; found && length < 7;) {
    found = false;
    for (const std::string_view part : {"ST", "C", "N", "4", "n"})
      if (text.substr(length).starts_with(part)) {
        length += part.size();
        found = true;
      }
  }
  return text.substr(length).starts_with("OFF") ? length + 3 : 0;
}

// The header word, empty where there is none; the scanner goes behind it.
std::string_view read_header(TextScanner& scanner) {
  if (!scanner.next_line()) scanner.fail("the file is empty", "give a mesh file");
  const std::string_view header = scanner.rest().substr(0, header_length(scanner.rest()));
  if (header.find_first_of("4n") != header.npos)
    scanner.fail("points in four or n dimensions are not supported", "export a three-dimensional OFF file");
  // "OFF490 518 0": the ModelNet collection has files without a line end after the header.
  if (!header.empty()) scanner.give_back(scanner.word().size() - header.size());
  return header;
}

// Numbers of a vertex: its place, and, as the header says, a normal, a colour and a place in a texture.
std::size_t reals_of_a_vertex(std::string_view header) {
  const std::string_view parts = header.substr(0, header.size() - 3);
  return std::size_t{3} + (parts.find('N') != parts.npos ? 3 : 0) + (parts.find('C') != parts.npos ? 4 : 0) +
         (parts.find("ST") != parts.npos ? 2 : 0);
}

Counts read_counts(TextScanner& scanner, std::string_view header) {
  if (!header.empty() && scanner.at_line_end() && !scanner.next_line())
    scanner.fail("the file ends before the counts");
  const std::uint64_t vertices = scanner.count("number of vertices");
  if (TextScanner next = scanner; scanner.at_line_end() && next.next_line()) scanner = std::move(next);
  return {vertices, scanner.count("number of faces"), header.size() <= 3};
}

void read_vertex(TextScanner& scanner, PolygonSoup& soup) {
  const double x = scanner.coordinate("x coordinate");
  const double y = scanner.coordinate("y coordinate");
  const double z = scanner.coordinate("z coordinate");
  soup.points.emplace_back(x, y, z);
}

// A face may be wrapped over lines. Then nothing but corners may stand on the lines that follow, so that a
// face with a corner too few is not made whole by the next one's numbers.
void read_face(TextScanner& scanner, PolygonSoup& soup) {
  const std::uint64_t corners = scanner.count("number of corners");
  if (corners < 3)
    scanner.fail(fmt::format("face {} has {} corners", soup.faces(), corners), "remove this face");
  bool wrapped = false;
  for (std::uint64_t i = 0; i < corners; ++i) {
    if (scanner.at_line_end()) {
      TextScanner next = scanner;
      if (!next.next_line())
        scanner.fail(fmt::format("face {} lists {} of {} corners", soup.faces(), i, corners));
      scanner = std::move(next);
      wrapped = true;
    }
    const std::uint64_t vertex = scanner.count("vertex number");
    if (vertex >= soup.points.size())
      scanner.fail(fmt::format("face {} uses vertex {}, but there are {} vertices, counted from 0",
                               soup.faces(), vertex, soup.points.size()));
    soup.corners.push_back(static_cast<VertexIndex>(vertex));
  }
  if (wrapped && !scanner.at_line_end())
    scanner.fail(
        fmt::format("face {} has fewer than {} corners on its own line, and more numbers follow than "
                    "it lacks",
                    soup.faces(), corners));
  soup.close_face();
}

PolygonSoup read_lines(TextScanner scanner, const Counts& counts, std::size_t bytes) {
  // Promised counts are only a hint for memory: a vertex takes six bytes ("0 0 0\n") or more, a face eight.
  PolygonSoup soup;
  soup.points.reserve(std::min<std::uint64_t>(counts.vertices, bytes / 6));
  soup.offsets.reserve(std::min<std::uint64_t>(counts.faces, bytes / 8) + 1);
  soup.corners.reserve(3 * std::min<std::uint64_t>(counts.faces, bytes / 8));
  while (soup.points.size() < counts.vertices) {
    if (!scanner.next_line())
      scanner.fail(fmt::format("the file ends after {} of {} vertices", soup.points.size(), counts.vertices));
    read_vertex(scanner, soup);
  }
  while (soup.faces() < counts.faces) {
    if (!scanner.next_line())
      scanner.fail(fmt::format("the file ends after {} of {} faces", soup.faces(), counts.faces));
    read_face(scanner, soup);
  }
  if (scanner.next_line())
    soup.notes.push_back(
        fmt::format("skipped everything after the last face, from line {} on", scanner.line_number()));
  return soup;
}

// For Geomview lines mean nothing: the numbers in a row, if they are all there are, with or without one of edges.
std::optional<PolygonSoup> read_numbers(TextScanner scanner, const Counts& counts, std::size_t bytes) {
  if (!counts.plain || counts.vertices > bytes || counts.faces > bytes) return std::nullopt;
  std::vector<double> numbers;
  do {
    for (std::string_view word = scanner.word(); !word.empty(); word = scanner.word()) {
      double value = 0.0;
      if (read_real(word, value) != NumberToken::number || coordinate_fault(value)) return std::nullopt;
      numbers.push_back(value);
    }
  } while (scanner.next_line());
  for (const std::size_t first : {std::size_t{1}, std::size_t{0}}) {
    std::size_t at = first + 3 * counts.vertices;
    if (at > numbers.size()) continue;
    PolygonSoup soup;
    for (std::size_t k = first; k < at; k += 3)
      soup.points.emplace_back(numbers[k], numbers[k + 1], numbers[k + 2]);
    bool good = true;
    const auto whole = [&](double from, double below) {
      good = good && at < numbers.size() && numbers[at] >= from && numbers[at] < below &&
             numbers[at] == std::floor(numbers[at]);
      return good ? static_cast<std::size_t>(numbers[at++]) : 0;
    };
    while (good && soup.faces() < counts.faces) {
      const std::size_t corners = whole(3.0, static_cast<double>(bytes));
      for (std::size_t k = 0; k < corners && good; ++k)
        soup.corners.push_back(static_cast<VertexIndex>(whole(0.0, static_cast<double>(counts.vertices))));
      soup.close_face();
    }
    if (good && at == numbers.size()) return soup;
  }
  return std::nullopt;
}

}  // namespace

bool begins_like_off(std::string_view line) { return header_length(line) != 0; }

PolygonSoup read_off(std::string_view text, const std::string& file) {
  TextScanner scanner(text, file, {});
  const std::string_view header = read_header(scanner);
  if (TextScanner after = scanner; !header.empty() && after.word() == "BINARY") {
    ValueCursor cursor(text, file);
    cursor.go_to(after.next_line_offset());
    return read_binary_off(cursor, reals_of_a_vertex(header));
  }
  const Counts counts = read_counts(scanner, header);
  try {
    return read_lines(scanner, counts, text.size());
  } catch (const UserError&) {
    if (std::optional<PolygonSoup> soup = read_numbers(scanner, counts, text.size())) return std::move(*soup);
    throw;
  }
}

}  // namespace nanocarbon::mesh
