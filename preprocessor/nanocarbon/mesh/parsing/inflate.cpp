// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/parsing/inflate.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <limits>

namespace nanocarbon::mesh {
namespace {

// A stream that is ended whatever happens.
class Inflater {
 public:
  explicit Inflater(Packing packing) {
    const int bits = packing == Packing::bare ? -15 : packing == Packing::zlib ? 15 : 15 + 16;
    ready_ = inflateInit2(&stream_, bits) == Z_OK;
  }
  ~Inflater() { inflateEnd(&stream_); }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;

  // Appends one stream. \return the bytes that it took, or nothing where it is not whole or too much comes of it
  std::optional<std::size_t> append(std::string_view packed, std::size_t most, std::string& to) {
    if (!ready_) return std::nullopt;
    std::array<char, 65536> block;
    std::size_t taken = 0;
    while (true) {
      if (stream_.avail_in == 0) {
        const std::size_t more =
            std::min<std::size_t>(packed.size() - taken, std::numeric_limits<uInt>::max());
        stream_.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data() + taken));
        stream_.avail_in = static_cast<uInt>(more);
        taken += more;
      }
      stream_.next_out = reinterpret_cast<Bytef*>(block.data());
      stream_.avail_out = static_cast<uInt>(block.size());
      const int status = inflate(&stream_, Z_NO_FLUSH);
      const std::size_t got = block.size() - stream_.avail_out;
      if (got > most - to.size()) return std::nullopt;
      to.append(block.data(), got);
      if (status == Z_STREAM_END) return taken - stream_.avail_in;
      if (status != Z_OK || (got == 0 && stream_.avail_in == 0 && taken == packed.size()))
        return std::nullopt;
    }
  }

 private:
  z_stream stream_{};
  bool ready_ = false;
};

}  // namespace

std::optional<std::string> inflated(std::string_view packed, Packing packing, std::size_t most) {
  std::string result;
  do {
    const std::optional<std::size_t> taken = Inflater(packing).append(packed, most, result);
    if (!taken) return std::nullopt;
    packed.remove_prefix(*taken);
  } while (packing == Packing::gzip && packed.starts_with("\x1f\x8b"));
  return result;
}

std::uint32_t crc32_of(std::string_view bytes) {
  uLong sum = crc32(0, nullptr, 0);
  while (!bytes.empty()) {
    const std::size_t part = std::min<std::size_t>(bytes.size(), 1u << 30);
    sum = crc32(sum, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uInt>(part));
    bytes.remove_prefix(part);
  }
  return static_cast<std::uint32_t>(sum);
}

}  // namespace nanocarbon::mesh
