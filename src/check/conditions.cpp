// SPDX-License-Identifier: MIT
// Does every listed root meet the conditions of the file? By the signs that p can have wherever the
// root may lie; where these differ, by the root itself if it is known exactly.
#include <algorithm>
#include <cmath>

#include "bench.h"
#include "moivre/numeric/simplest.h"
#include "moivre/polynomial/exclusion.h"
#include "moivre/polynomial/value.h"

namespace moivre {
namespace {

using ExactPoint = std::vector<Coefficient>;

int sign_of(const Rational& x) { return x < 0 ? -1 : (x > 0 ? 1 : 0); }

/// Where the root may lie: x real, |x*_j - x_j| <= radius. A real root lies as near to the real
/// parts as to x.
struct RealBall {
  Point x;
  double radius = 0;
};

RealBall ball_of(const Bench& bench, const Entry& entry) {
  RealBall ball{entry.x, entry.reach};
  for (Complex& xj : ball.x) xj = xj.real();
  const bool is_the_root =
      bench.stand_in.proves_roots && entry.certificate.holds_root() && !entry.is_farther;
  if (is_the_root) ball.radius = std::min(ball.radius, distance(entry.certificate, ball.x).most);
  return ball;
}

/// Whether x lies where the certificate proves no second root; nothing proved excludes nothing.
bool may_be_root_of(const Certificate& certificate, const ExactPoint& x) {
  if (!certificate.holds_root()) return true;
  for (std::size_t j = 0; j < x.size(); ++j) {
    const Enclosure proved = enclosure(certificate, j);
    Rational offset = x[j].re - Rational(proved.middle.real());
    for (const Complex& part : proved.finer) offset -= Rational(part.real());
    constexpr double kWellWithin = 0.5;
    if (std::abs(to_double(offset)) > kWellWithin * certificate.radius(j)) return false;
  }
  return true;
}

/// The midpoint of the ball, or its simplest fractions, where they are the root; else empty.
ExactPoint exact_root(const Bench& bench, const Entry& entry, const RealBall& ball) {
  for (const double error : {0.0, ball.radius}) {
    ExactPoint x;
    for (const Complex& xj : ball.x) x.push_back({simplest(xj.real(), error), Rational(0)});
    const auto vanishes = [&](const Polynomial& p) { return is_zero(exact_value_at(p, x)); };
    const std::vector<Polynomial>& f = bench.f.polynomials;
    if (may_be_root_of(entry.certificate, x) && std::all_of(f.begin(), f.end(), vanishes)) return x;
  }
  return {};
}

/// Of p at the root; nullopt where it can be on either side, or is a cluster's.
std::optional<int> sign_at_root(const Bench& bench, const Polynomial& p, std::size_t k) {
  const RealBall ball = ball_of(bench, bench.entries[k]);
  const System of_p{bench.f.variables, {p}};
  if (has_no_root_within(of_p, ball.x, ball.radius)) {
    return sign_of(exact_value_at(p, simplest(ball.x, 0)).re);
  }
  if (bench.claims.roots[k].cluster) return std::nullopt;
  const ExactPoint root = exact_root(bench, bench.entries[k], ball);
  if (root.empty()) return std::nullopt;
  return sign_of(exact_value_at(p, root).re);
}

void judge_inequality(const Bench& bench, const Condition& condition, std::size_t k) {
  const RootClaim& root = bench.claims.roots[k];
  constexpr ClaimKind kClaim = ClaimKind::inequality;
  if (root.real == false) {
    return bench.verdicts.refute(kClaim, condition.text + " asks for real roots", k + 1);
  }
  if (bench.stand_in.has_patches()) {
    return bench.verdicts.leave_open(
        kClaim, condition.text + " is not judged in homogeneous coordinates", k + 1);
  }
  const std::optional<int> sign = sign_at_root(bench, condition.p, k);
  if (!sign) {
    return bench.verdicts.leave_open(
        kClaim, "on the boundary of " + condition.text + ", as far as the accuracy tells", k + 1);
  }
  const bool is_met = *sign > 0 || (*sign == 0 && !condition.is_strict);
  bench.verdicts.judge(kClaim, is_met, "does not meet " + condition.text, k + 1);
}

}  // namespace

void judge_conditions(const Bench& bench) {
  if (bench.is_list()) return;
  for (std::size_t k = 0; k < bench.entries.size(); ++k) {
    bench.require_time();
    if (bench.entries[k].is_refuted) continue;
    for (const Condition& condition : bench.f.conditions) judge_inequality(bench, condition, k);
  }
}

}  // namespace moivre
