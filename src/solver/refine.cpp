// SPDX-License-Identifier: MIT
// Newton's method with double-double residuals and the test that tells simple roots from multiple ones.
#include "refine.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fine_newton.h"
#include "moivre/factorization/lu.h"
#include "moivre/numeric/fused.h"
#include "moivre/polynomial/digits.h"
#include "prepare.h"

namespace moivre {
namespace {

constexpr double kUnitRoundoff = 0x1p-53;
constexpr int kMaximumRefinements = 15;
// Newton is refused when its first correction is further than so many times the stated accuracy.
constexpr double kTravel = 1e4;
constexpr double kLeastTravel = 1e-6;
// A correction that falls by this factor at least contracts better than any multiple root allows
// (a double root: 1/2, higher ones slower).
constexpr double kContraction = 0.2;
// Corrections below this may stop contracting because of rounding.
constexpr double kRounding = 1e-11;
// The probe is this much nearer than sensitivity and degree suggest, within bounds.
constexpr double kProbe = 1e-2;
// Beside a probe at kProbe / (sensitivity (d / kLowDegree)^2) the curvature of degree d leaves (kProbe / 2) kLowDegree^2 =
// 0.08 of the offset at most. Up to this degree the sensitivity alone tells how near is near enough.
constexpr double kLowDegree = 4;
constexpr double kLeastProbe = 1e-13;
// From here on the Jacobian, evaluated in double, says nothing about the root.
constexpr double kHopelessSensitivity = 1e16;
// At the mean of simple roots near each other terms cancel: beside what is left the residual is larger by so much than
// beside all terms.
constexpr double kCancellation = 16;
// Roundings of an evaluation in double-double, relative to the terms; what they may move a root by at most.
constexpr double kFineRoundoff = 0x1p-102;
constexpr double kFineNoise = 1e-6;
// Corrections that rounding stops are no larger than so many times what it explains at most; a probe lies further away.
constexpr double kFineStagnation = 1e2;
// The points of a circle, whose mean a singular end is, are not known better: errors of 1.02e-14 were seen.
constexpr double kSingularAccuracy = 5e-14;
// Coordinates of a singular root are taken for 0 within so many times the accuracy of its mean. What a residual leaves open is no
// reason: a mean that is farther from 0 may be that of sheets which end apart.
constexpr double kSingularSnap = 10;

/// How far a root may be from an end of this accuracy.
double reach_of(double accuracy) { return std::max(kLeastTravel, kTravel * accuracy); }

void add(Point& x, const Point& dx) {
  for (std::size_t i = 0; i < x.size(); ++i) x[i] += dx[i];
}

}  // namespace

RefinerProgram::RefinerProgram(const System& given, std::vector<double> natural_sizes)
    : unit(std::move(natural_sizes)) {
  const Scaling rows = unit_rows(given);
  const System f = scale(given, rows);
  tape = make_tape(f);
  c = complex_coefficients(tape, f);
  exact = round_coefficients<ComplexDoubleDouble>(tape, f, to_complex_double_double);
  for (const Complex& ck : c) size.push_back(std::abs(ck));
  if (const CoefficientErrors relative = coefficient_errors(given); !relative.empty()) {
    for (std::size_t k = 0; k < size.size(); ++k) {
      const Tape::Origin& origin = tape.coefficients[k];
      error.push_back(bound(relative[origin.equation][origin.term]) * size[k]);
    }
  }
  for (const std::uint64_t d : degrees(f)) {
    curvature = std::max(curvature, std::pow(static_cast<double>(d) / kLowDegree, 2));
  }
}

std::shared_ptr<const RefinerProgram> make_refiner_program(const System& f,
                                                           std::vector<double> unit) {
  return std::make_shared<const RefinerProgram>(f, std::move(unit));
}

struct Refiner::Workspace {
  explicit Workspace(std::shared_ptr<const RefinerProgram> shared)
      : program(std::move(shared)),
        n(program->tape.variables),
        unit(program->unit),
        lu(n),
        registers(program->tape.register_count()),
        value(program->tape.equations),
        jacobian(program->tape.jacobian.size()),
        fine_x(n),
        fine_registers(program->tape.register_count()),
        fine_value(program->tape.equations),
        size_x(n),
        size_registers(program->tape.register_count()),
        size_value(program->tape.equations),
        relative(program->tape.equations),
        dx(n) {}

