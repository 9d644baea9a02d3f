// SPDX-License-Identifier: MIT
// Are simple roots certified, with balls that hold them, real or not as they are; and is what
// cannot be asked refused?
#include "moivre/certify/certifier.h"

#include <gtest/gtest.h>

#include "moivre/numeric/double_double.h"
#include "planted.h"

namespace moivre::test {
namespace {

constexpr double kAccuracy = CertifyOptions().accuracy;

Certificate certified(const std::string& text, const Point& x, int most_bits = kMostArbBits) {
  CertifyOptions options;
  options.most_bits = most_bits;
  return Certifier(make_certify_program(system_of(text)), options).certify(x);
}

/// (x - 1)^2 - sign delta^2 with delta = 2^-k.
System pair_at_distance(int sign, int k) {
  System f;
  f.variables = {"x"};
  Rational squared = 1;
  for (int i = 0; i < 2 * k; ++i) squared /= 2;
  const Polynomial line = unknown(0) + constant({-1, 0});
  f.polynomials = {line * line + constant({sign < 0 ? squared : -squared, 0})};
  return f;
}

TEST(Certifier, ProvesTheSquareRootOfTwo) {
  const Certificate c = certified("1\nx^2 - 2;\n", {1.414213562});
  ASSERT_EQ(c.verdict, Verdict::certified);
  EXPECT_EQ(c.reality, Reality::real);
  EXPECT_EQ(c.bits, kDoubleBits);
  EXPECT_EQ(c.midpoint[0].real(), std::sqrt(2.0));
  // sqrt(2) = 1.4142135623730950488...: its nearest double is 9.67e-17 off.
  EXPECT_GE(c.error(0), 9.667e-17);
  EXPECT_LE(c.error(0), 1.1e-16);
  EXPECT_GT(c.radius(0), 1e-14);
}

// x^2 = p and p within 1e-3 of 2: one root whatever p is, and all of them lie within the error
// told.
TEST(Certifier, ProvesARootForEveryValueOfAGivenNumber) {
  Certifier certifier(make_certify_program(system_of("1 2\nx^2 - p;\n"), 1));
  const std::vector<Enclosure> given{{2, {}, 1e-3}};
  const Certificate c = certifier.certify(Point{1.4142135623}, given);
  ASSERT_EQ(c.verdict, Verdict::elsewhere);  // it is not known to lie within the accuracy of 1e-6
  const double farthest = 1.4142135623730951 - std::sqrt(1.999);
  EXPECT_GE(c.error(0), farthest);
  EXPECT_LE(c.error(0), 1.5 * farthest);
}

TEST(Certifier, RefusesAGivenNumberThatMayMakeTwoRootsOne) {
  Certifier certifier(make_certify_program(system_of("1 2\nx^2 - p;\n"), 1));
  const std::vector<Enclosure> given{{1e-8, {}, 2e-8}};
  EXPECT_FALSE(certifier.certify(Point{1e-4}, given).holds_root());
}

// x^2 = 2, then y^3 = x and z = y^6, which is 2. The ball of z shrinks with that of x.
TEST(Certifier, ProvesBlocksInTurnFromTheBallsBefore) {
  Certifier first(make_certify_program(system_of("1\nx^2 - 2;\n")));
  Certifier second(make_certify_program(system_of("2 3\nz - y^6;\ny^3 - x;\n"), 1));
  Certificate x = first.certify(Point{1.4142135623730951});
  std::vector<Enclosure> given{enclosure(x, 0)};
  Certificate y = second.certify(Point{2, 1.122462048309373}, given);
  ASSERT_EQ(y.verdict, Verdict::certified);
  EXPECT_LE(y.error(0), 1e-14);
  ASSERT_TRUE(first.sharpen(x, 256));
  given = {enclosure(x, 0)};
  ASSERT_TRUE(second.sharpen(y, 256, given));
  EXPECT_LE(y.error(0), 1e-70);
  const Enclosure z = enclosure(y, 0);
  double apart = std::abs(z.middle - 2.0);
  for (const Complex& part : z.finer) apart += std::abs(part);
  EXPECT_LE(apart, z.error);
}

TEST(Certifier, RefusesTooFewGivenNumbers) {
  Certifier certifier(make_certify_program(system_of("1 2\nx^2 - p;\n"), 1));
  EXPECT_THROW(certifier.certify(Point{1}), std::invalid_argument);
  EXPECT_THROW(make_certify_program(system_of("1 2\nx^2 - p;\n")), std::invalid_argument);
}

TEST(Certifier, ProvesForTheExactCoefficients) {
  const Certificate c = certified("1\nx - 0.1;\n", {0.1});
  ASSERT_EQ(c.verdict, Verdict::certified);
  EXPECT_TRUE(lies_within({{Rational(1, 10), 0}}, c, &Certificate::error));
  // The double nearest to 0.1 is 5.55e-18 off.
  EXPECT_GE(c.error(0), 5.55e-18);
  EXPECT_LE(c.error(0), 1e-17);
}

TEST(Certifier, ProvesEverySimpleRootOfPlantedSystemsInDouble) {
  for (const Factors kind : {Factors::real, Factors::conjugate_pairs, Factors::complex}) {
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
      const Planted p = planted(seed, 1 + static_cast<std::uint32_t>(seed % 4), kind);
      Certifier certifier(make_certify_program(p.f));
      for (std::size_t k = 0; k < p.roots.size(); ++k) {
        if (p.multiplicity[k] != 1) continue;
        const Point x = to_double(p.roots[k]);
        const Certificate c = certifier.certify(x);
        EXPECT_EQ(c.verdict, Verdict::certified) << seed << ' ' << k;
        EXPECT_EQ(untruth(c, p, x, kAccuracy), "") << seed;
        if (kind != Factors::complex) {
          EXPECT_NE(c.reality, Reality::unknown) << seed << ' ' << k;
        }
      }
    }
  }
}

TEST(Certifier, CoversWhatDoubleDoubleRoundsOfAResidual) {
  // c is m^3 rounded to double-double, so that the residual at m vanishes there, but not exactly.
  const double m = 1.1;
  const DoubleDouble rounded = DoubleDouble(m) * DoubleDouble(m) * DoubleDouble(m);
  const Rational c = Rational(rounded.hi) + Rational(rounded.lo);
  System f = system_of("1\nx^3 - 1;\n");
  f.polynomials[0] = unknown(0) * unknown(0) * unknown(0) + constant({-c, 0});
  const Certificate proved = Certifier(make_certify_program(f)).certify(Point{m});
  ASSERT_EQ(proved.bits, kDoubleBits);
  const Rational middle(proved.midpoint[0].real()), e(proved.error(0));
  const Rational below = middle - e, above = middle + e;
  EXPECT_LT(below * below * below, c);
  EXPECT_GT(above * above * above, c);
  EXPECT_LT(proved.error(0), 1e-28);
}

TEST(Certifier, CoversWhatDoubleDoubleRoundsOfACoefficient) {
  // x / 3 = 1/3 + 2^-112: both sides have the same double-double, and the root is 1 + 3 2^-112.
  const Rational third(1, 3), beyond(0x1p-112);
  System f = system_of("1\nx - 1;\n");
  f.polynomials[0] = Coefficient{third, 0} * unknown(0) + constant({-(third + beyond), 0});
  const Certificate c = Certifier(make_certify_program(f)).certify(Point{1});
  ASSERT_EQ(c.bits, kDoubleBits);
  EXPECT_EQ(c.midpoint[0], 1.0);
  EXPECT_TRUE(lies_within({{1 + 3 * beyond, 0}}, c, &Certificate::error));
  EXPECT_LT(c.error(0), 1e-29);
}

TEST(Certifier, TellsRealFromNearlyReal) {
  // Pairs from 1/2 to 2^-400 from their real part: the distance passes through every radius that
  // double tries.
  for (int k = 1; k <= 400; k += k < 60 ? 1 : 17) {
    for (const int sign : {1, -1}) {
      const System f = pair_at_distance(sign, k);
      const double delta = std::ldexp(1.0, -k);
      const Complex x = sign > 0 ? Complex(1 + delta) : Complex(1, delta);
      // Where a double has no room for the root, Newton's method needs a start beside it.
      const Complex start = sign > 0 && k > 50 ? Complex(1 + 1e-9) : x;
      const Certificate c = Certifier(make_certify_program(f)).certify(Point{start});
      ASSERT_EQ(c.verdict, Verdict::certified) << sign << ' ' << k;
      EXPECT_EQ(c.reality, sign > 0 ? Reality::real : Reality::not_real) << sign << ' ' << k;
    }
  }
}

TEST(Certifier, NeverCallsAPairRealWithDoubleAlone) {
  CertifyOptions options;
  options.most_bits = kDoubleBits;
  int unknown_reality = 0;
  for (int k = 20; k <= 60; ++k) {
    for (double share = 0.5; share < 2; share += 0.07) {
      const double delta = std::ldexp(share, -k);
      System f = pair_at_distance(-1, 0);
      const Polynomial line = unknown(0) + constant({-1, 0});
      f.polynomials = {line * line + constant({Rational(delta) * Rational(delta), 0})};
      Certifier certifier(make_certify_program(f), options);
      for (const double im : {delta, delta * 0.999, delta * (1 - 1e-12)}) {
        const Certificate c = certifier.certify(Point{Complex(1, im)});
        EXPECT_NE(c.reality, Reality::real) << delta;
        unknown_reality += c.holds_root() && c.reality == Reality::unknown;
      }
    }
  }
  RecordProperty("unknown", unknown_reality);
}

TEST(Certifier, CertifiesConditionsOf1e12InDouble) {
  // The second equation is the first and 1e-12 of a line: the roots are (1, 1) and (-1, -1).
  const Certificate c =
      certified("2\nx^2 + y^2 - 2;\nx^2 + y^2 - 2 + 0.000000000001*x - 0.000000000001*y;\n",
                {1 + 1e-8, 1 - 1e-8}, kDoubleBits);
  ASSERT_EQ(c.verdict, Verdict::certified);
  EXPECT_EQ(c.reality, Reality::real);
  EXPECT_TRUE(lies_within({{1, 0}, {1, 0}}, c, &Certificate::error));
}

TEST(Certifier, TakesMoreDigitsWhereDoubleHasNotEnough) {
  const std::string text = "2\nx^2 + y^2 - 2;\nx^2 + y^2 - 2 + 1e-30*x - 1e-30*y;\n";
  EXPECT_EQ(certified(text, {1, 1 + 1e-9}, kDoubleBits).verdict, Verdict::undecided);
  const Certificate c = certified(text, {1, 1 + 1e-9});
  ASSERT_EQ(c.verdict, Verdict::certified);
  EXPECT_GE(c.bits, kFirstArbBits);
  EXPECT_TRUE(lies_within({{1, 0}, {1, 0}}, c, &Certificate::error));
}

// Its Jacobian is 1e-173. In few digits Newton's method is lost in rounding errors, which says
// nothing of the point.
TEST(Certifier, ProvesOneOfThirtyRootsWithinAMillionth) {
  const Certificate c = certified("1\n(x - 1)^30 - 1e-180;\n", {1.000001});
  ASSERT_EQ(c.verdict, Verdict::certified);
  EXPECT_EQ(c.bits, 2048);
  EXPECT_LT(c.error(0), 2e-16);
}

TEST(Certifier, TakesCoefficientsThatNoDoubleHolds) {
  Rational huge = 1;
  for (int k = 0; k < 400; ++k) huge *= 10;
  System f = system_of("1\nx^2 - 4;\n");
  f.polynomials[0] = constant({huge, 0}) * f.polynomials[0];
  const Certificate c = Certifier(make_certify_program(f)).certify(Point{2 + 1e-9});
  ASSERT_EQ(c.verdict, Verdict::certified);
  EXPECT_TRUE(lies_within({{2, 0}}, c, &Certificate::error));
  EXPECT_EQ(c.reality, Reality::real);
}

TEST(Certifier, TakesUnknownsOfAllSizes) {
  const std::string text = "2\nx - 1e12;\nx*y - 1;\n";
  const Certificate c = certified(text, {1e12, 1e-12}, kDoubleBits);
  ASSERT_EQ(c.verdict, Verdict::certified);
  EXPECT_LT(c.error(1), 1e-27);
  const Certificate tiny = certified("2\nx - 1e-100;\nx*y - 1e-90;\n", {1e-100, 1e10}, kDoubleBits);
  EXPECT_EQ(tiny.verdict, Verdict::certified);
}

TEST(Certifier, TakesCoordinatesThatVanish) {
  const Certificate c =
      certified("3\nx^2 - y - 1;\ny^2 + y;\nz*x + y*z + 3*y;\n", {1, 1e-17, -1e-15});
  ASSERT_EQ(c.verdict, Verdict::certified);
  EXPECT_EQ(c.reality, Reality::real);
  EXPECT_TRUE(lies_within({{1, 0}, {0, 0}, {0, 0}}, c, &Certificate::error));
  EXPECT_EQ(certified("2\nx + y^2;\ny + x^2;\n", {0, 0}).verdict, Verdict::certified);
}

TEST(Certifier, NeverCertifiesMultipleRoots) {
  for (const double off : {0.0, 1e-14, 1e-9, 1e-7}) {
    EXPECT_EQ(certified("2\nx^2 - 2*x + 1;\ny - x;\n", {1 + off, 1 - off}).verdict,
              Verdict::undecided);
    EXPECT_EQ(certified("1\nx^5;\n", {off}).verdict, Verdict::undecided);
  }
  // Double roots that Newton's method never meets exactly: it has a J to work with until the end.
  EXPECT_EQ(certified("1\nx^4 - 4*x^2 + 4;\n", {1.41421356}).verdict, Verdict::undecided);
  EXPECT_EQ(certified("2\nx^2 - 2/3*x + 1/9;\n3*y - x;\n", {1.0 / 3, 1.0 / 9}).verdict,
            Verdict::undecided);
  // Griewank and Osborne: multiplicity 3 at the origin.
  EXPECT_EQ(certified("2\n29/16*x^3 - 2*x*y;\ny - x^2;\n", {1e-8, 1e-9}).verdict,
            Verdict::undecided);
  // A curve of roots.
  EXPECT_EQ(certified("2\nx*y;\nx*y^2;\n", {1, 0}).verdict, Verdict::undecided);
  EXPECT_EQ(certified("1\nx - x;\n", {1}).verdict, Verdict::undecided);
}

TEST(Certifier, NamesARootThatLiesElsewhere) {
  const Certificate c = certified("1\nx^2 - 2;\n", {1.41422});
  EXPECT_NE(c.verdict, Verdict::certified);
  CertifyOptions options;
  options.accuracy = 1e-5;
  Certifier certifier(make_certify_program(system_of("1\nx^2 - 2;\n")), options);
  EXPECT_EQ(certifier.certify(Point{1.41422}).verdict, Verdict::certified);
  EXPECT_EQ(certifier.certify(Point{1.4142135623730951 + 1.5e-5}).verdict, Verdict::elsewhere);
  EXPECT_EQ(certifier.certify(Point{0.0}).verdict, Verdict::undecided);
  EXPECT_EQ(certifier.certify(Point{NAN}).verdict, Verdict::undecided);
  EXPECT_EQ(certifier.certify(Point{HUGE_VAL}).verdict, Verdict::undecided);
}

// Unknowns from 1e-3 to 1e12: double proves one root in a ball whose radius says nothing of its
// place.
TEST(Certifier, NeverTakesAWideBallForARootThatLiesElsewhere) {
  const std::string text =
      "4\n-7e-6*x*y-9542e6*x*z+1000*x-1e-8*w-0.008*z-8e-6;\n"
      "1e14*x*z-2488000*w*z+1e11*x+w+4e-7*y-915300000*z+800;\n"
      "-690.4*y*z-1e14*x+7000*w+200000;\n-1e12*x*w+10*w^2-1e14*x-1e-4*y-685500000;\n";
  CertifyOptions options;
  options.accuracy = 1e-5;
  const Point root = {0.00943634866715079, 1365039209385.6162, -0.0010012863619358792,
                      -100.08709976450153};
  options.most_bits = kDoubleBits;
  const auto program = make_certify_program(system_of(text));
  EXPECT_EQ(Certifier(program, options).certify(root).verdict, Verdict::elsewhere);
  options.most_bits = kMostArbBits;
  EXPECT_EQ(Certifier(program, options).certify(root).verdict, Verdict::certified);
}

TEST(Certifier, SaysNothingOfRealityWhereFIsNotReal) {
  // Roots 1 and i: the first is real, which conjugates cannot show.
  const std::string text = "1\nx^2 - x - i*x + i;\n";
  EXPECT_EQ(certified(text, {1}).reality, Reality::unknown);
  EXPECT_EQ(certified(text, {Complex(0, 1)}).reality, Reality::not_real);
  EXPECT_EQ(certified(text, {1}).bits, kDoubleBits);
}

TEST(Certifier, SharpensTheSameRoot) {
  const Planted p = planted(5, 3, Factors::conjugate_pairs);
  Certifier certifier(make_certify_program(p.f));
  for (std::size_t k = 0; k < p.roots.size(); ++k) {
    if (p.multiplicity[k] != 1) continue;
    const Point x = to_double(p.roots[k]);
    Certificate c = certifier.certify(x);
    for (const int bits : {128, 256, 512}) {
      ASSERT_TRUE(certifier.sharpen(c, bits)) << k << ' ' << bits;
      EXPECT_EQ(c.bits, bits);
      EXPECT_EQ(untruth(c, p, x, kAccuracy), "");
      // Conditions up to 1e9 take their part of the digits.
      EXPECT_LT(c.sizes.largest_error(), std::exp2(-0.8 * bits));
    }
  }
}

TEST(Certifier, SharpensNoOtherRootThanThatOfTheBall) {
  // True, but wide: x = 0 is the one root of x^3 - x within 0.5 of 0.48, and Newton's method goes
  // from there to -1.
  Certificate c;
  c.verdict = Verdict::certified;
  c.bits = kDoubleBits;
  c.midpoint = {0.48, 0};
  c.sizes = BallSizes(std::vector{0.5, 10.0}, std::vector{0.484375, 9.0});
  Certifier certifier(make_certify_program(system_of("2\nx^3 - x;\ny;\n")));
  EXPECT_FALSE(certifier.sharpen(c, 128));
  EXPECT_EQ(c.midpoint[0], 0.48);
  EXPECT_EQ(c.bits, kDoubleBits);
}

// The ball about another of its points lies within it, and holds the root with its error.
TEST(Certifier, TellsTheSameProofAboutAnotherPoint) {
  const Planted p = planted(4, 3, Factors::conjugate_pairs);
  Certifier certifier(make_certify_program(p.f));
  std::size_t told = 0;
  for (std::size_t k = 0; k < p.roots.size(); ++k) {
    if (p.multiplicity[k] != 1) continue;
    const Point x = to_double(p.roots[k]);
    const Certificate c = certifier.certify(x);
    ASSERT_TRUE(c.finer.empty()) << k;
    for (const double share : {0.0, 0.01, 0.4, 1.0}) {
      Point moved = c.midpoint;
      for (std::size_t j = 0; j < moved.size(); ++j)
        moved[j] += share * Complex(0.6, -0.8) * c.radius(j);
      const auto same = about(c, moved);
      EXPECT_EQ(same.has_value(), share < 1) << k << ' ' << share;
      if (!same) continue;
      ++told;
      EXPECT_EQ(same->midpoint, moved);
      EXPECT_EQ(same->reality, c.reality);
      EXPECT_EQ(untruth(*same, p, x, 1), "");
      for (std::size_t j = 0; j < moved.size(); ++j) {
        const Rational re = Rational(moved[j].real()) - Rational(c.midpoint[j].real());
        const Rational im = Rational(moved[j].imag()) - Rational(c.midpoint[j].imag());
        const Rational room = Rational(c.radius(j)) - Rational(same->radius(j));
        EXPECT_LE(re * re + im * im, room * room) << k << ' ' << j;
        const Rational more = Rational(same->error(j)) - Rational(c.error(j));
        EXPECT_LE(re * re + im * im, more * more) << k << ' ' << j;
      }
    }
  }
  EXPECT_GT(told, 50U);
}

TEST(Certifier, GivesTheSameForAnyNumberOfThreads) {
  const Planted p = planted(2, 3, Factors::conjugate_pairs);
  std::vector<Point> points;
  for (const ExactPoint& root : p.roots) points.push_back(to_double(root));
  const auto one = certify(p.f, points);
  const auto three = certify(p.f, points, {}, 3);
  for (std::size_t k = 0; k < points.size(); ++k) {
    EXPECT_EQ(one[k].midpoint, three[k].midpoint);
    EXPECT_EQ(one[k].sizes, three[k].sizes);
    EXPECT_EQ(one[k].reality, three[k].reality);
  }
  std::atomic<bool> stop{true};
  EXPECT_EQ(certify(p.f, points, {}, 2, stop)[0].bits, 0);
}

TEST(Certifier, RefusesWhatItCannotServe) {
  const System f = system_of("1\nx^2 - 2;\n");
  EXPECT_THROW(make_certify_program(system_of("1 2\nx*y - 1;\n")), std::invalid_argument);
  EXPECT_THROW(make_certify_program(System()), std::invalid_argument);
  CertifyOptions options;
  options.most_bits = 52;
  EXPECT_THROW(certify(f, {}, options), std::invalid_argument);
  options = CertifyOptions();
  options.accuracy = 0;
  EXPECT_THROW(certify(f, {}, options), std::invalid_argument);
  EXPECT_THROW(certify(f, {{1, 2}}), std::invalid_argument);
  Certifier certifier(make_certify_program(f));
  EXPECT_THROW(certifier.certify(Point{1, 2}), std::invalid_argument);
  Certificate nothing;
  nothing.midpoint = {1};
  EXPECT_THROW(certifier.sharpen(nothing, 128), std::invalid_argument);
}

}  // namespace
}  // namespace moivre::test
