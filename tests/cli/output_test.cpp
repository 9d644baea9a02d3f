// SPDX-License-Identifier: MIT
// Is what was written on the disk before it takes the place of the old file, and is the place too?
// A power cut is not to be had: the calls of fsync() are seen instead, and what is there then.
#include "output.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace {

struct Synced {
  bool is_folder = false;
  std::string content;  ///< of the file that is written, at that time
};

std::string watched;  // NOLINT: what fsync() below is told by
std::vector<Synced> seen;

std::string content_of(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

}  // namespace

/// In the place of the C library's, which it calls.
extern "C" int fsync(int descriptor) {
  struct stat status = {};
  if (!watched.empty() && ::fstat(descriptor, &status) == 0) {
    seen.push_back({S_ISDIR(status.st_mode), content_of(watched)});
  }
  return static_cast<int>(::syscall(SYS_fsync, descriptor));
}

namespace moivre {
namespace {

TEST(Output, IsOnTheDiskBeforeItTakesTheOldFilesPlaceAndItsFolderAfterwards) {
  std::string folder = ::testing::TempDir() + "moivre-output-XXXXXX";
  ASSERT_NE(::mkdtemp(folder.data()), nullptr);
  const std::string path = folder + "/result.json";
  std::ofstream(path) << "old";
  watched = path;
  Output(path).write("new");
  watched.clear();
  ASSERT_EQ(seen.size(), 2U);
  EXPECT_FALSE(seen[0].is_folder);
  EXPECT_EQ(seen[0].content, "old");
  EXPECT_TRUE(seen[1].is_folder);
  EXPECT_EQ(seen[1].content, "new");
  EXPECT_EQ(content_of(path), "new");
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace moivre