  bool factor(const Point& x) {
    evaluate<Complex, Complex>(program->tape, program->c, x, registers, value, jacobian);
    const auto j = lu.matrix();
    std::fill(j.begin(), j.end(), Complex(0));
    for (std::size_t k = 0; k < jacobian.size(); ++k) {
      const Tape::Entry& entry = program->tape.jacobian[k];
      j[entry.row * n + entry.column] = jacobian[k];
    }
    if (!has_own_units) return lu.factor();
    for (std::size_t i = 0; i < n; ++i) size_x[i] = std::max(std::abs(x[i]), unit[i]);
    return lu.factor(size_x);
  }

  void evaluate_fine(const Point& x) {
    std::copy(x.begin(), x.end(), fine_x.begin());
    fused([&] {
      evaluate<ComplexDoubleDouble, ComplexDoubleDouble>(program->tape, program->exact, fine_x,
                                                         fine_registers, fine_value);
    });
  }

  /// size_value <- sum |terms|, each equation, at max(|x_i|, floor_i).
  void evaluate_sizes(const Point& x, std::span<const double> floor) {
    for (std::size_t i = 0; i < n; ++i) {
      size_x[i] = std::max(std::abs(x[i]), floor.empty() ? 0.0 : floor[i]);
    }
    evaluate<double, double>(program->tape, program->size, size_x, size_registers, size_value);
  }

  /// dx <- -J^{-1} F(x), J as factored last; its size.
  double correction(const Point& x) {
    evaluate_fine(x);
    for (std::size_t i = 0; i < n; ++i) dx[i] = -to_complex(fine_value[i]);
    lu.solve(dx);
    return size_at(dx, x);
  }

  /// max_i |v_i| / max(|x_i|, unit_i).
  double size_at(const Point& v, const Point& x) const {
    double largest = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const double size = std::abs(v[i]) / std::max(std::abs(x[i]), unit[i]);
      if (!(size <= largest)) largest = size;
    }
    return largest;
  }

  std::shared_ptr<const RefinerProgram> program;
  std::size_t n;
  std::vector<double> unit;    ///< in force
  bool has_own_units = false;  ///< not the program's
  Lu lu;
  std::vector<Complex> registers, value, jacobian;
  std::vector<ComplexDoubleDouble> fine_x, fine_registers, fine_value;
  std::vector<double> size_x, size_registers, size_value;
  std::vector<Complex> relative;
  Point dx;
  std::unique_ptr<FineNewton> fine;  ///< made when it is first needed
};

Refiner::Refiner(std::shared_ptr<const RefinerProgram> program)
    : w_(std::make_unique<Workspace>(std::move(program))) {}
Refiner::~Refiner() = default;
Refiner::Refiner(Refiner&&) noexcept = default;

void Refiner::measure_by(std::vector<double> units) {
  w_->has_own_units = !units.empty();
  w_->unit = units.empty() ? w_->program->unit : std::move(units);
}

const std::vector<Complex>& Refiner::relative_values(const Point& x) & {
  Workspace& w = *w_;
  w.evaluate_fine(x);
  w.evaluate_sizes(x, {});
  for (std::size_t i = 0; i < w.relative.size(); ++i) {
    const Complex fi = to_complex(w.fine_value[i]);
    w.relative[i] = w.size_value[i] > 0 ? fi / w.size_value[i] : fi;
  }
  return w.relative;
}

// Newton from x while the corrections stay within reach; true when they ended at rounding.
bool Refiner::newton(Point& x, double reach) {
  Workspace& w = *w_;
  double last = std::numeric_limits<double>::infinity();
  for (int k = 0; k < kMaximumRefinements; ++k) {
    if (!w.factor(x)) return false;
    const double size = w.correction(x);
    if (!(size <= reach)) return false;
    if (size > kContraction * last && last < kRounding) return true;
    add(x, w.dx);
    if (size <= 2 * kUnitRoundoff) return true;
    last = size;
  }
  return false;
}

Refined Refiner::refine(const Point& x, double accuracy) {
  Workspace& w = *w_;
  Refined result;
  result.x = x;
  Point trial = x;
  result.simple = newton(trial, reach_of(accuracy));
  result.condition = w.factor(trial) ? w.lu.condition() : std::numeric_limits<double>::infinity();
  result.simple = result.simple && is_simple(trial);
  if (result.simple) {
    w.factor(trial);
    w.correction(trial);
    result.accuracy = 2 * max_norm(w.dx) / std::max(1.0, max_norm(trial)) + kUnitRoundoff;
    result.x = std::move(trial);
  }
  result.residual = residual(result.x);
  snap_to_zero(result, accuracy);
  return result;
}

