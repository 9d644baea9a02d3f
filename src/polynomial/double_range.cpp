// SPDX-License-Identifier: MIT
// The smallest and the largest part of a coefficient, as powers of two.
#include "moivre/polynomial/double_range.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "moivre/numeric/invalid_input.h"
#include "moivre/polynomial/scale.h"

namespace moivre {
namespace {

/// Below 2^kEnd a number, once rounded, is finite.
constexpr int kEnd = std::numeric_limits<double>::max_exponent - 1;

bool is_held(const Rational& r) {
  const double rounded = to_double(r);
  return std::isfinite(rounded) && (rounded != 0 || r.is_zero());
}

bool is_held(const Polynomial& p) {
  return std::all_of(p.terms.begin(), p.terms.end(), [](const Term& term) {
    return is_held(term.coefficient.re) && is_held(term.coefficient.im);
  });
}

}  // namespace

Polynomial times_power_of_two(Polynomial p, int k) {
  if (k == 0) return p;
  for (Term& term : p.terms) {
    term.coefficient = {times_power_of_two(term.coefficient.re, k),
                        times_power_of_two(term.coefficient.im, k)};
  }
  return p;
}

std::optional<int> log2_into_double(const Polynomial& p) {
  if (is_held(p)) return 0;
  double least = std::numeric_limits<double>::infinity();
  double largest = -least;
  for (const Term& term : p.terms) {
    for (const Rational* part : {&term.coefficient.re, &term.coefficient.im}) {
      if (part->is_zero()) continue;
      const double size = log2_size(Coefficient{*part});
      least = std::min(least, size);
      largest = std::max(largest, size);
    }
  }
  const double k = std::min(-std::round((least + largest) / 2), std::floor(kEnd - largest));
  const int power = static_cast<int>(k);
  if (!is_held(times_power_of_two(p, power))) return std::nullopt;
  return power;
}

bool add_equation(Polynomial p, System& f) {
  const std::optional<int> power = log2_into_double(p);
  if (!power) return false;
  if (*power != 0 || !f.scaled_log2.empty()) {
    f.scaled_log2.resize(f.polynomials.size());
    f.scaled_log2.push_back(*power);
  }
  f.polynomials.push_back(times_power_of_two(std::move(p), *power));
  return true;
}

System held_by_double(System f) {
  std::vector<std::string> beyond;
  std::vector<Polynomial> given;
  given.swap(f.polynomials);
  for (std::size_t i = 0; i < given.size(); ++i) {
    if (add_equation(std::move(given[i]), f)) continue;
    beyond.push_back("equation " + std::to_string(i + 1) + ": " + kBeyondDouble);
  }
  require_unbroken(beyond);
  return f;
}

System as_typed(System f) {
  for (std::size_t i = 0; i < f.scaled_log2.size(); ++i) {
    f.polynomials[i] = times_power_of_two(std::move(f.polynomials[i]), -f.scaled_log2[i]);
  }
  f.scaled_log2.clear();
  return f;
}

}  // namespace moivre
