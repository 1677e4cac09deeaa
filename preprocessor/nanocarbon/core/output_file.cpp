// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/core/output_file.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>

#include "nanocarbon/core/error.h"
#include "nanocarbon/core/held_signals.h"

namespace nanocarbon {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path, const std::string& reason) {
  throw UserError(Failure::unwritable, fmt::format("{}: cannot be written: {}", path.string(), reason));
}

// Writes to a place, naming another one where that fails.
void write_to(const fs::path& place, const fs::path& path, const std::function<void(std::ostream&)>& write) {
  errno = 0;
  std::ofstream stream(place, std::ios::binary);
  if (!stream) fail(path, std::strerror(errno));
  stream.exceptions(std::ios::badbit | std::ios::failbit);
  try {
    write(stream);
    stream.close();
  } catch (const std::ios_base::failure&) {
    fail(path, errno ? std::strerror(errno) : "write error");
  }
}

}  // namespace

OutputFiles::OutputFiles() = default;

OutputFiles::~OutputFiles() {
  std::error_code ignored;
  for (const Pending& file : pending_) fs::remove(file.temporary, ignored);
}

void OutputFiles::add(const fs::path& path, const std::function<void(std::ostream&)>& write) {
  std::error_code ignored;
  const auto status = fs::status(path, ignored);
  if (fs::is_directory(status)) fail(path, "it is a directory");
  if (fs::exists(status) && !fs::is_regular_file(status)) return write_to(path, path, write);
  if (!held_) held_ = std::make_unique<HeldSignals>();
  // A symbolic link stays one: the file that it leads to is replaced.
  const fs::path target = fs::is_symlink(path, ignored) ? fs::weakly_canonical(path) : path;
  pending_.push_back({fmt::format("{}.{}.part", target.string(), getpid()), target});
  write_to(pending_.back().temporary, path, write);
}

void OutputFiles::publish() {
  while (!pending_.empty()) {
    std::error_code error;
    fs::rename(pending_.front().temporary, pending_.front().path, error);
    if (error) fail(pending_.front().path, error.message());
    pending_.erase(pending_.begin());
  }
  held_.reset();
}

void write_file(const fs::path& path, const std::function<void(std::ostream&)>& write) {
  OutputFiles files;
  files.add(path, write);
  files.publish();
}

}  // namespace nanocarbon
