// SPDX-License-Identifier: GPL-2.0-or-later
// `nanocarbon make` as a user runs it: what it writes, what it refuses, and that ASE reads it.
#include <gmock/gmock.h>

#include <filesystem>
#include <sstream>
#include <string>

#include "nanocarbon/mesh/formats/load_surface.h"
#include "nanocarbon/mesh/mesh_topology.h"
#include "nanocarbon/molecule/formats/read_molecule.h"
#include "support/run_program.h"
#include "support/temporary_folder.h"

namespace nanocarbon::cli {
namespace {

using test::ProgramOutcome;
using testing::HasSubstr;
using testing::StartsWith;

ProgramOutcome make(const std::string& arguments) {
  return test::run_command(NANOCARBON_PROGRAM " make " + arguments);
}

struct Case {
  std::string command;
  std::size_t atoms, bonds;
};
// Counts from the formulas of each structure, not from a run.
const Case cases[] = {
    {"graphene --cells 3 5", 60, 90},
    {"graphene --flake 4 --hydrogen", 36, 42},  // coronene, C24H12
    {"tube 5 5 --length 9.9 --periodic", 80, 120},
    {"tube 10 10 --length 2.5 --ends periodic", 40, 60},
    {"tube 9 0 --length 4.3 --periodic", 36, 54},
    {"tube 7 3 --length 1 --periodic", 316, 474},
    {"tube 5 5 --length 1 --ends capped", 60, 90},
    {"fullerene 1 1", 60, 90},
    {"fullerene 2 1", 140, 210},
    {"fullerene 4 4", 960, 1440},
    {"onion --shells 2", 300, 450},
    {"onion --shells 2 --potential rebo2", 300, 450},
    {"graphite --cells 2 3 --layers 4", 96, 144},
    {"graphite --cells 2 2 --layers 3 --slab --potential airebo-m", 48, 72},
    {"tube 5 5 --length 4.9 --periodic --bundle 3", 120, 180},
    {"tube 5 5 --length 2.5 --periodic --bundle-cells 2 1 --potential airebo-m", 80, 120},
    {"diamond --cells 2", 64, 128},
    {"schwarzite p688 --cells 1 1 2", 96, 144},
    {"schwarzite d688 --cells 2", 192, 288},
    {"schwarzite g688 --cells 1", 96, 144},
    {"schwarzite p144", 144, 216},
    {"schwarzite d168 --cells 1 2 1", 336, 504},
    {"schwarzite d56 --potential airebo", 56, 84},
};

TEST(Make, StructuresHaveTheirAtomsAndBonds) {
  const test::TemporaryFolder folder;
  for (const Case& c : cases) {
    SCOPED_TRACE(c.command);
    const ProgramOutcome data = make(c.command + " -o " + (folder / "a.data").string());
    ASSERT_EQ(data.exit_code, 0) << data.output;
    EXPECT_THAT(data.output,
                HasSubstr(std::to_string(c.atoms) + " atoms, " + std::to_string(c.bonds) + " bonds"));
    const Molecule molecule = molecule::read_molecule(folder / "a.data").molecule;
    EXPECT_EQ(molecule.size(), c.atoms);
    EXPECT_EQ(molecule.bonds.size(), c.bonds);
    ASSERT_EQ(make(c.command + " --quiet -o " + (folder / "a.xyz").string()).output, "");
    EXPECT_EQ(molecule::read_molecule(folder / "a.xyz").molecule.size(), c.atoms);
  }
}

TEST(Make, WhatIsNotHeldTogetherByRebo2IsRefused) {
  const test::TemporaryFolder folder;
  const std::string output = " -o " + (folder / "a.data").string();
  for (const std::string what : {"graphite", "tube 5 5 --bundle 7"}) {
    const ProgramOutcome outcome = make(what + " --potential rebo2" + output);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_THAT(outcome.output, HasSubstr("use --potential airebo or airebo-m"));
  }
  EXPECT_THAT(make("graphite --layers 3" + output).output, HasSubstr("3 AB layers do not repeat along z"));
  EXPECT_EQ(make("tube 5 5 --potential airebo" + output).exit_code, 2);
  EXPECT_EQ(make("tube 5 5 --bundle 7 --bundle-cells 1 1" + output).exit_code, 2);
}

TEST(Make, FilesSayHowTheyWereMade) {
  const test::TemporaryFolder folder;
  const std::string path = (folder / "tube.data").string();
  ASSERT_EQ(make("tube 8 2 --ends open --length 20 -o " + path).exit_code, 0);
  EXPECT_THAT(test::contents_of(path), StartsWith("# nanocarbon make tube 8 2"));
  EXPECT_THAT(test::contents_of(path).substr(0, 200), HasSubstr("--ends open"));
}

TEST(Make, AseReadsTheFiles) {
  if (std::string(NANOCARBON_ASE_PYTHON).empty())
    GTEST_SKIP() << "no Python with ASE was found (python3-ase)";
  const test::TemporaryFolder folder;
  const std::string read = std::string(NANOCARBON_ASE_PYTHON) + " " NANOCARBON_ASE_SCRIPT " ";
  for (const std::string what :
       {"tube 7 3 --length 20 --periodic", "tube 10 10 --length 20", "tube 9 0 --length 20 --ends capped",
        "tube 5 5 --length 20 --ends open", "fullerene 1 1", "fullerene 4 4", "graphene", "schwarzite d168"}) {
    SCOPED_TRACE(what);
    const std::string data = (folder / "a.data").string(), xyz = (folder / "a.xyz").string();
    ASSERT_EQ(make(what + " -o " + data).exit_code, 0);
    ASSERT_EQ(make(what + " -o " + xyz).exit_code, 0);
    const Molecule molecule = molecule::read_molecule(data).molecule;
    const std::string atoms = std::to_string(molecule.size()) + "\n";
    EXPECT_THAT(test::run_command(read + "data " + data + " molecular").output, StartsWith(atoms));
    EXPECT_THAT(test::run_command(read + "xyz " + xyz).output, StartsWith(atoms));
  }
}

TEST(Make, ShapesAreSurfacesOfTheirGenus) {
  const test::TemporaryFolder folder;
  struct Shape {
    std::string command;
    std::int64_t genus;
    std::size_t boundaries;
  };
  for (const Shape& shape : {Shape{"sphere --subdivisions 5", 0, 0},
                             {"torus", 1, 0},
                             {"genus-two --edge 0.3", 2, 0},
                             {"junction --kind x", 0, 4},
                             {"junction --kind t --closed", 0, 0},
                             {"helix --open", 0, 2},
                             {"hemisphere", 0, 1}}) {
    SCOPED_TRACE(shape.command);
    for (const std::string extension : {".off", ".ply"}) {
      const std::string path = (folder / ("shape" + extension)).string();
      const ProgramOutcome outcome = make("mesh " + shape.command + " -o " + path);
      ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
      const mesh::MeshTopology topology = mesh::mesh_topology(mesh::load_surface(path).mesh);
      EXPECT_EQ(topology.genus, shape.genus);
      EXPECT_EQ(topology.boundary_loops, shape.boundaries);
    }
  }
}

TEST(Make, RefusalsHaveAnExitCodeAMessageAndNoFile) {
  const test::TemporaryFolder folder;
  const auto refused = [&](const std::string& arguments, const std::string& name) {
    const ProgramOutcome outcome = make(arguments + " -o " + (folder / name).string());
    EXPECT_FALSE(outcome.output.empty()) << arguments;
    EXPECT_FALSE(std::filesystem::exists(folder / name)) << arguments;
    return outcome.exit_code;
  };
  EXPECT_EQ(refused("", "a.data"), 2);
  EXPECT_EQ(refused("tube 5", "a.data"), 2);
  EXPECT_EQ(refused("tube -1 5", "a.data"), 2);
  EXPECT_EQ(refused("tube 2 1", "a.data"), 2);
  EXPECT_EQ(refused("tube 3 0 --ends capped", "a.data"), 2);
  EXPECT_EQ(refused("tube 5 5 --ends capped --periodic", "a.data"), 2);
  EXPECT_EQ(refused("fullerene 0 0", "a.data"), 2);
  EXPECT_EQ(refused("fullerene 90000 90000", "a.data"), 2);
  EXPECT_EQ(refused("diamond --cells 1 2", "a.data"), 2);
  EXPECT_EQ(refused("schwarzite p100", "a.data"), 2);
  EXPECT_EQ(refused("schwarzite d168 --cells 1 2", "a.data"), 2);
  EXPECT_EQ(refused("fullerene 1 1", "a.pdb"), 2);
  EXPECT_EQ(refused("mesh torus", "a.data"), 2);
  EXPECT_EQ(refused("mesh torus --major 1 --minor 2", "a.off"), 2);
  EXPECT_EQ(refused("mesh gyroid-piece --edge 1e-9", "a.off"), 2);
  EXPECT_EQ(refused("mesh torus --edge 1e-9", "a.off"), 2);
  EXPECT_EQ(refused("graphene --hydrogen", "a.data"), 2);
  EXPECT_EQ(refused("fullerene 1 1", "none/a.data"), 7);
}

TEST(Make, SameCommandGivesTheSameBytes) {
  const test::TemporaryFolder folder;
  for (const std::string what : {"fullerene 3 2", "tube 8 3 --ends capped", "mesh genus-two"}) {
    const std::string path = (folder / (what.starts_with("mesh") ? "a.off" : "a.data")).string();
    ASSERT_EQ(make(what + " -o " + path).exit_code, 0);
    const std::string first = test::contents_of(path);
    ASSERT_EQ(make(what + " -o " + path).exit_code, 0);
    EXPECT_EQ(test::contents_of(path), first);
  }
}

}  // namespace
}  // namespace nanocarbon::cli
