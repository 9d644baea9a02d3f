// SPDX-License-Identifier: MIT
// Does a certificate in double allocate anything, once its certifier and its result are there? What
// does a proof take where there are a million?
// Every operator new is counted.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "moivre/certify/certifier.h"
#include "moivre/certify/distinct.h"
#include "moivre/numeric/random.h"
#include "planted.h"

namespace {

std::atomic<std::size_t> allocations{0};
std::atomic<std::size_t> allocated_bytes{0};

}  // namespace

void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  ++allocations;
  allocated_bytes += size;
  return std::malloc(size > 0 ? size : 1);
}
void* operator new(std::size_t size) {
  if (void* memory = operator new(size, std::nothrow)) return memory;
  throw std::bad_alloc();
}
// Inlined, the call of free would look to g++ as if it met memory of another kind.
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace moivre::test {
namespace {

TEST(Certifier, AllocatesNothingWhereDoubleIsEnough) {
  const Planted p = planted(3, 4, Factors::real);
  Certifier certifier(make_certify_program(p.f));
  std::vector<Point> points;
  for (const ExactPoint& root : p.roots) points.push_back(to_double(root));
  Certificate result = certifier.certify(points.front());
  const std::size_t before = allocations;
  std::size_t certified = 0;
  for (const Point& x : points) {
    certifier.certify(x, result);
    certified += result.verdict == Verdict::certified && result.bits == kDoubleBits;
  }
  EXPECT_EQ(allocations, before);
  EXPECT_EQ(certified, points.size());
}

TEST(Certificate, TakesNoMoreBytesWhereDoubleIsEnough) {
  static_assert(sizeof(Certificate) <= 56);
  constexpr std::size_t kUnknowns = 20;
  const std::vector<double> radii(kUnknowns, 1e-8);
  const std::vector<double> errors(kUnknowns, 1e-15);
  const std::size_t before = allocated_bytes;
  const BallSizes sizes(radii, errors);
  EXPECT_EQ(allocated_bytes - before, 4 * kUnknowns);
}

TEST(Distinct, TakesThirtyTwoBytesOfEachCertificateInAll) {
  constexpr std::size_t kCount = 10'000;
  std::vector<Certificate> certificates(kCount);
  std::vector<const Certificate*> all;
  for (std::size_t k = 0; k < kCount; ++k) {
    Certificate& c = certificates[k];
    c.verdict = Verdict::certified;
    c.midpoint = {random_phase(1, RandomStream::test, k)};
    c.sizes = BallSizes(std::vector{1e-8}, std::vector{1e-15});
    all.push_back(&c);
  }
  const std::size_t before = allocated_bytes;
  EXPECT_EQ(compare(all).distinct_roots, kCount);
  EXPECT_LT(allocated_bytes - before, 32 * kCount + 1000);
}

}  // namespace
}  // namespace moivre::test
