// SPDX-License-Identifier: MIT
// Discs around the coefficients: what double leaves of a rational is measured in exact arithmetic.
#include "program.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "moivre/expression/counted.h"
#include "moivre/numeric/integer.h"
#include "moivre/numeric/invalid_input.h"

namespace moivre {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// Bound on |r|, NaN where no double is one.
double upper(const Rational& r) {
  const double size = to_double(abs(r));
  return std::isfinite(size) ? (r.is_zero() ? 0 : raised(size)) : kNaN;
}

/// The double-double near r, and what is left of r.
struct Parts {
  double hi, lo;
  double beyond_hi, beyond_lo;
};

/// n, where it fits the 53 bits of a double.
std::optional<double> as_double(const Integer& n) {
  const auto& limbs = n.backend();
  if (limbs.size() != 1 || *limbs.limbs() >> std::numeric_limits<double>::digits != 0) {
    return std::nullopt;
  }
  return static_cast<double>(static_cast<std::int64_t>(n));
}

/// Of n / d, both whole numbers of 53 bits. A quotient that was rounded to nearest leaves a
/// remainder that is a double, and a fused multiply-add finds it without rounding [Muller18]: n =
/// hi d + r, r = lo d + s, both exactly. Neither can underflow: |hi| >= 2^-53 where it is not zero,
/// so |r| >= 2^-105 and |s| >= 2^-211 where they are not.
Parts parts_of(double n, double d) {
  const double hi = n / d;
  const double r = std::fma(-hi, d, n);
  const double lo = r / d;
  const double s = std::fma(-lo, d, r);
  const auto bound = [&](double rest) { return rest == 0 ? 0 : raised(std::abs(rest) / d); };
  return {hi, lo, bound(r), bound(s)};
}

Parts parts_of(const Rational& r) {
  if (r.is_zero()) return {0, 0, 0, 0};
  if (const auto n = as_double(numerator(r))) {
    if (const auto d = as_double(denominator(r))) return parts_of(*n, *d);
  }
  const double hi = to_double(r);
  if (!std::isfinite(hi)) return {kNaN, kNaN, kNaN, kNaN};
  const Rational rest = r - Rational(hi);
  const double lo = to_double(rest);
  return {hi, lo, upper(rest), upper(rest - Rational(lo))};
}

double sum_bound(double a, double b) { return a == 0 && b == 0 ? 0 : raised(a + b); }

CoefficientBall<Complex> coarse(const Parts& re, const Parts& im) {
  const double radius = sum_bound(re.beyond_hi, im.beyond_hi);
  return {{re.hi, im.hi}, radius, raised(size_bound(re.hi, im.hi) + radius), im.hi == 0};
}

CoefficientBall<ComplexDoubleDouble> fine(const Parts& re, const Parts& im) {
  return {{{re.hi, re.lo}, {im.hi, im.lo}},
          sum_bound(re.beyond_lo, im.beyond_lo),
          raised(size_bound(re.hi, im.hi) + sum_bound(re.beyond_hi, im.beyond_hi)),
          im.hi == 0 && im.lo == 0};
}

/// The tape of f without the derivatives by what is no unknown.
Tape tape_of_unknowns(const System& f, std::size_t unknowns) {
  Tape tape = make_tape(f);
  std::erase_if(tape.jacobian, [&](const Tape::Entry& entry) { return entry.column >= unknowns; });
  return tape;
}

}  // namespace

CertifyProgram::CertifyProgram(const System& f, std::size_t numbers)
    : system(f),
      given(numbers),
      real(is_real(f) && numbers == 0),
      tape(tape_of_unknowns(f, f.variables.size() - numbers)) {
  const auto rounded = round_coefficients<std::pair<Parts, Parts>>(
      tape, f, [](const Coefficient& c) { return std::pair(parts_of(c.re), parts_of(c.im)); });
  for (const auto& [re, im] : rounded) {
    coefficients.push_back(coarse(re, im));
    fine_coefficients.push_back(fine(re, im));
  }
}

std::shared_ptr<const CertifyProgram> make_certify_program(const System& f, std::size_t given) {
  require_unbroken(broken_rules(f));
  const std::size_t unknowns = f.variables.size() - std::min(given, f.variables.size());
  if (f.polynomials.size() != unknowns) {
    throw InvalidInput("certificates are for square systems; this one has " +
                       counted(f.polynomials.size(), "equation") + " in " +
                       counted(unknowns, "unknown"));
  }
  if (unknowns == 0) {
    throw InvalidInput("a system without unknowns has no root to certify");
  }
  return std::make_shared<const CertifyProgram>(f, given);
}

}  // namespace moivre
