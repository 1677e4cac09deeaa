// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <ostream>
#include <vector>

namespace nanocarbon {

class HeldSignals;

//! \brief The files that one run writes: all of them appear, each of them whole, or none.
//! \details Contents go to temporary files beside the places they are meant for; publish() renames those.
//! What is not published is removed again. While there are temporary files the signals that would end the
//! program (SIGINT, SIGTERM, SIGHUP) wait, so that Ctrl-C leaves none of them behind either. A path that is
//! no regular file (/dev/stdout, a pipe) cannot be renamed to: it is written in place at once.
class OutputFiles {
 public:
  OutputFiles();
  OutputFiles(const OutputFiles&) = delete;
  OutputFiles& operator=(const OutputFiles&) = delete;
  ~OutputFiles();

  //! \param write puts the contents on the stream, which is binary and throws on failure
  //! \throw UserError (unwritable) naming the path and the system's reason. Whatever write throws passes
  //! through.
  void add(const std::filesystem::path& path, const std::function<void(std::ostream&)>& write);

  //! \throw UserError (unwritable) as add()
  void publish();

 private:
  struct Pending {
    std::filesystem::path temporary, path;
  };
  std::vector<Pending> pending_;
  std::unique_ptr<HeldSignals> held_;
};

//! Writes one file whole or not at all, as OutputFiles does.
void write_file(const std::filesystem::path& path, const std::function<void(std::ostream&)>& write);

}  // namespace nanocarbon
