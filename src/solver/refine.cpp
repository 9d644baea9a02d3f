// SPDX-License-Identifier: MIT
// Residuals in double-double, and what a proof or a circle says of a root, told of the system as
// given.
#include "refine.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "moivre/factorization/lu.h"
#include "moivre/numeric/fused.h"
#include "moivre/polynomial/digits.h"
#include "prepare.h"

namespace moivre {
namespace {

constexpr double kUnitRoundoff = 0x1p-53;
// A proved root is no end's where it is farther from it than so many times the end's accuracy.
constexpr double kTravel = 1e4;
constexpr double kLeastTravel = 1e-6;
// At the mean of simple roots near each other terms cancel: beside what is left the residual is
// larger by so much than beside all terms.
constexpr double kCancellation = 16;
// The points of a circle, whose mean a singular end is, are not known better: errors of 1.02e-14
// were seen.
constexpr double kSingularAccuracy = 5e-14;
// Coordinates of a singular root are taken for 0 within so many times the accuracy of its mean.
// What a residual leaves open is no reason: a mean that is farther from 0 may be that of sheets
// which end apart.
constexpr double kSingularSnap = 10;

/// How far a root may be from an end of this accuracy.
double reach_of(double accuracy) { return std::max(kLeastTravel, kTravel * accuracy); }

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
}

std::shared_ptr<const RefinerProgram> make_refiner_program(const System& f,
                                                           std::vector<double> unit) {
  return std::make_shared<const RefinerProgram>(f, std::move(unit));
}

struct Refiner::Workspace {
  explicit Workspace(std::shared_ptr<const RefinerProgram> shared)
      : program(std::move(shared)),
        n(program->tape.variables),
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
    return lu.factor();
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

  /// max_i |v_i| / max(|x_i|, unit_i).
  double size_at(const Point& v, const Point& x) const {
    double largest = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const double size = std::abs(v[i]) / std::max(std::abs(x[i]), program->unit[i]);
      if (!(size <= largest)) largest = size;
    }
    return largest;
  }

  std::shared_ptr<const RefinerProgram> program;
  std::size_t n;
  Lu lu;
  std::vector<Complex> registers, value, jacobian;
  std::vector<ComplexDoubleDouble> fine_x, fine_registers, fine_value;
  std::vector<double> size_x, size_registers, size_value;
  std::vector<Complex> relative;
  Point dx;
};

Refiner::Refiner(std::shared_ptr<const RefinerProgram> program)
    : w_(std::make_unique<Workspace>(std::move(program))) {}
Refiner::~Refiner() = default;
Refiner::Refiner(Refiner&&) noexcept = default;

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

Refined Refiner::keep(const Point& x, double accuracy, int sheets) {
  Refined result;
  result.x = x;
  const double spread =
      std::pow(kCancellation * natural_residual(x), 1 / static_cast<double>(sheets));
  result.accuracy = std::max({accuracy, kSingularAccuracy, spread});
  result.condition = condition_at(x);
  result.residual = residual(x);
  const double within =
      kSingularSnap * std::max(accuracy, kSingularAccuracy) * std::max(1.0, max_norm(x));
  Point snapped = x;
  for (Complex& xi : snapped) {
    if (std::abs(xi.real()) <= within) xi.real(0);
    if (std::abs(xi.imag()) <= within) xi.imag(0);
  }
  take_snapped(result, std::move(snapped));
  return result;
}

Refined Refiner::take(const Certificate& proved) {
  Refined result;
  result.x = proved.midpoint;
  result.simple = true;
  result.condition = condition_at(result.x);
  result.residual = residual(result.x);
  Point snapped = result.x;
  double error = 0;
  double snapped_error = 0;
  for (std::size_t j = 0; j < snapped.size(); ++j) {
    double beyond = proved.error(j);
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

double Refiner::condition_at(const Point& x) {
  return w_->factor(x) ? w_->lu.condition() : std::numeric_limits<double>::infinity();
}

double Refiner::natural_residual(const Point& x) {
  Workspace& w = *w_;
  w.evaluate_fine(x);
  w.evaluate_sizes(x, w.program->unit);
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

bool Refiner::take_snapped(Refined& root, Point&& snapped) {
  if (root.x == snapped) return false;
  const double snapped_residual = residual(snapped);
  if (snapped_residual > std::max(root.residual, kUnitRoundoff)) return false;
  root.x = std::move(snapped);
  root.residual = snapped_residual;
  return true;
}

}  // namespace moivre