// How far x moves, relative to its size, when every term of F changes by one unit of its own size:
// two samples of |J^{-1}| applied to the sizes of the terms, J as factored last.
double Refiner::sensitivity(const Point& x) {
  Workspace& w = *w_;
  double largest = 0;
  w.evaluate_sizes(x, w.unit);
  for (int sample = 0; sample < 2; ++sample) {
    for (std::size_t i = 0; i < w.n; ++i) {
      w.dx[i] = std::polar(w.size_value[i], static_cast<double>(sample) * static_cast<double>(i));
    }
    w.lu.solve(w.dx);
    largest = std::max(largest, w.size_at(w.dx, x));
  }
  return largest;
}

// Newton from a point beside x, `offset` away in every coordinate, comes much nearer to a simple root;
// to a root of multiplicity m it comes nearer by (m-1)/m only. The offset lies inside the region where
// a simple root of this sensitivity attracts Newton quadratically: where terms of degree d dominate,
// |F''| is up to d^2 times the terms, beside a Jacobian that is the terms over the sensitivity.
bool Refiner::is_simple(const Point& x) {
  Workspace& w = *w_;
  if (!w.factor(x)) return false;
  const double sensitive = sensitivity(x);
  if (!(sensitive < kHopelessSensitivity)) return false;
  const double relative_offset =
      std::clamp(kProbe / (sensitive * w.program->curvature), kLeastProbe, kProbe);
  Point probe = x;
  for (std::size_t i = 0; i < probe.size(); ++i) {
    const double offset = relative_offset * std::max(std::abs(x[i]), w.unit[i]);
    probe[i] += std::polar(offset, static_cast<double>(i + 1));
  }
  if (!w.factor(probe)) return false;
  w.correction(probe);
  add(probe, w.dx);
  for (std::size_t i = 0; i < probe.size(); ++i) probe[i] -= x[i];
  return w.size_at(probe, x) < kContraction * relative_offset;
}

// One Newton step in double-double from beside fine_x, as in is_simple().
bool Refiner::contracts_beside(double sensitivity) {
  Workspace& w = *w_;
  const double least = kFineStagnation * sensitivity * kFineRoundoff;
  const double offset =
      std::clamp(kProbe / (sensitivity * w.program->curvature), least, std::max(least, kProbe));
  std::vector<ComplexDoubleDouble> probe = w.fine_x;
  Point x(w.n);
  Point rest(w.n);
  for (std::size_t i = 0; i < w.n; ++i) {
    x[i] = to_complex(w.fine_x[i]);
    const double size = offset * std::max(std::abs(x[i]), w.unit[i]);
    probe[i] += ComplexDoubleDouble(std::polar(size, static_cast<double>(i + 1)));
  }
  if (!w.fine->correct(probe)) return false;
  w.fine->add_to(probe);
  for (std::size_t i = 0; i < w.n; ++i) rest[i] = to_complex(probe[i] - w.fine_x[i]);
  return w.size_at(rest, x) < kContraction * offset;
}

Refined Refiner::refine_fine(const Point& x) {
  Workspace& w = *w_;
  if (!w.fine) w.fine = std::make_unique<FineNewton>(*w.program);
  Refined result;
  result.x = x;
  result.condition = std::numeric_limits<double>::infinity();
  result.residual = residual(x);
  std::copy(x.begin(), x.end(), w.fine_x.begin());
  double last = kLeastTravel;
  bool contracts = true;
  for (int k = 0; k < kMaximumRefinements && contracts; ++k) {
    if (!w.fine->correct(w.fine_x)) return result;
    const double size = w.size_at(w.fine->rounded(), x);
    if (!(size <= (k == 0 ? kLeastTravel : kFineNoise))) return result;
    contracts = k == 0 || size <= kContraction * last;
    last = size;
    if (contracts) w.fine->add_to(w.fine_x);
  }
  const double moved = max_norm(w.fine->rounded());
  w.evaluate_sizes(x, w.unit);
  w.fine->solve(w.size_value);
  const double sensitive = w.size_at(w.fine->rounded(), x);
  const double noise = max_norm(w.fine->rounded()) * kFineRoundoff;
  if (!(sensitive * kFineRoundoff < kFineNoise) ||
      last > std::max(kFineStagnation * sensitive * kFineRoundoff, kUnitRoundoff)) {
    return result;
  }
  result.condition = w.fine->condition();
  result.simple = contracts_beside(sensitive);
  if (!result.simple) return result;
  for (std::size_t i = 0; i < w.n; ++i) result.x[i] = to_complex(w.fine_x[i]);
  result.accuracy = 2 * (moved + noise) / std::max(1.0, max_norm(result.x)) + kUnitRoundoff;
  result.residual = residual(result.x);
  snap_to_zero(result, result.accuracy);
  return result;
}

