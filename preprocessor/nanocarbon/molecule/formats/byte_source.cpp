// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/molecule/formats/byte_source.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <cerrno>
#include <climits>
#include <cstring>
#include <memory>

#include "nanocarbon/core/error.h"

namespace nanocarbon::molecule {
namespace {

[[noreturn]] void unreadable(const std::string& name, const std::string& reason) {
  throw UserError(Failure::unreadable, fmt::format("{}: cannot be read: {}", name, reason));
}

//! A file by zlib, which passes through what is not packed.
class PackedFile {
 public:
  PackedFile(int descriptor, std::string name) : name_(std::move(name)) {
    file_ = gzdopen(descriptor, "rb");
    if (file_ == nullptr) {
      ::close(descriptor);
      throw std::bad_alloc();
    }
    gzbuffer(file_, 1u << 18);
  }
  ~PackedFile() { gzclose_r(file_); }
  PackedFile(const PackedFile&) = delete;
  PackedFile& operator=(const PackedFile&) = delete;

  std::size_t read(char* to, std::size_t most) {
    errno = 0;
    const int count = gzread(file_, to, static_cast<unsigned>(std::min<std::size_t>(most, INT_MAX)));
    int code = Z_OK;
    const char* reason = gzerror(file_, &code);
    if (count < 0 && code == Z_ERRNO) unreadable(name_, std::strerror(errno));
    if (count < 0)
      throw UserError(Failure::malformed, fmt::format("{}: the gzip file is damaged: {}", name_, reason));
    if (count == 0 && code == Z_BUF_ERROR)
      throw UserError(Failure::malformed,
                      fmt::format("{}: the gzip file is truncated; copy it again", name_));
    return static_cast<std::size_t>(count);
  }

 private:
  std::string name_;
  gzFile file_;
};

}  // namespace

std::string shown_name(const std::filesystem::path& path) {
  return path == "-" ? "standard input" : path.string();
}

ByteSource open_bytes(const std::filesystem::path& path) {
  const std::string name = shown_name(path);
  std::error_code ignored;
  const bool input = path == "-";
  if (!input && std::filesystem::is_directory(path, ignored)) unreadable(name, "it is a directory");
  errno = 0;
  const int descriptor = input ? ::dup(STDIN_FILENO) : ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) unreadable(name, std::strerror(errno));
  const auto file = std::make_shared<PackedFile>(descriptor, name);
  return [file](char* to, std::size_t most) { return file->read(to, most); };
}

ByteSource bytes_of(std::string_view contents) {
  return [contents](char* to, std::size_t most) mutable {
    const std::size_t count = contents.copy(to, most);
    contents.remove_prefix(count);
    return count;
  };
}

}  // namespace nanocarbon::molecule
