// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/grids/read_mrc.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "nanocarbon/core/error.h"
#include "nanocarbon/mesh/parsing/byte_order.h"

namespace nanocarbon::mesh {
namespace {

constexpr std::size_t header_bytes = 1024;

// Of IEEE 754's half precision.
float half(std::uint16_t bits) {
  const int exponent = bits >> 10 & 31, fraction = bits & 1023;
  double value = exponent == 31 ? (fraction ? std::numeric_limits<double>::quiet_NaN() : HUGE_VAL)
                 : exponent     ? std::ldexp(1024 + fraction, exponent - 25)
                                : std::ldexp(fraction, -24);
  return static_cast<float>(bits >> 15 ? -value : value);
}

class Reader {
 public:
  Reader(std::string_view bytes, const std::string& file) : bytes_(bytes), file_(file) {
    if (bytes.size() < header_bytes) fail(bytes.size(), "the file ends within the header of a map");
    // The stamp of the machine; where a program left it out, the order in which the mode is a small number.
    const auto stamp = static_cast<unsigned char>(bytes[212]);
    order_ = stamp == 0x11                                                               ? ByteOrder::big
             : stamp == 0x44 || load<std::uint32_t>(&bytes[12], ByteOrder::little) < 128 ? ByteOrder::little
                                                                                         : ByteOrder::big;
  }

  ScalarField read() {
    ScalarField field;
    field.unit = "Angstrom";
    const std::array<int, 3> axis = axes();
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int32_t count = integer(4 * k);
      if (count < 1) fail(4 * k, fmt::format("the map has {} values along an edge", count));
      stored_[k] = static_cast<std::size_t>(count);
      field.counts[static_cast<std::size_t>(axis[k])] = stored_[k];
    }
    set_cell(field);
    const std::size_t size = require_grid(field, file_);
    const std::int32_t mode = integer(12), extended = integer(92);
    const std::size_t each = mode == 0 ? 1 : mode == 2 ? 4 : mode == 1 || mode == 6 || mode == 12 ? 2 : 0;
    if (each == 0)
      fail(12, fmt::format("the map is of mode {}; modes 0, 1, 2, 6 and 12 are read: save it in one of these",
                           mode));
    if (extended < 0 || static_cast<std::size_t>(extended) > bytes_.size() - header_bytes)
      fail(92, "the extended header is longer than the file");
    const std::size_t begin = header_bytes + static_cast<std::size_t>(extended);
    if ((bytes_.size() - begin) / each < size)
      fail(bytes_.size(),
           fmt::format("the file ends after {} of {} values", (bytes_.size() - begin) / each, size));
    take_values(field, begin, each, mode, axis);
    require_finite(field, file_);
    const std::size_t left = bytes_.size() - begin - size * each;
    if (left > 0)
      field.notes.push_back(fmt::format("skipped {} bytes after the last value of the field", left));
    return field;
  }

 private:
  std::int32_t integer(std::size_t byte) const { return load<std::int32_t>(&bytes_[byte], order_); }
  double real(std::size_t byte) const { return load<float>(&bytes_[byte], order_); }

  // Which of the cell's edges the columns, rows and sections of the file run along.
  std::array<int, 3> axes() const {
    std::array<std::int32_t, 3> axis = {integer(64), integer(68), integer(72)};
    if (axis == std::array{0, 0, 0}) return {0, 1, 2};
    std::array<std::int32_t, 3> sorted = axis;
    std::sort(sorted.begin(), sorted.end());
    if (sorted != std::array{1, 2, 3})
      fail(64, fmt::format("the axes of the map are {}, {} and {}", axis[0], axis[1], axis[2]));
    for (std::int32_t& a : axis) --a;
    return axis;
  }

