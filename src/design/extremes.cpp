// SPDX-License-Identifier: MIT
// Of the samples that stand above their neighbours the one whose parabola is highest, refined by
// Brent's method.
#include "extremes.h"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace moivre {
namespace {

// What varies by less of its size is constant but for rounding.
constexpr double kConstant = 1e-12;
// Of the range: extremes that differ by less are one value, taken several times.
constexpr double kEqual = 1e-8;

/// The highest value of the parabola through three points, the middle one above the others; v[1]
/// where that is no parabola.
double crest(const double* t, const double* v) {
  const double left = (v[1] - v[0]) / (t[1] - t[0]);
  const double right = (v[2] - v[1]) / (t[2] - t[1]);
  const double bend = (right - left) / (t[2] - t[0]);
  const double slope = left + bend * (t[1] - t[0]);
  return bend < 0 ? v[1] - slope * slope / (4 * bend) : v[1];
}

/// Between the neighbours of sample k, or between it and its only one; nullopt where the curve is
/// not known there.
std::optional<Extreme> refined(const Series& curve, std::size_t k, int sign) {
  // Times to a hundred-thousandth of the bracket: values to the square of that.
  constexpr int kBits = 17;
  constexpr std::uintmax_t kMostEvaluations = 40;
  const bool is_first = k == 0 || !std::isfinite(curve.values[k - 1]);
  const bool is_last = k + 1 == curve.times.size() || !std::isfinite(curve.values[k + 1]);
  const double before = is_first ? 0 : curve.times[k] - curve.times[k - 1];
  const double after = is_last ? 0 : curve.times[k + 1] - curve.times[k];
  bool is_known = true;
  const auto time_at = [&](double s) { return curve.times[k] + s * (s < 0 ? before : after); };
  std::uintmax_t evaluations = kMostEvaluations;
  const auto [s, value] = boost::math::tools::brent_find_minima(
      [&](double place) {
        const double v = -sign * curve.at(time_at(place));
        is_known = is_known && std::isfinite(v);
        return is_known ? v : 0.0;
      },
      is_first ? 0.0 : -1.0, is_last ? 0.0 : 1.0, kBits, evaluations);
  if (!is_known || value > -sign * curve.values[k]) return std::nullopt;
  return Extreme{-sign * value, time_at(s), true};
}

/// Points worth a closer look, by time: those whose parabola is nearly the highest, and the first
/// two and the last two where they stand above the next: beside a dead point a curve is no
/// parabola.
std::vector<std::size_t> candidates(const Series& curve, double highest, double range, int sign) {
  // A parabola's crest misses by less.
  constexpr double kNearly = 1e-3;
  std::vector<std::pair<std::size_t, double>> crests;
  for (std::size_t k = 0; k < curve.values.size(); ++k) {
    if (!std::isfinite(curve.values[k])) continue;
    const bool has_before = k > 0 && std::isfinite(curve.values[k - 1]);
    const bool has_after = k + 1 < curve.values.size() && std::isfinite(curve.values[k + 1]);
    const double height = sign * curve.values[k];
    const bool is_above = (!has_before || height >= sign * curve.values[k - 1]) &&
                          (!has_after || height >= sign * curve.values[k + 1]);
    if (!is_above || (!has_before && !has_after)) continue;
    double here = highest;
    if (has_before && has_after) {
      const double heights[] = {sign * curve.values[k - 1], height, sign * curve.values[k + 1]};
      here = crest(&curve.times[k - 1], heights);
      highest = std::max(highest, here);
    }
    crests.emplace_back(k, here);
  }
  std::vector<std::size_t> found;
  for (const auto& [k, here] : crests) {
    const bool is_end = k <= 1 || k + 2 >= curve.values.size() ||
                        !std::isfinite(curve.values[k - 1]) || !std::isfinite(curve.values[k + 1]);
    if (is_end || here >= highest - kNearly * range) found.push_back(k);
  }
  return found;
}

}  // namespace

bool Extreme::is_unbounded() const { return std::isinf(value); }

Extreme extreme_of(const Series& curve, int sign) {
  Extreme best{std::numeric_limits<double>::quiet_NaN(), 0, false};
  const auto& v = curve.values;
  double size = 0;
  double least = std::numeric_limits<double>::infinity();
  double largest = -least;
  for (std::size_t k = 0; k < v.size(); ++k) {
    if (!std::isfinite(v[k])) continue;
    size = std::max(size, std::abs(v[k]));
    least = std::min(least, v[k]);
    largest = std::max(largest, v[k]);
  }
  for (std::size_t k = 0; k < v.size(); ++k) {
    const bool is_first = std::isnan(best.value) && std::isfinite(v[k]);
    if (is_first || sign * v[k] > sign * best.value + kEqual * (largest - least)) {
      best = {v[k], curve.times[k], false};
    }
  }
  if (!(largest - least > kConstant * size)) return best;
  // Of several equal ones the first, whatever rounding makes of them.
  const double rounding = kEqual * (largest - least);
  for (const std::size_t k : candidates(curve, sign * best.value, largest - least, sign)) {
    const std::optional<Extreme> found = refined(curve, k, sign);
    if (found && sign * found->value > sign * best.value + rounding) best = *found;
  }
  return best;
}

}  // namespace moivre
