// SPDX-License-Identifier: MIT
// The curve of roots over a line of members, cut by bilinear forms that move: is the sum of their
// points linear?
#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "loops.h"
#include "moivre/numeric/invalid_input.h"
#include "moivre/numeric/random.h"

namespace moivre {
namespace {

// Loops of the test are other ones than those of the search.
constexpr std::uint64_t kTestLoops = 500'000;
constexpr std::uint64_t kLine = 700'000;
constexpr std::uint64_t kForm = 700'001;
constexpr std::uint64_t kSum = 700'002;
// Sums of points known to twelve digits are linear to this, beside the sum of their sizes.
constexpr double kLinear = 1e-7;
// Steps of the form: a missing root that is so many times as far away as the others bends the sum
// of a step as long.
constexpr std::array<double, 3> kSteps{1, 1e2, 1e4};
// Ways round a place at which a path breaks off pass the middle of the straight line so far beside
// it, times its length. Near ones first: they rarely go round another place, where paths trade
// ends.
constexpr std::array<double, 4> kWays{0.03, -0.03, 0.1, -0.1};
// A point of the curve stands over p* where s is no more than this.
constexpr double kAtBase = 1e-8;

Complex random_number(std::uint64_t seed, std::uint64_t number, std::uint64_t index) {
  return (0.5 + random_unit(seed, RandomStream::family, (number << 24) + 2 * index)) *
         random_phase(seed, RandomStream::family, (number << 24) + 2 * index + 1);
}

Polynomial power(const Polynomial& base, std::uint32_t exponent) {
  Polynomial result = base;
  for (std::uint32_t e = 1; e < exponent; ++e) result = result * base;
  return result;
}

/// F(x; p* + s v) and the form sum_j a_j s x_j + b_j x_j + c s + d, in x, s and the form's
/// coefficients.
System curve_system(const Family& family, const Point& v) {
  const auto n = static_cast<std::uint32_t>(family.unknowns());
  System curve;
  curve.variables = family.unknown_names();
  const auto add = [&](std::string name) {
    while (std::find(curve.variables.begin(), curve.variables.end(), name) !=
           curve.variables.end()) {
      name += '_';
    }
    curve.variables.push_back(name);
  };
  add("s");
  for (std::uint32_t j = 0; j < 2 * n + 2; ++j) add(std::string("g").append(std::to_string(j)));
  std::vector<Polynomial> line;
  for (std::size_t j = 0; j < v.size(); ++j) {
    line.push_back(constant(exact_value(family.generic[j])) + exact_value(v[j]) * unknown(n));
  }
  for (const Polynomial& p : family.system.polynomials) {
    Polynomial sum;
    for (const Term& term : p.terms) {
      Polynomial product_of = constant(term.coefficient);
      for (const Power& factor : term.monomial) {
        const bool is_unknown = factor.variable < n;
        product_of =
            product_of * power(is_unknown ? unknown(factor.variable) : line[factor.variable - n],
                               factor.exponent);
      }
      sum = sum + product_of;
    }
    curve.polynomials.push_back(std::move(sum));
  }
  Polynomial form = unknown(n + 1 + 2 * n) * unknown(n) + unknown(n + 2 + 2 * n);
  for (std::uint32_t j = 0; j < n; ++j) {
    form =
        form + unknown(n + 1 + j) * unknown(n) * unknown(j) + unknown(n + 1 + n + j) * unknown(j);
  }
  curve.polynomials.push_back(std::move(form));
  return curve;
}

/// s (l(x) - 1), whose points with s = 0 are the roots at p*.
Point split_form(std::size_t n, std::uint64_t seed) {
  Point form;
  for (std::size_t j = 0; j < n; ++j) form.push_back(random_number(seed, kForm, j));
  form.resize(2 * n);
  form.push_back(-1);
  form.push_back(0);
  return form;
}

Point generic_form(std::size_t n, std::uint64_t seed) {
  Point form;
  for (std::size_t j = 0; j < 2 * n + 2; ++j) form.push_back(random_number(seed, kForm, n + j));
  return form;
}

/// The sum over the points of a random linear function, and the sum of its sizes.
struct Trace {
  Complex sum;
  double size = 0;
};

Trace trace_of(const std::vector<Point>& points, std::uint64_t seed) {
  Trace trace;
  for (const Point& point : points) {
    Complex value = 0;
    for (std::size_t j = 0; j < point.size(); ++j) {
      value += random_number(seed, kSum, j) * point[j];
    }
    trace.sum += value;
    trace.size += std::abs(value);
  }
  return trace;
}

/// An end that two paths have come to is neither's as far as is known: one of them jumped.
void drop_shared(std::vector<std::optional<Point>>& ends) {
  RootSet seen;
  RootSet shared;
  for (const auto& end : ends) {
    if (end && !seen.add(*end)) shared.add(*end);
  }
  for (auto& end : ends) {
    if (end && shared.holds(*end)) end.reset();
  }
}

std::size_t count_lost(const std::vector<std::optional<Point>>& ends) {
  return static_cast<std::size_t>(std::count(ends.begin(), ends.end(), std::nullopt));
}

/// Carries points of a curve from form to form.
class Carrier {
 public:
  Carrier(const System& curve, const Follower& follower) : curve_(curve), follower_(follower) {}

