// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/scenes/zip_archive.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "nanocarbon/core/error.h"
#include "nanocarbon/core/text_numbers.h"
#include "nanocarbon/mesh/parsing/byte_order.h"
#include "nanocarbon/mesh/parsing/inflate.h"

namespace nanocarbon::mesh {
namespace {

constexpr std::uint64_t largest_file = std::uint64_t{4} << 30;
constexpr std::uint32_t directory_end = 0x06054b50, directory_end_64 = 0x06064b50, locator_64 = 0x07064b50,
                        directory_entry = 0x02014b50, local_header = 0x04034b50;

}  // namespace

void ZipArchive::fail(std::uint64_t byte, const std::string& what) const {
  throw UserError(Failure::malformed, fmt::format("{}: byte {}: {}; repair the file or export it again",
                                                  file_, std::min<std::uint64_t>(byte, bytes_.size()), what));
}

template <typename Number>
Number ZipArchive::at(std::uint64_t byte) const {
  if (byte > bytes_.size() || bytes_.size() - byte < sizeof(Number))
    fail(byte, "the ZIP archive ends too early");
  return load<Number>(bytes_.data() + byte, ByteOrder::little);
}

ZipArchive::ZipArchive(std::string_view bytes, std::string file) : bytes_(bytes), file_(std::move(file)) {
  const std::size_t end = bytes_.rfind(std::string_view("PK\x05\x06", 4));
  if (end == bytes_.npos) fail(bytes_.size(), "the directory at the end of the ZIP archive is missing");
  std::uint64_t entries = at<std::uint16_t>(end + 10), directory = at<std::uint32_t>(end + 16);
  if (directory == 0xffffffff || entries == 0xffff)
    if (end >= 20 && at<std::uint32_t>(end - 20) == locator_64) {
      const auto end_64 = at<std::uint64_t>(end - 12);
      if (at<std::uint32_t>(end_64) != directory_end_64)
        fail(end_64, "the directory of the ZIP archive is damaged");
      entries = at<std::uint64_t>(end_64 + 32);
      directory = at<std::uint64_t>(end_64 + 48);
    }
  read_directory(directory, entries);
}

void ZipArchive::read_directory(std::uint64_t byte, std::uint64_t entries) {
  for (std::uint64_t i = 0; i < entries; ++i) {
    if (at<std::uint32_t>(byte) != directory_entry) fail(byte, "the directory of the ZIP archive is damaged");
    Entry entry;
    entry.flags = at<std::uint16_t>(byte + 8);
    entry.method = at<std::uint16_t>(byte + 10);
    entry.check_sum = at<std::uint32_t>(byte + 16);
    entry.packed = at<std::uint32_t>(byte + 20);
    entry.size = at<std::uint32_t>(byte + 24);
    const auto name = at<std::uint16_t>(byte + 28), extra = at<std::uint16_t>(byte + 30),
               comment = at<std::uint16_t>(byte + 32);
    entry.header = at<std::uint32_t>(byte + 42);
    const std::uint64_t begin = byte + 46;
    if (begin + name + extra > bytes_.size()) fail(byte, "the directory of the ZIP archive ends too early");
    // ZIP64: those of the numbers that do not fit, in this order.
    for (std::uint64_t field = begin + name; field + 4 <= begin + name + extra;) {
      const auto size = at<std::uint16_t>(field + 2);
      if (at<std::uint16_t>(field) == 1) {
        std::uint64_t value = field + 4;
        for (std::uint64_t* number : {&entry.size, &entry.packed, &entry.header})
          if (*number == 0xffffffff && value + 8 <= field + 4 + size) {
            *number = at<std::uint64_t>(value);
            value += 8;
          }
      }
      field += 4u + size;
    }
    entries_.emplace(bytes_.substr(begin, name), entry);
    byte = begin + name + extra + comment;
  }
}

std::string ZipArchive::contents(const std::string& name) const {
  const auto found = entries_.find(name);
  if (found == entries_.end()) fail(0, fmt::format("the ZIP archive has no file '{}'", shown(name)));
  const Entry& entry = found->second;
  if (entry.flags & 1) fail(entry.header, fmt::format("'{}' is encrypted", shown(name)));
  if (entry.method != 0 && entry.method != 8)
    fail(entry.header, fmt::format("'{}' is packed by method {}, not by deflate", shown(name), entry.method));
  if (at<std::uint32_t>(entry.header) != local_header)
    fail(entry.header, fmt::format("the header of '{}' is damaged", shown(name)));
  const std::uint64_t begin =
      entry.header + 30 + at<std::uint16_t>(entry.header + 26) + at<std::uint16_t>(entry.header + 28);
  if (begin > bytes_.size() || entry.packed > bytes_.size() - begin)
    fail(entry.header, fmt::format("'{}' ends too early", shown(name)));
  if (entry.size > largest_file) fail(entry.header, fmt::format("'{}' is larger than 4 GiB", shown(name)));
  const std::string_view packed = bytes_.substr(begin, entry.packed);
  const std::optional<std::string> unpacked =
      entry.method == 0 ? std::string(packed) : inflated(packed, Packing::bare, entry.size);
  if (!unpacked || unpacked->size() != entry.size || crc32_of(*unpacked) != entry.check_sum)
    fail(begin, fmt::format("'{}' is damaged", shown(name)));
  return *unpacked;
}

}  // namespace nanocarbon::mesh
