// SPDX-License-Identifier: MIT
// Does the mechanism reader keep its laws on every input that the fuzzer kept, on every example and
// on every faulty file?
#include <gtest/gtest.h>

#include <filesystem>

#include "../fuzz/mechanism_laws.h"

namespace moivre {
namespace {

TEST(MechanismCorpus, KeepsTheReadersLaws) {
  const std::filesystem::path root(MOIVRE_SOURCE_DIR);
  for (const char* folder :
       {"tests/corpus/mechanism", "problems/mechanisms", "tests/mechanism/faulty"}) {
    std::size_t count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(root / folder)) {
      const auto broken = broken_mechanism_law(read_source(entry.path().string()).text);
      EXPECT_FALSE(broken.has_value()) << entry.path() << ": " << *broken;
      ++count;
    }
    EXPECT_GT(count, 0U) << folder;
  }
}

}  // namespace
}  // namespace moivre
