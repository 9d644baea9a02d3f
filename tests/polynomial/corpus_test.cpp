// SPDX-License-Identifier: MIT
// Do the readers keep their laws on every input that the fuzzers kept, the ones that once broke
// them among these?
#include <gtest/gtest.h>

#include <filesystem>

#include "../fuzz/reader_laws.h"

namespace moivre {
namespace {

void replay(const std::string& folder, PolynomialFormat format) {
  const std::filesystem::path path =
      std::filesystem::path(MOIVRE_SOURCE_DIR) / "tests/corpus" / folder;
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(path)) {
    const std::optional<std::string> broken =
        broken_reader_law(read_source(entry.path().string()).text, format);
    EXPECT_FALSE(broken.has_value()) << entry.path().filename() << ": " << *broken;
    ++count;
  }
  EXPECT_GT(count, 10U);
}

TEST(ReaderCorpus, OfPhcpackTextKeepsTheLaws) { replay("phcpack", PolynomialFormat::phcpack); }

TEST(ReaderCorpus, OfBertiniInputKeepsTheLaws) { replay("bertini", PolynomialFormat::bertini); }

}  // namespace
}  // namespace moivre
