// SPDX-License-Identifier: GPL-2.0-or-later
// write_seeds FOLDER: the seeds as files, those of each fuzzer in a folder of its own; run.sh calls it.
#include <filesystem>
#include <fstream>
#include <string>

#include "fuzz/seeds.h"

namespace {

using nanocarbon::test::Seed;

void write(const std::filesystem::path& folder, const std::string& name, const std::string& contents) {
  std::filesystem::create_directories(folder);
  std::ofstream(folder / name, std::ios::binary) << contents;
}

std::string format_of(const Seed& seed) {
  const std::string extension = std::filesystem::path(seed.file).extension().string();
  return extension.empty() ? "poscar" : extension.substr(1);
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) return 2;
  const std::filesystem::path folder = arguments[1];
  int number = 0;
  for (const Seed& seed : nanocarbon::test::mesh_seeds())
    write(folder / ("mesh_" + format_of(seed)), std::to_string(number++) + seed.file, seed.contents);
  // The last byte chooses the options: the default here.
  for (const Seed& seed : nanocarbon::test::molecule_seeds()) {
    write(folder / ("molecule_" + format_of(seed)), seed.file, seed.contents + '\0');
    write(folder / "molecule_packed", seed.file, seed.contents);
  }
}
