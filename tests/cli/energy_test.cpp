// SPDX-License-Identifier: GPL-2.0-or-later
// `nanocarbon energy` as a user runs it.
#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "support/run_program.h"

namespace nanocarbon::cli {
namespace {

using nlohmann::json;
using testing::HasSubstr;

test::ProgramOutcome run(const std::string& arguments) {
  return test::run_command(NANOCARBON_PROGRAM " " + arguments);
}

std::string scratch(const std::string& name) {
  return (std::filesystem::path(testing::TempDir()) / ("nanocarbon_energy_" + name)).string();
}

TEST(Energy, OfDataAndXyzFilesIsTheSame) {
  const std::string data = scratch("c60.data"), xyz = scratch("c60.xyz");
  ASSERT_EQ(run("make fullerene 1 1 -o " + data).exit_code, 0);
  ASSERT_EQ(run("make fullerene 1 1 -o " + xyz).exit_code, 0);
  const json a = json::parse(run("energy " + data + " --json --parts").output);
  const json b = json::parse(run("energy " + xyz + " --json").output);
  EXPECT_EQ(a["atoms"], 60);
  EXPECT_NEAR(a["energy"], b["energy"], 1e-10);
  // The minimum is at -6.84206 eV/atom.
  EXPECT_GT(a["energy_per_atom"], -6.84207);
  EXPECT_LT(a["energy_per_atom"], -6.7);
  double sum = 0.0;
  for (const auto& part : a["parts"]) sum += part.get<double>();
  EXPECT_NEAR(sum, a["energy"], 1e-10);
  EXPECT_THAT(run("energy " + data).output, HasSubstr("60 carbon and 0 hydrogen"));
}

TEST(Energy, WritesForcesThatAddUpToNothing) {
  const std::string sheet = scratch("sheet.data"), forces = scratch("forces.xyz");
  ASSERT_EQ(run("make graphene --cells 3 2 -o " + sheet).exit_code, 0);
  ASSERT_EQ(run("energy " + sheet + " --forces " + forces).exit_code, 0);
  std::ifstream file(forces);
  std::string line;
  std::getline(file, line);
  EXPECT_EQ(line, "24");
  std::getline(file, line);
  EXPECT_THAT(line, HasSubstr("Properties=id:I:1:species:S:1:pos:R:3:forces:R:3:energies:R:1"));
  EXPECT_THAT(line, HasSubstr("pbc=\"T T F\""));
  std::array<double, 3> sum = {};
  int atoms = 0;
  while (std::getline(file, line)) {
    std::istringstream words(line);
    std::string species;
    double id, x, y, z;
    std::array<double, 3> f;
    words >> id >> species >> x >> y >> z >> f[0] >> f[1] >> f[2];
    for (int d = 0; d < 3; ++d) sum[d] += f[d];
    ++atoms;
  }
  EXPECT_EQ(atoms, 24);
  for (const double s : sum) EXPECT_NEAR(s, 0.0, 1e-10);
}

TEST(Energy, SaysWhatIsWrongAndExitsWithItsCode) {
  EXPECT_EQ(run("energy molecule.pdb").exit_code, 3);
  EXPECT_THAT(run("energy molecule.pdb").output, HasSubstr("molecule.pdb: cannot be read"));
  EXPECT_EQ(run("energy nowhere.data").exit_code, 3);
  const std::string empty = scratch("empty.xyz");
  std::ofstream(empty) << "0\n\n";
  EXPECT_EQ(run("energy " + empty).exit_code, 5);
  const std::string broken = scratch("broken.xyz");
  std::ofstream(broken) << "2\n\nC 0 0 0\nC 0 0\n";
  EXPECT_EQ(run("energy " + broken).exit_code, 4);
}

}  // namespace
}  // namespace nanocarbon::cli
