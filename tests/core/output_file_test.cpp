#include "nanocarbon/core/output_file.h"

#include <gmock/gmock.h>

#include <fstream>
#include <stdexcept>

#include "nanocarbon/core/error.h"

namespace nanocarbon {
namespace {

namespace fs = std::filesystem;

class OutputFile : public testing::Test {
 protected:
  void SetUp() override {
    const std::string test = testing::UnitTest::GetInstance()->current_test_info()->name();
    folder = fs::path(testing::TempDir()) / ("nanocarbon_output_file_" + test);
    fs::remove_all(folder);
    fs::create_directories(folder);
  }
  void TearDown() override { fs::remove_all(folder); }

  std::size_t files() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
  }
  std::string contents(const fs::path& path) const {
    std::ifstream stream(path);
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  fs::path folder;
};

TEST_F(OutputFile, WritesAndReplaces) {
  write_file(folder / "a", [](std::ostream& out) { out << "one"; });
  write_file(folder / "a", [](std::ostream& out) { out << "two"; });
  EXPECT_EQ(contents(folder / "a"), "two");
  EXPECT_EQ(files(), 1u);
}

TEST_F(OutputFile, AFailureHalfwayKeepsTheOldFileAndLeavesNothingElse) {
  write_file(folder / "a", [](std::ostream& out) { out << "old"; });
  EXPECT_THROW(write_file(folder / "a",
                          [](std::ostream& out) {
                            out << "half";
                            throw std::logic_error("stopped");
                          }),
               std::logic_error);
  EXPECT_EQ(contents(folder / "a"), "old");
  EXPECT_EQ(files(), 1u);
}

TEST_F(OutputFile, AMissingFolderIsTheUsersError) {
  try {
    write_file(folder / "none" / "a", [](std::ostream&) {});
    FAIL() << "nothing was thrown";
  } catch (const UserError& error) {
    EXPECT_EQ(error.failure(), Failure::unwritable);
    EXPECT_THAT(error.what(), testing::HasSubstr("No such file or directory"));
  }
}

TEST_F(OutputFile, AFullDeviceIsTheUsersError) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "this system has no /dev/full";
  EXPECT_THROW(write_file("/dev/full", [](std::ostream& out) { out << std::string(100000, 'x'); }),
               UserError);
}

TEST_F(OutputFile, ADirectoryIsTheUsersError) {
  EXPECT_THROW(write_file(folder, [](std::ostream&) {}), UserError);
}

}  // namespace
}  // namespace nanocarbon
