// SPDX-License-Identifier: MIT
// Is any certificate ever untrue? Fabricated candidates of planted systems, each verdict judged in
// exact arithmetic.
//
// Candidates: roots moved by 1e-1 to 1e-14, middles between roots (saddle points where they are
// neighbours), real parts of roots that are not real, random points, roots of the system with one
// coefficient changed. `systems` of them, each with some 60 candidates and accuracies from 1e-10 to
// 1.
#pragma once

#include <gtest/gtest.h>

#include <iterator>

#include "moivre/certify/certifier.h"
#include "moivre/numeric/random.h"
#include "planted.h"

namespace moivre::test {

struct FalseRootCounts {
  std::size_t candidates = 0, certified = 0, elsewhere = 0, refused = 0, without_root = 0;
};

inline std::vector<Point> fabricated(const Planted& p, std::uint64_t seed) {
  std::uint64_t next = 1000;
  const auto unit = [&] { return random_unit(seed, RandomStream::test, next++); };
  const auto pick = [&] {
    return to_double(
        p.roots[static_cast<std::size_t>(unit() * static_cast<double>(p.roots.size()))]);
  };
  std::vector<Point> points;
  for (int exponent = 1; exponent <= 14; ++exponent) {
    for (int k = 0; k < 2; ++k) {
      Point x = pick();
      for (Complex& xj : x)
        xj += std::pow(10.0, -exponent) * Complex(2 * unit() - 1, 2 * unit() - 1);
      points.push_back(x);
    }
  }
  for (int k = 0; k < 12; ++k) {
    Point x = pick();
    const Point y = pick();
    for (std::size_t j = 0; j < x.size(); ++j) x[j] = 0.5 * (x[j] + y[j]);
    points.push_back(x);
  }
  for (int k = 0; k < 8; ++k) {
    Point x = pick();
    for (Complex& xj : x) xj = xj.real();
    points.push_back(x);
  }
  for (int k = 0; k < 12; ++k) {
    Point x = pick();
    for (Complex& xj : x) xj = 6.0 * Complex(unit() - 0.5, k % 2 == 0 ? 0 : unit() - 0.5);
    points.push_back(x);
  }
  return points;
}

inline FalseRootCounts expect_no_untruth(std::uint64_t first_seed, std::uint64_t systems) {
  constexpr double kAccuracies[] = {1e-10, 1e-6, 1e-2, 1.0};
  // Has no factor in common with the number of accuracies, so that Arb meets every one of them.
  constexpr std::size_t kArbEvery = 9;
  constexpr Factors kKinds[] = {Factors::real, Factors::conjugate_pairs, Factors::complex,
                                Factors::repeated};
  FalseRootCounts counts;
  for (std::uint64_t seed = first_seed; seed < first_seed + systems; ++seed) {
    const Planted p = planted(seed, 1 + static_cast<std::uint32_t>(seed / 4 % 3), kKinds[seed % 4]);
    const auto program = make_certify_program(p.f);
    std::size_t next = 0;
    for (const Point& x : fabricated(p, seed)) {
      CertifyOptions options;
      options.accuracy = kAccuracies[next % std::size(kAccuracies)];
      options.most_bits = next % kArbEvery == 0 ? 256 : kDoubleBits;
      ++next;
      const Certificate c = Certifier(program, options).certify(x);
      EXPECT_EQ(untruth(c, p, x, options.accuracy), "") << seed;
      ++counts.candidates;
      counts.certified += c.verdict == Verdict::certified;
      counts.elsewhere += c.verdict == Verdict::elsewhere;
      counts.refused += c.verdict == Verdict::undecided;
      bool near = false;
      for (const ExactPoint& root : p.roots) {
        near = near ||
               distance(to_double(root), x) <= options.accuracy * std::max(1.0, max_norm(x)) * 1.01;
      }
      counts.without_root += !near;
      if (!near) {
        EXPECT_NE(c.verdict, Verdict::certified) << seed;
      }
    }
  }
  return counts;
}

}  // namespace moivre::test
