// SPDX-License-Identifier: GPL-2.0-or-later
// `nanocarbon energy` as a user runs it.
#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "support/program_test.h"

namespace nanocarbon::cli {
namespace {

using nlohmann::json;
using testing::HasSubstr;

using Energy = test::ProgramTest;

TEST_F(Energy, OfDataAndXyzFilesIsTheSame) {
  const std::string data = path("c60.data"), xyz = path("c60.xyz");
  ASSERT_EQ(run("make fullerene 1 1 -o " + data).exit_code, 0);
  ASSERT_EQ(run("make fullerene 1 1 -o " + xyz).exit_code, 0);
  const json a = json::parse(run("energy " + data + " --json --parts").out);
  const json b = json::parse(run("energy " + xyz + " --json").out);
  EXPECT_EQ(a["atoms"], 60);
  EXPECT_NEAR(a["energy"], b["energy"], 1e-10);
  // The minimum is at -6.84206 eV/atom.
  EXPECT_GT(a["energy_per_atom"], -6.84207);
  EXPECT_LT(a["energy_per_atom"], -6.7);
  double sum = 0.0;
  for (const auto& part : a["parts"]) sum += part.get<double>();
  EXPECT_NEAR(sum, a["energy"], 1e-10);
  EXPECT_THAT(run("energy " + data).out, HasSubstr("60 carbon and 0 hydrogen"));
}

TEST_F(Energy, WritesForcesThatAddUpToNothing) {
  const std::string sheet = path("sheet.data"), forces = path("forces.xyz");
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
  std::ostringstream file;
  file.precision(17);
  for (const json& structure : all) {
    if (structure["name"] != "ethane") continue;
    file << structure["elements"].get<std::string>().size() << "\n\n";
    for (std::size_t i = 0; i < structure["elements"].get<std::string>().size(); ++i)
      file << structure["elements"].get<std::string>()[i] << " " << structure["positions"][3 * i] << " "
           << structure["positions"][3 * i + 1] << " " << structure["positions"][3 * i + 2] << "\n";
  }
  return file.str();
}

TEST_F(Energy, OfAireboAndItsPartsAreThoseOfLammps) {
  const std::string molecule = file("ethane.xyz", ethane());
  const json all = json::parse(std::ifstream(NANOCARBON_AIREBO_REFERENCE));
  for (const auto& [potential, style, long_range] :
       {std::tuple("airebo", "airebo 3.0", "lennard_jones"), {"airebo-m", "airebo/morse 3.0", "morse"}}) {
    const json lammps =
        *std::find_if(all.begin(), all.end(), [](const json& s) { return s["name"] == "ethane"; });
    const json& expected = lammps["styles"][style];
    const json found =
        json::parse(run("energy " + molecule + " --json --parts --potential " + std::string(potential)).out);
    EXPECT_EQ(found["potential"], potential);
    EXPECT_NEAR(found["parts"]["rebo"], expected["rebo"], 1e-9);
    EXPECT_NEAR(found["parts"][long_range], expected["lj"], 1e-9);
    EXPECT_NEAR(found["parts"]["torsion"], expected["torsion"], 1e-9);
    const double sum =
        expected["rebo"].get<double>() + expected["lj"].get<double>() + expected["torsion"].get<double>();
    EXPECT_NEAR(found["energy"], sum, 1e-9);
  }
  EXPECT_THAT(run("energy " + molecule + " --parts --potential airebo").out, HasSubstr("lennard-jones"));
}

TEST_F(Energy, WithForcesIsTheSame) {
  const std::string molecule = file("ethane.xyz", ethane()), forces = path("ethane-forces.xyz");
  const json plain = json::parse(run("energy " + molecule + " --json --potential airebo").out);
  const json with =
      json::parse(run("energy " + molecule + " --json --potential airebo --forces " + forces).out);
  EXPECT_NEAR(plain["energy"], with["energy"], 1e-10);
  std::ifstream written(forces);
  std::string line;
  std::getline(written, line);
  std::getline(written, line);
  double sum = 0.0;
  while (std::getline(written, line)) sum += std::stod(line.substr(line.rfind(' ')));
  EXPECT_NEAR(sum, plain["energy"], 1e-9);
}

TEST_F(Energy, TakesParametersFromTheFileOfThePotential) {
  if (!std::filesystem::exists(NANOCARBON_CH_REBO)) GTEST_SKIP() << "no CH.rebo of LAMMPS here";
  const std::filesystem::path potentials = std::filesystem::path(NANOCARBON_CH_REBO).parent_path();
  const std::string molecule = file("ethane.xyz", ethane());
  for (const auto& [potential, name] :
       {std::pair("rebo2", "CH.rebo"), {"airebo", "CH.airebo"}, {"airebo-m", "CH.airebo-m"}}) {
    const std::string command = "energy " + molecule + " --json --potential " + std::string(potential);
    const Outcome given = run(command + " --parameters " + (potentials / name).string());
    ASSERT_EQ(given.exit_code, 0) << given.err;
    EXPECT_NEAR(json::parse(given.out)["energy"], json::parse(run(command).out)["energy"], 1e-7);
  }
  const std::string rebo = " --parameters " + (potentials / "CH.rebo").string();
  const Outcome wrong = run("energy " + molecule + " --potential airebo" + rebo);
  EXPECT_EQ(wrong.exit_code, 4);
  EXPECT_THAT(wrong.err, HasSubstr("CH.rebo, line 2: this is a file of REBO2, not of AIREBO"));
  EXPECT_EQ(run("energy " + molecule + " --parameters nowhere").exit_code, 3);
  const Outcome former = run("energy " + molecule + " --potential " + (potentials / "CH.rebo").string());
  EXPECT_EQ(former.exit_code, 2);
  EXPECT_THAT(former.err, HasSubstr("a file goes to --parameters FILE"));
  EXPECT_EQ(run("energy " + molecule + " --potential AIREBO").exit_code, 2);
}

TEST_F(Energy, OfAtomsInTheSamePlaceIsNone) {
  const std::string xyz = path("twice.xyz");
  std::ofstream(xyz) << "4\n\nC 0 0 0\nC 1.4 0 0\nC 1.4 0 0\nC 2.8 0 0.3\n";
  const Outcome outcome = run("energy " + xyz);
  EXPECT_EQ(outcome.exit_code, 5);
  EXPECT_EQ(outcome.out, "");
  EXPECT_THAT(outcome.err, HasSubstr("on top of each other"));
}

TEST_F(Energy, SaysWhatIsWrongAndExitsWithItsCode) {
  EXPECT_EQ(run("energy molecule.pdb").exit_code, 3);
  EXPECT_THAT(run("energy molecule.pdb").err, HasSubstr("molecule.pdb: cannot be read"));
  EXPECT_EQ(run("energy nowhere.data").exit_code, 3);
  EXPECT_EQ(run("energy " + file("empty.xyz", "0\n\n")).exit_code, 5);
  EXPECT_EQ(run("energy " + file("broken.xyz", "2\n\nC 0 0 0\nC 0 0\n")).exit_code, 4);
}

}  // namespace
}  // namespace nanocarbon::cli
