// SPDX-License-Identifier: MIT
// Is double-double in lanes what it is in one number? On every instruction set of the machine,
// against the scalar type and exactly.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "lane_double_double_test.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "lane_double_double-inl.h"
#include "lane_step-inl.h"
#include "moivre/numeric/integer.h"
#include "moivre/start/total_degree.h"

#ifndef MOIVRE_LANE_DOUBLE_DOUBLE_TEST_ONCE
#define MOIVRE_LANE_DOUBLE_DOUBLE_TEST_ONCE
namespace moivre {
namespace {

/// What the lanes are asked to compute of a, b and c; sums and products of doubles take their high
/// parts.
enum class Operation { two_sum, two_product, sum, product, quotient };

using Numbers = std::vector<ComplexDoubleDouble>;

}  // namespace
}  // namespace moivre
#endif

HWY_BEFORE_NAMESPACE();
namespace moivre {
namespace HWY_NAMESPACE {
namespace {

using Wide = LaneDoubleDouble;

Wide apply(Operation operation, const Wide& a, const Wide& b) {
  switch (operation) {
    case Operation::two_sum:
      return two_sum(a.hi, b.hi);
    case Operation::two_product:
      return two_product(a.hi, b.hi);
    case Operation::sum:
      return a + b;
    case Operation::product:
      return a * b;
    case Operation::quotient:
      return a / b;
  }
  return a;
}

/// results[i] = a[i] op b[i], real parts, in whichever lane i falls into.
void apply_all(Operation operation, const Numbers& a, const Numbers& b, Numbers& results) {
  LaneVector<Wide> cells(3);
  for (std::size_t i = 0; i < a.size(); ++i) {
    const std::size_t lane = i % W;
    cells.set(0, lane, a[i]);
    cells.set(1, lane, b[i]);
    if (lane + 1 < W && i + 1 < a.size()) continue;
    store({apply(operation, load(cells[0]).re, load(cells[1]).re), load(cells[0]).im}, cells[2]);
    for (std::size_t k = 0; k <= lane; ++k) results[i - lane + k] = cells.get(2, k);
  }
}

/// results[i] = c[i] + a[i] b[i].
void add_all_products(const Numbers& a, const Numbers& b, const Numbers& c, Numbers& results) {
  LaneVector<Wide> cells(4);
  for (std::size_t i = 0; i < a.size(); ++i) {
    cells.set(0, i % W, a[i]);
    cells.set(1, i % W, b[i]);
    cells.set(2, i % W, c[i]);
    store(add_product(load(cells[0]), load(cells[1]), load(cells[2])), cells[3]);
    results[i] = cells.get(3, i % W);
  }
}

/// The points of W paths at time t, from points near them, by lane steps of length 0.
void polish(const Homotopy& homotopy, const std::vector<Numbers>& points,
            const Time<ComplexDoubleDouble>& t, std::vector<Numbers>& results) {
  const HomotopyProgram<DoubleDouble> program = make_program<DoubleDouble>(homotopy);
  LanePath<Wide> path(homotopy.coordinates());
  LaneStep<Wide> step(homotopy, program);
  LaneTime<Wide> time;
  LaneReals none;
  for (std::size_t lane = 0; lane < W; ++lane) {
    path.place(lane, points[lane % points.size()]);
    time.set(lane, t, 1.0);
  }
  const Mask all = broadcast(1.0) > zeros();
  const Mask nowhere = broadcast(1.0) < zeros();
  constexpr int kRounds = 3;  // two corrections each, from 1e-9
  for (int round = 0; round < kRounds; ++round) {
    step.take(path, none, time);
    path.advance(nowhere, all, zeros(), step.corrected, step.tangent);
  }
  for (std::size_t lane = 0; lane < std::min(W, points.size()); ++lane) {
    for (std::size_t i = 0; i < homotopy.coordinates(); ++i) {
      results[lane][i] = step.corrected.get(i, lane);
    }
  }
}

std::size_t lanes() { return W; }

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace moivre
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <random>

#include "every_target.h"
#include "moivre/polynomial/read.h"
#include "moivre/tracker/double_double_tracker.h"
#include "moivre/tracker/fine_path_system.h"

namespace moivre {
namespace {

HWY_EXPORT(apply_all);
HWY_EXPORT(add_all_products);
HWY_EXPORT(polish);
HWY_EXPORT(lanes);

// Of a product, a sum of products, and a quotient (lane_double_double-inl.h).
const Rational kProductError = ratio(1, Integer(1) << 102U);
const Rational kScalarProductError = ratio(1, Integer(1) << 100U);
// To how many digits points of a path agree, whichever way they were corrected.
constexpr double kSamePoint = 1e-28;

Rational exact(const DoubleDouble& a) { return Rational(a.hi) + Rational(a.lo); }
bool same_bits(const DoubleDouble& a, const DoubleDouble& b) {
  return a.hi == b.hi && a.lo == b.lo;
}

/// Double-doubles of many sizes, some of them whole numbers, some the negative of the one before up
/// to the last digits.
Numbers some_numbers(unsigned seed) {
  constexpr int kCount = 600;
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> mantissa(-1, 1);
  std::uniform_int_distribution<int> exponent(-60, 60);
  const auto real = [&] {
    const double hi = std::ldexp(mantissa(random), exponent(random));
    return detail::quick_two_sum(hi, std::ldexp(hi * mantissa(random), -54));
  };
  Numbers numbers;
  for (int k = 0; k < kCount; ++k) {
    ComplexDoubleDouble z(real(), real());
    if (k % 7 == 0) z = {DoubleDouble(std::round(z.re.hi)), DoubleDouble(1)};
    if (k % 5 == 4) z.re = -numbers.back().re + DoubleDouble(std::ldexp(z.re.hi, -80));
    numbers.push_back(z);
  }
  return numbers;
}

Numbers results_of(Operation operation, const Numbers& a, const Numbers& b) {
  Numbers results(a.size());
  HWY_DYNAMIC_DISPATCH(apply_all)(operation, a, b, results);
  return results;
}

TEST(EveryTarget, AddsAndMultipliesDoublesWithoutErrorBitForBit) {
  const Numbers a = some_numbers(1);
  Numbers b = some_numbers(2);
  for (std::size_t i = 0; i < b.size(); i += 3) b[i].re = -a[i].re;
  test::on_every_target([&] {
    const Numbers sums = results_of(Operation::two_sum, a, b);
    const Numbers products = results_of(Operation::two_product, a, b);
    for (std::size_t i = 0; i < a.size(); ++i) {
      const double x = a[i].re.hi;
      const double y = b[i].re.hi;
      ASSERT_TRUE(same_bits(sums[i].re, detail::two_sum(x, y))) << i;
      ASSERT_TRUE(same_bits(products[i].re, detail::two_product(x, y))) << i;
      ASSERT_EQ(exact(sums[i].re), Rational(x) + Rational(y));
      ASSERT_EQ(exact(products[i].re), Rational(x) * Rational(y));
    }
  });
}

TEST(EveryTarget, AddsDoubleDoublesBitForBitAsOneAlone) {
  const Numbers a = some_numbers(3);
  Numbers b = some_numbers(4);
  for (std::size_t i = 0; i + 1 < b.size(); i += 4) b[i].re = -a[i + 1].re;
  test::on_every_target([&] {
    const Numbers sums = results_of(Operation::sum, a, b);
    for (std::size_t i = 0; i < a.size(); ++i) {
      ASSERT_TRUE(same_bits(sums[i].re, a[i].re + b[i].re)) << i;
    }
  });
}

TEST(EveryTarget, MultipliesAndDividesDoubleDoublesToTheirLastDigits) {
  Numbers a = some_numbers(5);
  Numbers b = some_numbers(6);
  for (ComplexDoubleDouble& x : b) {
    if (x.re.hi == 0) x.re = 3;
  }
  test::on_every_target([&] {
    const Numbers products = results_of(Operation::product, a, b);
    const Numbers quotients = results_of(Operation::quotient, a, b);
    for (std::size_t i = 0; i < a.size(); ++i) {
      const Rational product = exact(a[i].re) * exact(b[i].re);
      const Rational quotient = exact(a[i].re) / exact(b[i].re);
      ASSERT_LE(abs(exact(products[i].re) - product), abs(product) * kProductError) << i;
      ASSERT_LE(abs(exact(quotients[i].re) - quotient), abs(quotient) * kScalarProductError) << i;
    }
  });
}

TEST(EveryTarget, SumsComplexProductsToTheLastDigitsOfTheirTerms) {
  const Numbers a = some_numbers(7);
  const Numbers b = some_numbers(8);
  Numbers c = some_numbers(9);
  // All but cancelled by the product.
  for (std::size_t i = 0; i < c.size(); i += 2) c[i] = -product(a[i], b[i]);
  test::on_every_target([&] {
    Numbers results(a.size());
    HWY_DYNAMIC_DISPATCH(add_all_products)(a, b, c, results);
    for (std::size_t i = 0; i < a.size(); ++i) {
      const Rational rr = exact(a[i].re) * exact(b[i].re);
      const Rational ii = exact(a[i].im) * exact(b[i].im);
      const Rational re = exact(c[i].re) + rr - ii;
      const Rational size = abs(exact(c[i].re)) + abs(rr) + abs(ii);
      ASSERT_LE(abs(exact(results[i].re) - re), size * kScalarProductError) << i;
    }
  });
}

TEST(EveryTarget, KeepsANaNInItsLane) {
  test::on_every_target([&] {
    const std::size_t width = HWY_DYNAMIC_DISPATCH(lanes)();
    Numbers a(width, ComplexDoubleDouble(3.0));
    const Numbers b(width, ComplexDoubleDouble(7.0));
    a[0].re = std::numeric_limits<double>::quiet_NaN();
    const Numbers results = results_of(Operation::quotient, a, b);
    EXPECT_TRUE(std::isnan(results[0].re.hi));
    for (std::size_t i = 1; i < width; ++i) {
      EXPECT_TRUE(same_bits(results[i].re, DoubleDouble(3) / DoubleDouble(7)));
    }
  });
}

/// Largest difference of affine coordinates, in double-double.
double affine_distance(const Numbers& x, const Numbers& y) {
  double largest = 0;
  const ComplexDoubleDouble x0 = reciprocal(x.back());
  const ComplexDoubleDouble y0 = reciprocal(y.back());
  for (std::size_t i = 0; i + 1 < x.size(); ++i) {
    largest = std::max(largest, magnitude1(product(x[i], x0) - product(y[i], y0)));
  }
  return largest;
}

TEST(EveryTarget, FindsThePointOfAPathThatOneAloneFindsToTwentyEightDigits) {
  const System f = read_system({"test", "2\nx^3 + 2*x*y - y^2 - 1/3; y^3 - x^2*y + 4*x - 1;\n"});
  const TotalDegreeStart start = total_degree_start(degrees(f), 1);
  const Homotopy homotopy(f, start_system(start, f.variables));
  for (const double t : {0.375, 1.0}) {
    std::vector<Numbers> near;
    std::vector<Numbers> settled;
    for (std::uint64_t path = 0; path < start.paths; ++path) {
      PathSegment segment;
      segment.contour = Contour::segment(0, t);
      segment.x = start_point(start, path);
      const SegmentResult reached =
          follow(*make_double_double_tracker()->open(homotopy), segment, std::atomic<bool>{false});
      ASSERT_EQ(reached.status, SegmentStatus::arrived);
      Numbers x;
      const double norm = euclidean_norm(reached.x);
      for (const Complex& xi : reached.x) x.push_back(ComplexDoubleDouble(xi / norm * (1 + 1e-10)));
      x.front() += ComplexDoubleDouble(1e-9);
      near.push_back(x);
      FinePathSystem<ComplexDoubleDouble> one(homotopy);
      one.set_patch(x);
      ASSERT_TRUE(one.settle(x, reached.t, one.at_end()).converged);
      settled.push_back(x);
    }
    test::on_every_target([&] {
      const std::size_t width = std::min(HWY_DYNAMIC_DISPATCH(lanes)(), near.size());
      for (std::size_t first = 0; first + width <= near.size(); first += width) {
        const auto begin = near.begin() + static_cast<std::ptrdiff_t>(first);
        const std::vector<Numbers> some(begin, begin + static_cast<std::ptrdiff_t>(width));
        std::vector<Numbers> points(width, Numbers(homotopy.coordinates()));
        HWY_DYNAMIC_DISPATCH(polish)
        (homotopy, some, fine_time<ComplexDoubleDouble>(PathTime(t, 1 - t)), points);
        for (std::size_t k = 0; k < width; ++k) {
          EXPECT_LT(affine_distance(points[k], settled[first + k]), kSamePoint) << first + k;
        }
      }
    });
  }
}

}  // namespace
}  // namespace moivre
#endif
