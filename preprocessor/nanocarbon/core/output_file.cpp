#include "nanocarbon/core/output_file.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>

#include "nanocarbon/core/error.h"

namespace nanocarbon {
namespace {

// Removes the temporary file unless the rename has happened.
class Temporary {
 public:
  explicit Temporary(std::filesystem::path path) : path_(std::move(path)) {}
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;
  ~Temporary() {
    if (!kept_) {
      std::error_code ignored;
      std::filesystem::remove(path_, ignored);
    }
  }
  const std::filesystem::path& path() const { return path_; }
  void keep() { kept_ = true; }

 private:
  std::filesystem::path path_;
  bool kept_ = false;
};

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& reason) {
  throw UserError(Failure::unwritable, fmt::format("{}: cannot be written: {}", path.string(), reason));
}

}  // namespace

void write_file(const std::filesystem::path& path, const std::function<void(std::ostream&)>& write) {
  // A device or pipe (/dev/stdout) cannot be replaced by a rename: written in place.
  std::error_code status_error;
  const auto status = std::filesystem::status(path, status_error);
  const bool in_place = std::filesystem::exists(status) && !std::filesystem::is_regular_file(status);
  if (std::filesystem::is_directory(status)) fail(path, "it is a directory");

  Temporary temporary(in_place ? path
                               : std::filesystem::path(fmt::format("{}.{}.part", path.string(), getpid())));
  if (in_place) temporary.keep();
  errno = 0;
  std::ofstream stream(temporary.path(), std::ios::binary);
  if (!stream) fail(path, std::strerror(errno));
  stream.exceptions(std::ios::badbit | std::ios::failbit);
  try {
    write(stream);
    stream.close();
  } catch (const std::ios_base::failure&) {
    fail(path, errno ? std::strerror(errno) : "write error");
  }
  if (in_place) return;
  std::error_code error;
  std::filesystem::rename(temporary.path(), path, error);
  if (error) fail(path, error.message());
  temporary.keep();
}

}  // namespace nanocarbon
