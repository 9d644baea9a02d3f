// SPDX-License-Identifier: MIT
// Does the predictor reproduce polynomials as far as its nodes determine them, with all digits, and
// is its order twice their number?
#include "moivre/tracker/hermite_predictor.h"

#include <gtest/gtest.h>

#include "moivre/numeric/log_ratio.h"

namespace moivre {
namespace {

using Number = ComplexDoubleDouble;
using Node = HermiteNode<Number>;

struct Known {
  std::vector<Number> x, dx;
};

/// w^k and its derivative, times `unit`.
Known power(double w, int k, double unit) {
  Number x(unit);
  Number dx(0.0);
  for (int j = 0; j < k; ++j) {
    dx = product(DoubleDouble(w), dx) + x;
    x = product(DoubleDouble(w), x);
  }
  return {{x}, {dx}};
}

/// Of w^k by nodes at 0.9, 0.8, ..., at 1; and the size of the last term.
std::pair<double, double> error_at_one(int k, std::size_t nodes) {
  std::vector<Known> known;
  for (std::size_t i = 0; i < nodes; ++i) {
    known.push_back(power(1 - 0.0625 * static_cast<double>(i + 1), k, 1));
  }
  std::vector<Node> list;
  for (std::size_t i = 0; i < nodes; ++i) {
    list.push_back({DoubleDouble(1 - 0.0625 * static_cast<double>(i + 1)), DoubleDouble(1.0),
                    &known[i].x, &known[i].dx});
  }
  std::vector<Number> y(1);
  HermitePredictor<Number> predictor;
  const double last = predictor.predict(list, DoubleDouble(1.0), y);
  return {std::abs(to_complex(y[0] - Number(1.0))), last};
}

TEST(HermitePredictor, ReproducesPolynomialsOfDegreeBelowTwiceTheNodes) {
  for (std::size_t nodes = 1; nodes <= HermitePredictor<Number>::kMostNodes; ++nodes) {
    const int degree = static_cast<int>(2 * nodes);
    EXPECT_LT(error_at_one(degree - 1, nodes).first, 1e-27) << nodes;
    // (w - w_1)^2 ... (w - w_k)^2, of a polynomial with leading coefficient 1.
    double rest = 1;
    for (std::size_t i = 1; i <= nodes; ++i) rest *= std::pow(0.0625 * static_cast<double>(i), 2);
    EXPECT_NEAR(error_at_one(degree, nodes).first, rest, 1e-10 * rest) << nodes;
  }
}

TEST(HermitePredictor, TellsTheTermOfHighestDegree) {
  EXPECT_EQ(error_at_one(1, 1).second, std::numeric_limits<double>::infinity());
  EXPECT_LT(error_at_one(2, 2).second, 1e-27);
  EXPECT_GT(error_at_one(3, 2).second, 1e-6);
}

TEST(HermitePredictor, TakesDerivativesWithTheirSlope) {
  const Known known = power(2, 1, 1);
  std::vector<Number> y(1);
  HermitePredictor<Number> predictor;
  predictor.predict(std::vector<Node>{{DoubleDouble(2.0), DoubleDouble(0.5), &known.x, &known.dx}},
                    DoubleDouble(6.0), y);
  EXPECT_EQ(to_complex(y[0]), Complex(4));
}

TEST(LogRatio, HasAllDigits) {
  const LogRatio<Number> log_ratio;
  // log 2 and log 10, to 32 digits.
  const DoubleDouble log2{0x1.62e42fefa39efp-1, 0x1.abc9e3b39803fp-56};
  const DoubleDouble log10{0x1.26bb1bbb55516p+1, -0x1.f48ad494ea3e9p-53};
  const auto difference = [](DoubleDouble a, DoubleDouble b) { return std::abs((a - b).hi); };
  EXPECT_LT(difference(log_ratio(2, 1), log2), 1e-31);
  EXPECT_LT(difference(log_ratio(10, 1), log10), 1e-30);
  EXPECT_LT(difference(log_ratio(1, 10), -log10), 1e-30);
  EXPECT_LT(difference(log_ratio(7, 7), DoubleDouble(0.0)), 1e-31);
  EXPECT_LT(difference(log_ratio(1e300, 1e-300),
                       DoubleDouble(0.0) + log_ratio(1e300, 1) + log_ratio(1, 1e-300)),
            1e-27);
}

}  // namespace
}  // namespace moivre
