// SPDX-License-Identifier: MIT
// Exponents of two from a point, and what they make of every term.
#include "moivre/homotopy/frame.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "moivre/homotopy/homotopy.h"

namespace moivre {
namespace {

Point scaled(Point x, const std::vector<int>& log2, int sign) {
  if (log2.empty()) return x;
  for (std::size_t j = 0; j < x.size(); ++j) {
    x[j] = {std::ldexp(x[j].real(), sign * log2[j]), std::ldexp(x[j].imag(), sign * log2[j])};
  }
  return x;
}

}  // namespace

PathFrame frame_at(const Homotopy& homotopy, const Point& x) {
  PathFrame frame;
  const double x0 = std::abs(homotopy.chart().x0(x));
  for (const Complex& xj : x) {
    const double ratio = std::abs(xj) / x0;
    const bool has_size = ratio > 0 && std::isfinite(ratio);
    frame.log2.push_back(has_size ? static_cast<int>(std::lround(std::log2(ratio))) : 0);
  }
  for (std::size_t i = 0; i < homotopy.equations(); ++i) {
    const std::vector<Term>& terms = homotopy.support().polynomials[i].terms;
    std::vector<double> shift;
    double largest = -std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < terms.size(); ++k) {
      double sum = 0;
      for (const Power& power : terms[k].monomial) {
        sum += static_cast<double>(power.exponent) * frame.log2[power.variable];
      }
      shift.push_back(sum);
      largest = std::max(largest, sum + homotopy.log2_size(homotopy.first_term(i) + k));
    }
    for (const double sum : shift)
      frame.factors.push_back(std::ldexp(1.0, static_cast<int>(sum - std::floor(largest))));
  }
  return frame;
}

Point inside(const FramePointer& frame, Point x) {
  return frame ? scaled(std::move(x), frame->log2, -1) : x;
}

Point outside(const FramePointer& frame, Point y) {
  return frame ? scaled(std::move(y), frame->log2, 1) : y;
}

}  // namespace moivre
