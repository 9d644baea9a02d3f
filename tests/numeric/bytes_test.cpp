// SPDX-License-Identifier: MIT
// Are values read back to the last bit, and foreign bytes refused?
#include "moivre/numeric/bytes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "moivre/numeric/complex.h"
#include "moivre/numeric/fingerprint.h"

namespace moivre {
namespace {

TEST(Bytes, EveryNumberComesBackAsItWas) {
  ByteWriter writer;
  const double nothing = -0.0;
  writer.put(nothing);
  writer.put(std::numeric_limits<double>::denorm_min());
  writer.put(std::uint64_t{1} << 63);
  writer.put(Point{{1.0 / 3, -2e300}, {0, 5}});
  writer.put(std::vector<int>{});
  writer.put(std::string_view("a\0b", 3));
  writer.put(true);
  ByteReader reader(writer.bytes());
  EXPECT_TRUE(std::signbit(reader.get<double>()));
  EXPECT_EQ(reader.get<double>(), std::numeric_limits<double>::denorm_min());
  EXPECT_EQ(reader.get<std::uint64_t>(), std::uint64_t{1} << 63);
  EXPECT_EQ(reader.get_vector<Complex>(), (Point{{1.0 / 3, -2e300}, {0, 5}}));
  EXPECT_TRUE(reader.get_vector<int>().empty());
  EXPECT_EQ(reader.get_text(), std::string_view("a\0b", 3));
  EXPECT_TRUE(reader.get<bool>());
  EXPECT_TRUE(reader.is_at_end());
}

TEST(Bytes, ThoseThatEndTooSoonOrTooLateAreRefused) {
  ByteWriter writer;
  writer.put(std::vector<double>{1, 2, 3});
  const std::string bytes = writer.bytes();
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    ByteReader reader(std::string_view(bytes).substr(0, size));
    EXPECT_THROW(reader.get_vector<double>(), std::invalid_argument) << size;
  }
  ByteReader reader(bytes);
  reader.get<std::uint64_t>();
  EXPECT_THROW(reader.require_end(), std::invalid_argument);
}

TEST(Bytes, ABoolThatIsNeitherTrueNorFalseIsRefused) {
  EXPECT_TRUE(ByteReader(std::string_view("\x01", 1)).get<bool>());
  EXPECT_FALSE(ByteReader(std::string_view("\x00", 1)).get<bool>());
  EXPECT_THROW(ByteReader(std::string_view("\x1f", 1)).get<bool>(), std::invalid_argument);
}

TEST(Fingerprint, OrderLengthAndEveryBitCount) {
  EXPECT_EQ(fingerprint_of("abc"), fingerprint_of("abc"));
  EXPECT_NE(fingerprint_of("abc"), fingerprint_of("acb"));
  EXPECT_NE(fingerprint_of("a"), fingerprint_of(std::string_view("a\0", 2)));
  EXPECT_NE(fingerprint_of(""), fingerprint_of(std::string(8, '\0')));
  FingerprintMaker plus, minus;
  plus.add(0.0);
  minus.add(-0.0);
  EXPECT_NE(plus.fingerprint(), minus.fingerprint());
}

}  // namespace
}  // namespace moivre
