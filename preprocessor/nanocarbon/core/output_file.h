#pragma once

#include <filesystem>
#include <functional>
#include <ostream>

namespace nanocarbon {

//! \brief Writes a file whole or not at all: to a temporary file beside it, then a rename.
//! \details Several outputs of one run: write them one after the other as soon as all their contents are
//! known. \param write puts the contents on the stream, which is binary and throws on failure \throw
//! UserError (unwritable) naming the path and the system's reason; no partial file is left behind. Whatever
//! write throws passes through, and leaves no file either.
void write_file(const std::filesystem::path& path, const std::function<void(std::ostream&)>& write);

}  // namespace nanocarbon
