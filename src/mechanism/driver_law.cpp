// SPDX-License-Identifier: MIT
// How are a driver's value and two derivatives computed? Parabola, natural cubic spline, Taylor
// arithmetic.
#include "moivre/mechanism/driver_law.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>

#include "faults.h"
#include "moivre/mechanism/jet.h"
#include "moivre/numeric/invalid_input.h"

namespace moivre {
namespace {

DriverState state(const Parabola& law, double t) {
  return {law.start + t * (law.velocity + t * law.acceleration / 2),
          law.velocity + law.acceleration * t, law.acceleration};
}

DriverState state(const TypedLaw& law, double t) {
  const Jet f = evaluate<Jet>(law.formula, {}, Jet(t, 1, 0));
  return {law.unit * f.f, law.unit * f.d, law.unit * f.dd};
}

/// The cubic of piece k at t; beyond the ends its tangent (the curvature is 0 there).
DriverState state(const Spline& s, double t) {
  const double inside = std::clamp(t, s.t.front(), s.t.back());
  const auto next = std::upper_bound(s.t.begin() + 1, s.t.end() - 1, inside);
  const auto k = static_cast<std::size_t>(next - s.t.begin()) - 1;
  const double h = s.t[k + 1] - s.t[k];
  const double a = (s.t[k + 1] - inside) / h;
  const double b = (inside - s.t[k]) / h;
  const double left = s.curvature[k];
  const double right = s.curvature[k + 1];
  DriverState result;
  result.value = a * s.value[k] + b * s.value[k + 1] +
                 ((a * a * a - a) * left + (b * b * b - b) * right) * h * h / 6;
  result.velocity = (s.value[k + 1] - s.value[k]) / h +
                    ((1 - 3 * a * a) * left + (3 * b * b - 1) * right) * h / 6;
  result.acceleration = inside == t ? a * left + b * right : 0;
  result.value += result.velocity * (t - inside);
  return result;
}

void require_table(const std::vector<double>& t, const std::vector<double>& value,
                   std::size_t least) {
  if (t.size() < least || value.size() != t.size()) {
    throw InvalidInput("a table needs " + std::to_string(least) + " or more points");
  }
  for (std::size_t k = 1; k < t.size(); ++k) {
    if (!(t[k] > t[k - 1])) throw InvalidInput("a table's times must increase");
  }
  for (const std::vector<double>* numbers : {&t, &value}) {
    for (const double x : *numbers) {
      if (!std::isfinite(x)) throw InvalidInput("a table's numbers must be finite");
    }
  }
}

}  // namespace

// Thomas' algorithm on h_{k-1} c_{k-1} + 2 (h_{k-1} + h_k) c_k + h_k c_{k+1} = 6 (slope_k -
// slope_{k-1}).
Spline natural_spline(std::vector<double> t, std::vector<double> value) {
  const std::size_t n = t.size();
  require_table(t, value, 2);
  std::vector<double> curvature(n, 0);
  std::vector<double> upper(n, 0);
  for (std::size_t k = 1; k + 1 < n; ++k) {
    const double before = t[k] - t[k - 1];
    const double after = t[k + 1] - t[k];
    const double pivot = 2 * (before + after) - before * upper[k - 1];
    const double bend =
        6 * ((value[k + 1] - value[k]) / after - (value[k] - value[k - 1]) / before);
    upper[k] = after / pivot;
    curvature[k] = (bend - before * curvature[k - 1]) / pivot;
  }
  for (std::size_t k = n - 1; k-- > 1;) curvature[k] -= upper[k] * curvature[k + 1];
  return {std::move(t), std::move(value), std::move(curvature)};
}

// The same equations around the period.
Spline periodic_spline(std::vector<double> t, std::vector<double> value) {
  require_table(t, value, 4);
  const std::size_t pieces = t.size() - 1;
  const auto length = [&](std::size_t k) { return t[k + 1] - t[k]; };
  const auto slope = [&](std::size_t k) { return (value[k + 1] - value[k]) / length(k); };
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd bend(static_cast<Eigen::Index>(pieces));
  for (std::size_t k = 0; k < pieces; ++k) {
    const std::size_t before = (k + pieces - 1) % pieces;
    const auto row = static_cast<int>(k);
    entries.emplace_back(row, static_cast<int>(before), length(before));
    entries.emplace_back(row, row, 2 * (length(before) + length(k)));
    entries.emplace_back(row, static_cast<int>((k + 1) % pieces), length(k));
    bend[row] = 6 * (slope(k) - slope(before));
  }
  Eigen::SparseMatrix<double> matrix(bend.size(), bend.size());
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(matrix);
  const Eigen::VectorXd solved = factors.solve(bend);
  std::vector<double> curvature(solved.begin(), solved.end());
  curvature.push_back(curvature.front());
  return {std::move(t), std::move(value), std::move(curvature)};
}

DriverState periodic_state(const Spline& spline, double t) {
  const double period = spline.t.back() - spline.t.front();
  const double periods = std::floor((t - spline.t.front()) / period);
  return state(spline, t - periods * period);
}

void require_law(const DriverLaw& law) {
  if (const auto* table = std::get_if<Spline>(&law)) {
    const std::size_t rows = table->t.size();
    if (rows >= 2 && table->value.size() == rows && table->curvature.size() == rows) return;
    throw InvalidInput("a driver's table has two or more rows (natural_spline makes it)");
  }
  const auto* typed = std::get_if<TypedLaw>(&law);
  const std::string fault = typed != nullptr ? fault_of(typed->formula, 0) : "";
  if (!fault.empty()) throw InvalidInput("a driver's formula " + fault);
}

DriverState driver_state(const DriverLaw& law, double t) {
  return std::visit([t](const auto& kind) { return state(kind, t); }, law);
}

}  // namespace moivre
