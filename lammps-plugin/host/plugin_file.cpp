// SPDX-License-Identifier: GPL-2.0-or-later
#include "host/plugin_file.h"

#include <cstdlib>
#include <sstream>
#include <system_error>

namespace nanocarbon {

namespace fs = std::filesystem;

PluginFile find_plugin_file(const std::string& name) {
  PluginFile result;
  const fs::path given = name;
  result.looked.push_back(given);
  if (!given.has_parent_path()) {
    if (const char* folders = std::getenv("LAMMPS_PLUGIN_PATH")) {
      std::istringstream list(folders);
      for (std::string folder; std::getline(list, folder, ':');)
        if (!folder.empty()) result.looked.push_back(fs::path(folder) / given);
    }
    std::error_code no_proc;
    const fs::path program = fs::read_symlink("/proc/self/exe", no_proc);
    if (!no_proc) {
      result.looked.push_back(program.parent_path() / given);
      result.looked.push_back(
          (program.parent_path() / NANOCARBON_PLUGINS_FROM_BIN / given).lexically_normal());
    }
  }
  for (const fs::path& path : result.looked) {
    std::error_code unreadable;
    if (fs::is_regular_file(path, unreadable)) {
      result.path = fs::absolute(path);  // so that dlopen does not search for a bare name elsewhere
      break;
    }
  }
  return result;
}

}  // namespace nanocarbon
