// SPDX-License-Identifier: MIT
// Is every example of docs/mechanism-file.md read?
#include <gtest/gtest.h>

#include "moivre/mechanism/phi.h"
#include "moivre/mechanism/read.h"

namespace moivre {
namespace {

std::vector<std::string> toml_blocks(const std::string& page) {
  const std::string open = "```toml\n";
  std::vector<std::string> blocks;
  for (std::size_t at = page.find(open); at != std::string::npos; at = page.find(open, at)) {
    at += open.size();
    blocks.push_back(page.substr(at, page.find("```", at) - at));
  }
  return blocks;
}

TEST(MechanismFilePage, ExamplesAreRead) {
  const Source page = read_source(std::string(MOIVRE_SOURCE_DIR) + "/docs/mechanism-file.md");
  const std::vector<std::string> blocks = toml_blocks(page.text);
  EXPECT_EQ(blocks.size(), 9U);
  for (const std::string& block : blocks) {
    const Mechanism mechanism = read_mechanism({"example", block});
    EXPECT_TRUE(mechanism.warnings.empty());
    EXPECT_GT(Phi(mechanism).size(), 0);
  }
}

}  // namespace
}  // namespace moivre
