// SPDX-License-Identifier: MIT
// Of the samples that stand above their neighbours the one whose parabola is highest, refined by Brent's method.
#include "extremes.h"

#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <limits>
#include <utility>

namespace moivre {
namespace {

// What varies by less of its size is constant but for rounding.
constexpr double kConstant = 1e-12;

/// The highest value of the parabola through three points, the middle one above the others; v[1] where that is no parabola.
double crest(const double* t, const double* v) {
  const double left = (v[1] - v[0]) / (t[1] - t[0]);
  const double right = (v[2] - v[1]) / (t[2] - t[1]);
  const double bend = (right - left) / (t[2] - t[0]);
  const double slope = left + bend * (t[1] - t[0]);
  return bend < 0 ? v[1] - slope * slope / (4 * bend) : v[1];
}

/// Between the neighbours of sample k; nullopt where the curve is not known there.
std::optional<Extreme> refined(const Curve& curve, std::size_t k, int sign) {
  // Times to a millionth of the bracket: values to rounding.
  constexpr int kBits = 20;
  constexpr std::uintmax_t kMostEvaluations = 40;
  const double before = curve.times[k] - curve.times[k - 1];
  const double after = curve.times[k + 1] - curve.times[k];
  bool is_known = true;
  const auto time_at = [&](double s) { return curve.times[k] + s * (s < 0 ? before : after); };
  std::uintmax_t evaluations = kMostEvaluations;
  const auto [s, value] = boost::math::tools::brent_find_minima(
      [&](double place) {
        const double v = -sign * curve.at(time_at(place));
        is_known = is_known && std::isfinite(v);
        return is_known ? v : 0.0;
      },
      -1.0, 1.0, kBits, evaluations);
  if (!is_known || value > -sign * curve.values[k]) return std::nullopt;
  return Extreme{-sign * value, time_at(s), true};
}

}  // namespace

bool Extreme::is_unbounded() const { return std::isinf(value); }

Extreme extreme_of(const Curve& curve, int sign) {
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
    if (std::isnan(best.value) || sign * v[k] > sign * best.value) {
      best = {v[k], curve.times[k], false};
    }
  }
  if (!(largest - least > kConstant * size)) return best;
  std::optional<std::size_t> highest;
  double crest_of_highest = sign * best.value;
  for (std::size_t k = 1; k + 1 < v.size(); ++k) {
    if (!curve.is_sample[k - 1] || !curve.is_sample[k] || !curve.is_sample[k + 1]) continue;
    const double heights[] = {sign * v[k - 1], sign * v[k], sign * v[k + 1]};
    if (!(heights[1] >= heights[0] && heights[1] >= heights[2])) continue;
    const double here = crest(&curve.times[k - 1], heights);
    if (here < crest_of_highest) continue;
    highest = k;
    crest_of_highest = here;
  }
  if (!highest) return best;
  const std::optional<Extreme> found = refined(curve, *highest, sign);
  return found && sign * found->value >= sign * best.value ? *found : best;
}

}  // namespace moivre
