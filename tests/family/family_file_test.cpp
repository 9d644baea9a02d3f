// SPDX-License-Identifier: MIT
// A family file gives the family back to the last bit; whatever else is in a file is refused, and
// crashes nothing.
#include "moivre/family/family_file.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <fstream>

#include "families.h"
#include "moivre/family/coefficients.h"
#include "moivre/family/members.h"
#include "moivre/tracker_lanes/lane_tracker.h"

namespace moivre {
namespace {

FamilyFile conics_file() {
  FamilyFile file;
  file.source = "conics.phc";
  file.families.push_back(learn(conics(), *make_lane_tracker()));
  return file;
}

/// What the reader says of the text; empty where it takes it.
std::string refusal(const std::string& text) {
  try {
    read_family({"f.family", text});
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

/// With the checksum that fits the text before it: what the reader behind the checksum sees.
std::string sealed(const std::string& text) {
  const std::size_t at = text.rfind(",\n  \"checksum\"");
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char c : text.substr(0, at)) {
    hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  }
  char digits[17];
  std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(hash));
  return text.substr(0, at) + ",\n  \"checksum\": \"" + digits + "\"\n}\n";
}

TEST(FamilyFile, IsReadBackToTheLastBit) {
  FamilyFile file = conics_file();
  EXPECT_EQ(read_family({"f", family_text(file)}), file);
  file.kind = kMechanismKind;
  Family third = coefficient_family(read_system({"test", "1\n(1/3)*x^3 + (2-i)*x - 1e-300;\n"}));
  third.nonzero = true;
  third.generic = Point(3, Complex(0.1, -1e-310));
  third.roots = {{Complex(1.0 / 3, 5e-324)}};
  file.families.push_back(third);
  EXPECT_EQ(read_family({"f", family_text(file)}), file);
}

TEST(FamilyFile, RefusesWhatIsNotItsOwnWithTheReason) {
  const std::string text = family_text(conics_file());
  const std::string is_none = "f.family: this is no family file; moivre family learn writes them";
  EXPECT_EQ(refusal("2\nx^2 + y; y - 1;\n"), is_none);
  EXPECT_EQ(refusal(""), is_none);
  const std::string is_short =
      "f.family: the file is cut short, or was changed: it does not end with its checksum";
  EXPECT_EQ(refusal(text.substr(0, text.size() / 2)), is_short);
  EXPECT_EQ(refusal(text + " "), is_short);
  std::string changed = text;
  changed[changed.find("0.") + 2] ^= 1;
  EXPECT_EQ(refusal(changed),
            "f.family: the file was changed: its checksum is another; learn the family again");
  std::string later = text;
  later.replace(later.find("\"moivre_family\": 1"), 18, "\"moivre_family\": 9");
  EXPECT_EQ(refusal(sealed(later)),
            "f.family: the file has version 9, this program reads version 1");
  std::string other = text;
  other.replace(other.find("\"total degree\""), 14, "\"total decree\"");
  EXPECT_EQ(refusal(sealed(other)),
            "f.family: the file has a bound of an unknown kind, total decree");
}

TEST(FamilyFile, EveryChangedByteIsSeen) {
  const std::string text = family_text(conics_file());
  for (std::size_t k = 0; k < text.size(); ++k) {
    std::string changed = text;
    changed[k] = static_cast<char>(changed[k] ^ (1 << (k % 8)));
    EXPECT_NE(refusal(changed), "") << k;
  }
}

/// As one who leaves out all but two roots, and makes the checksum anew.
std::string forged(const Family& family, std::optional<MetBound> bound) {
  FamilyFile file;
  file.families.push_back(family);
  Family& liar = file.families.front();
  liar.roots.resize(2);
  liar.learning.bound = std::move(bound);
  return family_text(file);
}

TEST(FamilyFile, AForgedBoundProvesNoMember) {
  const auto tracker = make_lane_tracker();
  const Family honest = conics_file().families.front();
  ASSERT_EQ(honest.roots.size(), 4U);
  for (const auto& bound :
       {std::optional(MetBound{BoundKind::bezout, 2}),
        std::optional(MetBound{BoundKind::mixed_volume, 7}), std::optional<MetBound>()}) {
    const Family read = read_family({"f", forged(honest, bound)}).families.front();
    EXPECT_FALSE(read.learning.bound);
    EXPECT_FALSE(read.learning.complete);
    EXPECT_EQ(read.learning.standing,
              "the file has 2 roots, and exact algebra counts 4 of a generic member: roots are "
              "missing");
    const Point p = random_member(3, 1);
    const SolveResult result = solve_member(read, exact_values(p), *tracker);
    EXPECT_NE(result.completeness, RootCompleteness::proved);
    EXPECT_FALSE(result.complete);
    const std::vector<Point> members{p};
    const MemberRoots member = solve_members(read, members, *tracker).front();
    EXPECT_NE(member.completeness, RootCompleteness::proved);
    EXPECT_FALSE(member.complete);
  }
}

TEST(FamilyFile, ABoundIsFoundAgainWhereTheFileIsHonest) {
  const Family read = read_family({"f", family_text(conics_file())}).families.front();
  ASSERT_TRUE(read.learning.bound);
  EXPECT_EQ(read.learning.bound->kind, BoundKind::bezout);
  EXPECT_TRUE(read.learning.complete);
}

TEST(FamilyFile, RootsWithoutZerosAreCountedByAlgebraToo) {
  // x = 0 is a root of every member, and left out; of the two others a forger leaves one.
  Family family =
      unlearned_family(read_system({"test", "2 6\nx^3 + a*x*y - b*x; x + y^2*c - d*y;\n"}),
                       {{"a"}, {"b"}, {"c"}, {"d"}});
  family.nonzero = true;
  FamilyFile file;
  file.families.push_back(learn(family, *make_lane_tracker()));
  const std::size_t roots = file.families.front().roots.size();
  EXPECT_TRUE(read_family({"f", family_text(file)}).families.front().learning.complete) << roots;
  file.families.front().roots.pop_back();
  EXPECT_FALSE(read_family({"f", family_text(file)}).families.front().learning.complete);
}

TEST(FamilyFile, NoBytesBehindARightChecksumCrashTheReader) {
  const std::string text = family_text(conics_file());
  const std::string pieces[] = {"null", "-1", "1e999", "[]", "{}", "\"x\"", "0", "[[1,2]]", "NaN"};
  std::size_t refused = 0;
  for (std::uint64_t k = 0; k < 3000; ++k) {
    const auto random = [&](std::uint64_t i) { return random_bits(k, RandomStream::test, i); };
    std::string changed = text;
    for (std::uint64_t edit = 0; edit <= random(0) % 3; ++edit) {
      const std::size_t at = random(4 * edit + 1) % changed.size();
      const std::size_t length = random(4 * edit + 2) % 12;
      const std::string& piece = pieces[random(4 * edit + 3) % std::size(pieces)];
      if (random(4 * edit + 4) % 2 == 0) {
        changed.replace(at, std::min(length, changed.size() - at), piece);
      } else {
        changed[at] = static_cast<char>(random(4 * edit + 2));
      }
    }
    if (changed.rfind(",\n  \"checksum\"") == std::string::npos) continue;
    // Digits may be changed for others, which is a family still: what is read is whole.
    refused += refusal(sealed(changed)).empty() ? 0 : 1;
  }
  EXPECT_GT(refused, 1000U);
}

TEST(FamilyFile, IsReplacedWholeOrNotAtAll) {
  const auto folder = std::filesystem::temp_directory_path() / "moivre_family_file_test";
  std::filesystem::create_directories(folder);
  const std::string path = (folder / "f.family").string();
  const FamilyFile file = conics_file();
  save_family(file, path);
  EXPECT_EQ(load_family(path), file);
  save_family(file, path);
  EXPECT_EQ(load_family(path), file);
  EXPECT_THROW(save_family(file, (folder / "none" / "f.family").string()), std::invalid_argument);
  EXPECT_FALSE(std::filesystem::exists(path + ".part"));
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace moivre
