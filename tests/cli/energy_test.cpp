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

// Ethane as LAMMPS has it (the structure of that name in reference.json).
std::string ethane() {
  const json all = json::parse(std::ifstream(NANOCARBON_AIREBO_REFERENCE));
  const std::string path = scratch("ethane.xyz");
  std::ofstream file(path);
  file.precision(17);
  for (const json& structure : all) {
    if (structure["name"] != "ethane") continue;
    file << structure["elements"].get<std::string>().size() << "\n\n";
    for (std::size_t i = 0; i < structure["elements"].get<std::string>().size(); ++i)
      file << structure["elements"].get<std::string>()[i] << " " << structure["positions"][3 * i] << " "
           << structure["positions"][3 * i + 1] << " " << structure["positions"][3 * i + 2] << "\n";
  }
  return path;
}

TEST(Energy, OfAireboAndItsPartsAreThoseOfLammps) {
  const std::string file = ethane();
  const json all = json::parse(std::ifstream(NANOCARBON_AIREBO_REFERENCE));
  for (const auto& [potential, style, long_range] :
       {std::tuple("airebo", "airebo 3.0", "lennard_jones"), {"airebo-m", "airebo/morse 3.0", "morse"}}) {
    const json lammps =
        *std::find_if(all.begin(), all.end(), [](const json& s) { return s["name"] == "ethane"; });
    const json& expected = lammps["styles"][style];
    const json found =
        json::parse(run("energy " + file + " --json --parts --potential " + std::string(potential)).output);
    EXPECT_EQ(found["potential"], potential);
    EXPECT_NEAR(found["parts"]["rebo"], expected["rebo"], 1e-9);
    EXPECT_NEAR(found["parts"][long_range], expected["lj"], 1e-9);
    EXPECT_NEAR(found["parts"]["torsion"], expected["torsion"], 1e-9);
    const double sum =
        expected["rebo"].get<double>() + expected["lj"].get<double>() + expected["torsion"].get<double>();
    EXPECT_NEAR(found["energy"], sum, 1e-9);
  }
  EXPECT_THAT(run("energy " + file + " --parts --potential airebo").output, HasSubstr("lennard-jones"));
}

TEST(Energy, WithForcesIsTheSame) {
  const std::string file = ethane(), forces = scratch("ethane-forces.xyz");
  const json plain = json::parse(run("energy " + file + " --json --potential airebo").output);
  const json with =
      json::parse(run("energy " + file + " --json --potential airebo --forces " + forces).output);
  EXPECT_NEAR(plain["energy"], with["energy"], 1e-10);
  std::ifstream written(forces);
  std::string line;
  std::getline(written, line);
  std::getline(written, line);
  double sum = 0.0;
  while (std::getline(written, line)) sum += std::stod(line.substr(line.rfind(' ')));
  EXPECT_NEAR(sum, plain["energy"], 1e-9);
}

TEST(Energy, TakesParametersFromTheFileOfThePotential) {
  if (!std::filesystem::exists(NANOCARBON_CH_REBO)) GTEST_SKIP() << "no CH.rebo of LAMMPS here";
  const std::filesystem::path folder = std::filesystem::path(NANOCARBON_CH_REBO).parent_path();
  const std::string file = ethane();
  for (const auto& [potential, name] :
       {std::pair("rebo2", "CH.rebo"), {"airebo", "CH.airebo"}, {"airebo-m", "CH.airebo-m"}}) {
    const std::string command = "energy " + file + " --json --potential " + std::string(potential);
    const test::ProgramOutcome given = run(command + " --parameters " + (folder / name).string());
    ASSERT_EQ(given.exit_code, 0) << given.output;
    EXPECT_NEAR(json::parse(given.output)["energy"], json::parse(run(command).output)["energy"], 1e-7);
  }
  const std::string rebo = " --parameters " + (folder / "CH.rebo").string();
  const test::ProgramOutcome wrong = run("energy " + file + " --potential airebo" + rebo);
  EXPECT_EQ(wrong.exit_code, 4);
  EXPECT_THAT(wrong.output, HasSubstr("CH.rebo, line 2: this is a file of REBO2, not of AIREBO"));
  EXPECT_EQ(run("energy " + file + " --parameters nowhere").exit_code, 3);
  const test::ProgramOutcome former = run("energy " + file + " --potential " + (folder / "CH.rebo").string());
  EXPECT_EQ(former.exit_code, 2);
  EXPECT_THAT(former.output, HasSubstr("a file goes to --parameters FILE"));
  EXPECT_EQ(run("energy " + file + " --potential AIREBO").exit_code, 2);
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
