// SPDX-License-Identifier: MIT
// Is every fault of every faulty file named, at its line and with its advice, and nothing else?
// Files: tests/mechanism/faulty.
//
// A file says what it expects in comments `# expect LINE: words of the message`.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "moivre/mechanism/read.h"

namespace moivre {
namespace {

constexpr std::size_t kFewestFaultyFiles = 40;

struct Expected {
  std::size_t line = 0;
  std::string words;
};

std::vector<Expected> expectations(const std::string& text) {
  const std::string mark = "# expect ";
  std::vector<Expected> expected;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.compare(0, mark.size(), mark) != 0) continue;
    const std::size_t colon = line.find(": ");
    const std::string number = line.substr(mark.size(), colon - mark.size());
    expected.push_back({std::stoul(number), line.substr(colon + 2)});
  }
  return expected;
}

std::vector<std::filesystem::path> faulty_files() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(
           std::filesystem::path(MOIVRE_SOURCE_DIR) / "tests/mechanism/faulty")) {
    files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

void expect_faults(const std::filesystem::path& file) {
  const Source source = read_source(file.string());
  const std::vector<Expected> expected = expectations(source.text);
  ASSERT_FALSE(expected.empty());
  try {
    read_mechanism(source);
    FAIL() << "the file was read without a fault";
  } catch (const ParseError& error) {
    EXPECT_EQ(error.diagnostics().size(), expected.size()) << error.what();
    for (const Expected& fault : expected) {
      const auto& found = error.diagnostics();
      const bool is_named =
          std::any_of(found.begin(), found.end(), [&](const Diagnostic& diagnostic) {
            return diagnostic.at.line == fault.line &&
                   diagnostic.message.find(fault.words) != std::string::npos;
          });
      EXPECT_TRUE(is_named) << "line " << fault.line << ": " << fault.words << "\n" << error.what();
    }
  }
}

TEST(FaultyMechanismFile, IsRefusedWithEveryFaultAtItsLine) {
  const std::vector<std::filesystem::path> files = faulty_files();
  EXPECT_GE(files.size(), kFewestFaultyFiles);
  for (const std::filesystem::path& file : files) {
    SCOPED_TRACE(file.filename().string());
    expect_faults(file);
  }
}

}  // namespace
}  // namespace moivre
