// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

namespace nanocarbon::mesh {

//! A ZIP archive in memory (APPNOTE 6.3, ZIP64 included): its files, stored or deflated.
class ZipArchive {
 public:
  //! \param bytes have to stay as long as this
  //! \param file name for messages
  //! \throw UserError (malformed) where the directory at its end is damaged or missing
  ZipArchive(std::string_view bytes, std::string file);

  bool has(const std::string& name) const { return entries_.contains(name); }
  //! \brief A file of it, unpacked; its check sum is right.
  //! \throw UserError (malformed) where there is none of that name, or it is damaged, encrypted, packed by another
  //! method or above 4 GiB
  std::string contents(const std::string& name) const;

 private:
  struct Entry {
    std::uint16_t flags = 0, method = 0;
    std::uint32_t check_sum = 0;
    std::uint64_t packed = 0, size = 0, header = 0;
  };

  void read_directory(std::uint64_t at, std::uint64_t entries);
  template <typename Number>
  Number at(std::uint64_t byte) const;
  [[noreturn]] void fail(std::uint64_t byte, const std::string& what) const;

  std::string_view bytes_;
  std::string file_;
  std::map<std::string, Entry, std::less<>> entries_;
};

}  // namespace nanocarbon::mesh
