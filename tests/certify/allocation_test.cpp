// SPDX-License-Identifier: MIT
// Does a certificate in double allocate anything, once its certifier and its result are there?
// Every operator new is counted.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "moivre/certify/certifier.h"
#include "planted.h"

namespace {

std::atomic<std::size_t> allocations{0};

}  // namespace

void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  ++allocations;
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

}  // namespace
}  // namespace moivre::test