  void set_cell(ScalarField& field) const {
    Vec3 length, angle;
    std::array<double, 3> samples{};
    for (std::size_t d = 0; d < 3; ++d) {
      const std::int32_t count = integer(28 + 4 * d);
      field.cell[d] = count > 0 ? static_cast<std::size_t>(count) : field.counts[d];
      samples[d] = static_cast<double>(field.cell[d]);
      length[static_cast<int>(d)] = real(40 + 4 * d);
      angle[static_cast<int>(d)] = real(52 + 4 * d);
    }
    if (length == Vec3::Zero()) {
      length = Vec3(samples[0], samples[1], samples[2]);
      field.unit = "";
      field.notes.push_back("the map has no cell: its unit of length is the step of its grid");
    }
    for (int d = 0; d < 3; ++d) {
      if (angle[d] == 0.0) angle[d] = 90.0;
      if (!(length[d] > 0.0 && length[d] < 1e20))
        fail(40, fmt::format("the cell has the lengths {}, {} and {}", length[0], length[1], length[2]));
      if (!(angle[d] > 0.0 && angle[d] < 180.0))
        fail(52, fmt::format("the cell has the angles {}, {} and {}", angle[0], angle[1], angle[2]));
    }
    const auto cosine = [&](int d) {
      return angle[d] == 90.0 ? 0.0 : std::cos(angle[d] * std::numbers::pi / 180);
    };
    const double sine = std::sqrt(1 - cosine(2) * cosine(2));
    const double y = (cosine(0) - cosine(1) * cosine(2)) / sine;
    Mat3 edges;  // a along x, b in the xy plane
    edges << 1, cosine(2), cosine(1), 0, sine, y, 0, 0,
        std::sqrt(std::max(1 - cosine(1) * cosine(1) - y * y, 0.0));
    Vec3 start;
    for (int d = 0; d < 3; ++d)
      field.steps.col(d) = edges.col(d) * length[d] / samples[static_cast<std::size_t>(d)];
    const std::array<int, 3> axis = axes();
    for (std::size_t k = 0; k < 3; ++k) start[axis[k]] = integer(16 + 4 * k);
    const Vec3 origin(real(196), real(200), real(204));
    field.origin = origin.allFinite() && origin != Vec3::Zero() ? origin : Vec3(field.steps * start);
  }

  void take_values(ScalarField& field, std::size_t begin, std::size_t each, int mode,
                   const std::array<int, 3>& axis) const {
    field.values.resize(field.counts[0] * field.counts[1] * field.counts[2]);
    std::array<std::size_t, 3> at{};
    auto& [column, row, section] = at;
    const char* from = bytes_.data() + begin;
    for (section = 0; section < stored_[2]; ++section)
      for (row = 0; row < stored_[1]; ++row)
        for (column = 0; column < stored_[0]; ++column, from += each) {
          std::array<std::size_t, 3> place{};
          for (std::size_t k = 0; k < 3; ++k) place[static_cast<std::size_t>(axis[k])] = at[k];
          field.values[place[0] + field.counts[0] * (place[1] + field.counts[1] * place[2])] =
              value(from, mode);
        }
  }

  float value(const char* from, int mode) const {
    switch (mode) {
      case 0:
        return load<std::int8_t>(from, order_);
      case 1:
        return load<std::int16_t>(from, order_);
      case 6:
        return load<std::uint16_t>(from, order_);
      case 12:
        return half(load<std::uint16_t>(from, order_));
      default:
        return load<float>(from, order_);
    }
  }

  [[noreturn]] void fail(std::size_t byte, const std::string& what) const {
    throw UserError(Failure::malformed,
                    fmt::format("{}: byte {}: {}; repair the file or export it again", file_, byte, what));
  }

  std::string_view bytes_;
  const std::string& file_;
  ByteOrder order_ = ByteOrder::little;
  std::array<std::size_t, 3> stored_{};
};

}  // namespace

ScalarField read_mrc(std::string_view bytes, const std::string& file) { return Reader(bytes, file).read(); }

bool begins_like_mrc(std::string_view bytes) {
  return bytes.size() >= header_bytes && bytes.substr(208, 3) == "MAP";
}

}  // namespace nanocarbon::mesh