  /// Where each point arrives, none where another does; nullopt where it was lost. Paths that break
  /// off on the straight line, or meet, go round by another form from + c (to - from), c complex.
  /// All points of the curve lead to all of them on every way.
  std::vector<std::optional<Point>> carry(const Point& from, const Point& to,
                                          const std::vector<Point>& points) const {
    auto ends = follow_roots(curve_, from, to, points, follower_);
    drop_shared(ends);
    for (const double aside : kWays) {
      if (follower_.stop || count_lost(ends) == 0) break;
      Point by;
      for (std::size_t j = 0; j < from.size(); ++j) {
        by.push_back(from[j] + product(Complex(0.5, aside), to[j] - from[j]));
      }
      go_round(from, by, to, points, ends);
      drop_shared(ends);
    }
    return ends;
  }

 private:
  /// The lost ones by way of another form.
  void go_round(const Point& from, const Point& by, const Point& to,
                const std::vector<Point>& points, std::vector<std::optional<Point>>& ends) const {
    std::vector<std::size_t> lost;
    std::vector<Point> begins;
    for (std::size_t k = 0; k < ends.size(); ++k) {
      if (ends[k]) continue;
      lost.push_back(k);
      begins.push_back(points[k]);
    }
    std::vector<std::size_t> halfway;
    std::vector<Point> middles;
    auto reached = follow_roots(curve_, from, by, begins, follower_);
    for (std::size_t k = 0; k < reached.size(); ++k) {
      if (!reached[k]) continue;
      halfway.push_back(lost[k]);
      middles.push_back(*std::move(reached[k]));
    }
    auto arrived = follow_roots(curve_, by, to, middles, follower_);
    for (std::size_t k = 0; k < arrived.size(); ++k) ends[halfway[k]] = std::move(arrived[k]);
  }

  const System& curve_;
  const Follower& follower_;
};

/// Where the form splits its points lie over p* or on l(x) = 1, and each point of a generic form
/// comes to one of them.
struct RootsOfCurve {
  std::size_t known = 0;    ///< of the family
  std::size_t missing = 0;  ///< at p*, and none of the family's
};

RootsOfCurve roots_among(const std::vector<std::optional<Point>>& split_points,
                         const Family& family) {
  const RootSet known(family.roots);
  RootsOfCurve roots;
  for (std::optional<Point> point : split_points) {
    if (!point || std::abs(point->back()) > kAtBase) continue;
    point->pop_back();
    ++(known.holds(*point) ? roots.known : roots.missing);
  }
  return roots;
}

}  // namespace

TraceTest trace_test(const Family& family, const Tracker& tracker, const MonodromyOptions& options,
                     const std::atomic<bool>& stop) {
  require_unbroken(broken_rules(family));
  TraceTest test;
  if (family.roots.empty()) return test;
  const std::size_t n = family.unknowns();
  Point v;
  for (std::size_t j = 0; j < family.parameters(); ++j) {
    v.push_back(family.sizes[j] * random_number(options.seed, kLine, j));
  }
  const System curve = curve_system(family, v);
  const Follower follower{tracker, stop, options.threads, options.observations};
  std::vector<Point> starts = family.roots;
  for (Point& point : starts) point.push_back(0);
  const Point base = generic_form(n, options.seed);
  const Carrier carrier(curve, follower);
  const Point split = split_form(n, options.seed);
  RootSet points;
  for (auto& end : carrier.carry(split, base, starts)) {
    if (end) points.add(*std::move(end));  // loops may find the others
  }
  const LoopSearch search{std::vector<double>(base.size(), 1.0), kTestLoops, options};
  if (go_round_loops(curve, base, search, follower, points).was_cut) return test;
  test.points = points.size();
  const Complex step = random_number(options.seed, kSum, n + 1);
  for (const double length : kSteps) {
    std::vector<Trace> traces{trace_of(points.roots(), options.seed)};
    for (const double multiple : {1.0, 2.0}) {
      Point moved = base;
      moved.back() += multiple * length * step;
      std::vector<Point> ends;
      for (auto& end : carrier.carry(base, moved, points.roots())) {
        if (end) ends.push_back(*std::move(end));
      }
      test.lost = points.size() - ends.size();
      if (test.lost > 0) return test;
      traces.push_back(trace_of(ends, options.seed));
    }
    const double size = traces[0].size + traces[1].size + traces[2].size;
    const double bend = std::abs(traces[0].sum - 2.0 * traces[1].sum + traces[2].sum);
    test.defect = std::max(test.defect, bend / size);
  }
  const auto split_points = carrier.carry(base, split, points.roots());
  const RootsOfCurve roots = roots_among(split_points, family);
  test.missing = roots.missing;
  // A point that was lost may be a missing root, and one of the family's that the points do not
  // come back to was lost on its way to them.
  test.lost = std::max(count_lost(split_points), family.roots.size() - roots.known);
  test.was_made = test.lost == 0;
  test.holds = test.was_made && test.defect <= kLinear && test.missing == 0;
  return test;
}

}  // namespace moivre
