// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/formats/input_file.h"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fstream>

#include "nanocarbon/core/error.h"

namespace nanocarbon::mesh {
namespace {

constexpr std::uintmax_t largest_file = std::uintmax_t{4} << 30;

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& reason) {
  throw UserError(Failure::unreadable, fmt::format("{}: cannot be read: {}", path.string(), reason));
}

}  // namespace

std::string file_contents(const std::filesystem::path& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) fail(path, error ? error.message() : "there is no such file");
  if (std::filesystem::is_directory(status)) fail(path, "it is a directory; name a mesh file in it");
  const bool pipe = std::filesystem::is_fifo(status);
  if (!std::filesystem::is_regular_file(status) && !pipe) fail(path, "it is not a regular file");

  errno = 0;
  std::ifstream stream(path, std::ios::binary);
  if (!stream) fail(path, errno ? std::strerror(errno) : "it cannot be opened");
  std::string contents;
  if (!pipe) {
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    if (error) fail(path, error.message());
    if (size > largest_file) fail(path, "it is larger than 4 GiB");
    contents.reserve(size + 1);
  }
  std::array<char, 65536> block;
  while (stream.read(block.data(), block.size()) || stream.gcount() > 0) {
    contents.append(block.data(), static_cast<std::size_t>(stream.gcount()));
    if (contents.size() > largest_file) fail(path, "it is larger than 4 GiB");
  }
  if (stream.bad()) fail(path, errno ? std::strerror(errno) : "read error");
  return contents;
}

}  // namespace nanocarbon::mesh
