// SPDX-License-Identifier: MIT
// Candidates, each counted once.
#include "exact_roots.h"

#include <algorithm>
#include <cmath>

#include "coincidence.h"
#include "moivre/algebra/local_multiplicity.h"
#include "moivre/numeric/simplest.h"

namespace moivre {
namespace {

// How far an end may be from its root: nothing, all digits of double, and what is left of them at
// roots of low, of middle and of high multiplicity.
constexpr double kEndErrors[] = {0, 1e-15, 1e-12, 1e-9, 1e-5, 1e-2};
// The worst of them.
constexpr double kWorstEnd = 0.1;
// A root of multiplicity m leaves m paths, some of them near it. More candidates than this would
// cost more than paths do.
constexpr std::size_t kMostFailures = 64;

ExactRoot root_at(const System& f, const std::vector<Coefficient>& candidate) {
  ExactRoot root;
  for (const Coefficient& z : candidate) {
    root.x.push_back(to_complex(z));
    root.is_rounded = root.is_rounded || Rational(root.x.back().real()) != z.re ||
                      Rational(root.x.back().imag()) != z.im;
  }
  root.multiplicity = local_multiplicity(f, candidate).value_or(0);
  return root;
}

std::vector<Rational> parts_of(const std::vector<Coefficient>& candidate) {
  std::vector<Rational> parts;
  for (const Coefficient& z : candidate) parts.insert(parts.end(), {z.re, z.im});
  return parts;
}

std::vector<double> numbers_of(const Point& x) {
  std::vector<double> numbers;
  for (const Complex& xi : x) numbers.insert(numbers.end(), {xi.real(), xi.imag()});
  return numbers;
}

/// Until one of the roundings is a root. What was found near a point once is found again.
void look_near(Run& run, const Point& x) {
  const bool is_finite = std::all_of(x.begin(), x.end(), [](const Complex& xi) {
    return std::isfinite(xi.real()) && std::isfinite(xi.imag());
  });
  if (!is_finite) return;
  std::vector<double> numbers = numbers_of(x);
  if (run.looked_near.contains(numbers)) return;
  for (const std::vector<Coefficient>& candidate : fractions_near(x, kWorstEnd)) {
    const auto [place, is_new] = run.looked_at.try_emplace(parts_of(candidate));
    if (is_new) place->second = root_at(run.setting.f, candidate);
    if (place->second.multiplicity > 0) break;
    run.require_time();
  }
  run.looked_near.insert(std::move(numbers));
}

}  // namespace

std::vector<std::vector<Coefficient>> fractions_near(const Point& x, double known_to) {
  std::vector<std::vector<Coefficient>> candidates;
  for (const double error : kEndErrors) {
    if (error < known_to) candidates.push_back(simplest(x, error));
  }
  const double known = known_to * std::max(1.0, max_norm(x));
  std::vector<Coefficient>& last = candidates.emplace_back();
  for (const Complex& xi : x)
    last.push_back({simplest(xi.real(), known), simplest(xi.imag(), known)});
  return candidates;
}

std::vector<ExactRoot> exact_roots(Run& run) {
  if (!run.ring_roots.empty()) return run.ring_roots;
  look_near(run, Point(run.setting.f.variables.size()));
  for (const auto& [path, root] : run.table.roots()) {
    if (!root.point.simple && !is_on_set(run, root)) look_near(run, root.point.x);
  }
  std::size_t looked = 0;
  for (const auto& [path, x] : run.table.last_points()) {
    if (++looked > kMostFailures) break;
    look_near(run, x);
  }
  std::vector<ExactRoot> roots;
  for (const auto& [candidate, root] : run.looked_at) {
    if (root.multiplicity > 1) roots.push_back(root);
  }
  return roots;
}

bool is_counted_by(const std::vector<ExactRoot>& exact, const Root& end, std::size_t paths) {
  if (end.is_exact) return true;
  return std::any_of(exact.begin(), exact.end(), [&](const ExactRoot& root) {
    return root.multiplicity == paths && relative_distance(root.x, end.point.x) <= end.tolerance;
  });
}

}  // namespace moivre