Refined Refiner::keep(const Point& x, double accuracy, int sheets) {
  Refined result;
  result.x = x;
  const double spread =
      std::pow(kCancellation * natural_residual(x), 1 / static_cast<double>(sheets));
  result.accuracy = std::max({accuracy, kSingularAccuracy, spread});
  result.condition = w_->factor(x) ? w_->lu.condition() : std::numeric_limits<double>::infinity();
  result.residual = residual(x);
  snap_to_zero(result, kSingularSnap * std::max(accuracy, kSingularAccuracy));
  return result;
}

Refined Refiner::take(const Certificate& proved, double condition) {
  Refined result;
  result.x = proved.midpoint;
  result.simple = true;
  result.condition = condition;
  if (!std::isfinite(condition) && w_->factor(result.x)) result.condition = w_->lu.condition();
  result.residual = residual(result.x);
  Point snapped = result.x;
  double error = 0;
  double snapped_error = 0;
  for (std::size_t j = 0; j < snapped.size(); ++j) {
    double beyond = proved.error[j];
    for (const Point& part : proved.finer) beyond += std::abs(part[j]);
    if (std::abs(snapped[j].real()) <= beyond) snapped[j].real(0);
    if (std::abs(snapped[j].imag()) <= beyond) snapped[j].imag(0);
    error = std::max(error, beyond);
    snapped_error = std::max(snapped_error, beyond + std::abs(snapped[j] - result.x[j]));
  }
  if (take_snapped(result, std::move(snapped))) error = snapped_error;
  // Roundings of these few operations.
  result.accuracy = (1 + 16 * kUnitRoundoff) * error / std::max(1.0, max_norm(result.x));
  return result;
}

bool Refiner::is_within_reach(const Point& x, double accuracy, const Point& y) {
  for (std::size_t i = 0; i < x.size(); ++i) w_->dx[i] = y[i] - x[i];
  return w_->size_at(w_->dx, x) <= reach_of(accuracy);
}

// J^{-1} stretches it most, and so most of what it makes of any vector.
Point Refiner::softest(const Point& x, Point any) {
  if (!w_->factor(x)) return any;
  Point direction = any;
  w_->lu.solve(direction);
  const double size = max_norm(direction);
  if (!std::isfinite(size) || size == 0) return any;
  for (Complex& d : direction) d /= size;
  return direction;
}

double Refiner::natural_residual(const Point& x) {
  Workspace& w = *w_;
  w.evaluate_fine(x);
  w.evaluate_sizes(x, w.unit);
  double largest = 0;
  for (std::size_t i = 0; i < w.size_value.size(); ++i) {
    if (w.size_value[i] > 0) {
      largest = std::max(largest, std::abs(to_complex(w.fine_value[i])) / w.size_value[i]);
    }
  }
  return largest;
}

double Refiner::residual(const Point& x) {
  double largest = 0;
  for (const Complex& value : relative_values(x)) largest = std::max(largest, std::abs(value));
  return largest;
}

void Refiner::snap_to_zero(Refined& root, double accuracy) {
  const double within = (root.simple ? root.accuracy : accuracy) * std::max(1.0, max_norm(root.x));
  Point snapped = root.x;
  for (Complex& xi : snapped) {
    if (std::abs(xi.real()) <= within) xi.real(0);
    if (std::abs(xi.imag()) <= within) xi.imag(0);
  }
  take_snapped(root, std::move(snapped));
}

bool Refiner::take_snapped(Refined& root, Point&& snapped) {
  if (snapped == root.x) return false;
  const double snapped_residual = residual(snapped);
  if (snapped_residual > std::max(root.residual, kUnitRoundoff)) return false;
  root.x = std::move(snapped);
  root.residual = snapped_residual;
  return true;
}

}  // namespace moivre
