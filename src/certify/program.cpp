// SPDX-License-Identifier: MIT
// Discs around the coefficients: what double leaves of a rational is measured in exact arithmetic.
#include "program.h"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>

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

Parts parts_of(const Rational& r) {
  const double hi = to_double(r);
  if (!std::isfinite(hi)) return {kNaN, kNaN, kNaN, kNaN};
  const Rational rest = r - Rational(hi);
  const double lo = to_double(rest);
  return {hi, lo, upper(rest), upper(rest - Rational(lo))};
}

double sum_bound(double a, double b) { return a == 0 && b == 0 ? 0 : raised(a + b); }

CoefficientBall<Complex> coarse(const Coefficient& c) {
  const Parts re = parts_of(c.re), im = parts_of(c.im);
  const double radius = sum_bound(re.beyond_hi, im.beyond_hi);
  return {{re.hi, im.hi}, radius, raised(size_bound(re.hi, im.hi) + radius), im.hi == 0};
}

CoefficientBall<ComplexDoubleDouble> fine(const Coefficient& c) {
  const Parts re = parts_of(c.re), im = parts_of(c.im);
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
      tape(tape_of_unknowns(f, f.variables.size() - numbers)),
      coefficients(round_coefficients<CoefficientBall<Complex>>(tape, f, coarse)),
      fine_coefficients(round_coefficients<CoefficientBall<ComplexDoubleDouble>>(tape, f, fine)) {}

std::shared_ptr<const CertifyProgram> make_certify_program(const System& f, std::size_t given) {
  const std::size_t unknowns = f.variables.size() - std::min(given, f.variables.size());
  if (f.polynomials.size() != unknowns) {
    throw std::invalid_argument("certificates are for square systems; this one has " +
                                std::to_string(f.polynomials.size()) + " equations in " +
                                std::to_string(unknowns) + " unknowns");
  }
  if (unknowns == 0) {
    throw std::invalid_argument("a system without unknowns has no root to certify");
  }
  return std::make_shared<const CertifyProgram>(f, given);
}

}  // namespace moivre
