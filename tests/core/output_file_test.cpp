// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/core/output_file.h"

#include <gmock/gmock.h>
#include <signal.h>
#include <sys/resource.h>

#include <fstream>
#include <stdexcept>

#include "nanocarbon/core/error.h"
#include "support/temporary_folder.h"

namespace nanocarbon {
namespace {

namespace fs = std::filesystem;

class OutputFile : public testing::Test {
 protected:
  std::size_t files() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
  }
  std::string contents(const fs::path& path) const {
    std::ifstream stream(path);
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  const test::TemporaryFolder temporary;
  const fs::path folder = temporary.path();
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

TEST_F(OutputFile, SeveralFilesAppearTogetherOrNotAtAll) {
  write_file(folder / "a", [](std::ostream& out) { out << "old"; });
  const auto write_both = [&](const fs::path& second) {
    OutputFiles files;
    files.add(folder / "a", [](std::ostream& out) { out << "new"; });
    files.add(second, [](std::ostream& out) { out << std::string(100000, 'x'); });
    EXPECT_EQ(contents(folder / "a"), "old");
    files.publish();
  };
  EXPECT_THROW(write_both(folder / "none" / "b"), UserError);
  EXPECT_EQ(contents(folder / "a"), "old");
  EXPECT_EQ(files(), 1u);
  write_both(folder / "b");
  EXPECT_EQ(contents(folder / "a"), "new");
  EXPECT_EQ(files(), 2u);
}

TEST_F(OutputFile, ASignalHalfwayWaitsUntilTheFileIsWhole) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    EXPECT_EXIT(write_file(folder / "a",
                           [&](std::ostream& out) {
                             out << "first ";
                             raise(signal);
                             out << "second";
                           }),
                testing::KilledBySignal(signal), "");
    EXPECT_EQ(contents(folder / "a"), "first second");
    EXPECT_EQ(files(), 1u);
    fs::remove(folder / "a");
  }
}

TEST_F(OutputFile, ALimitOnTheSizeOfFilesIsTheUsersError) {
  const auto write_beyond_it = [&] {
    const rlimit limit{1000, 1000};
    setrlimit(RLIMIT_FSIZE, &limit);
    ::signal(SIGXFSZ, SIG_IGN);  // as the program does
    try {
      write_file(folder / "a", [](std::ostream& out) { out << std::string(100000, 'x'); });
    } catch (const UserError& error) {
      _exit(static_cast<int>(error.failure()));
    }
    _exit(0);
  };
  EXPECT_EXIT(write_beyond_it(), testing::ExitedWithCode(static_cast<int>(Failure::unwritable)), "");
  EXPECT_EQ(files(), 0u);
}

TEST_F(OutputFile, ASymbolicLinkStaysOne) {
  write_file(folder / "target", [](std::ostream& out) { out << "old"; });
  fs::create_symlink(folder / "target", folder / "link");
  write_file(folder / "link", [](std::ostream& out) { out << "new"; });
  EXPECT_TRUE(fs::is_symlink(folder / "link"));
  EXPECT_EQ(contents(folder / "target"), "new");
}

TEST_F(OutputFile, ADirectoryIsTheUsersError) {
  EXPECT_THROW(write_file(folder, [](std::ostream&) {}), UserError);
}

}  // namespace
}  // namespace nanocarbon
