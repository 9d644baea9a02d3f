// SPDX-License-Identifier: MIT
// What is counted of an equation once.
#include "elimination_state.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "moivre/polynomial/scale.h"

namespace moivre::elimination {
namespace {

double work_of(const Monomial& m) { return 1 + static_cast<double>(m.size()); }

double log2_size(const GaussianInteger& c, int shift) {
  return log2_size(Coefficient{ratio(c.re), ratio(c.im)}) + shift;
}

/// The unknowns of a linear equation that are large enough to divide by.
std::vector<Divisor> divisors_of(const IntegerPolynomial& p, const Limits& limits) {
  std::vector<Divisor> divisors;
  double largest = -std::numeric_limits<double>::infinity();
  for (const auto& [m, c] : p.terms) {
    if (m.empty()) continue;
    const std::uint32_t variable = m.front().variable;
    divisors.push_back({variable, log2_size(c, limits.variable_log2[variable])});
    largest = std::max(largest, divisors.back().size_log2);
  }
  std::erase_if(divisors, [largest](const Divisor& d) {
    return d.size_log2 < largest + std::log2(kPivotThreshold);
  });
  for (Divisor& d : divisors) d.size_log2 -= largest;
  return divisors;
}

std::vector<Occurrence> occurrences_in(const IntegerPolynomial& p) {
  std::vector<Occurrence> all;
  for (const auto& [m, c] : p.terms) {
    for (const Power& power : m) all.push_back({power.variable, power.exponent, 1});
  }
  const auto place = [](const Occurrence& o) { return std::pair(o.variable, o.exponent); };
  std::sort(all.begin(), all.end(),
            [&](const Occurrence& a, const Occurrence& b) { return place(a) < place(b); });
  std::vector<Occurrence> counted;
  for (const Occurrence& o : all) {
    if (!counted.empty() && place(counted.back()) == place(o)) {
      counted.back().count += 1;
    } else {
      counted.push_back(o);
    }
  }
  return counted;
}

}  // namespace

std::shared_ptr<const RowFacts> facts_of_row(IntegerPolynomial p, const Limits& limits) {
  auto equation = std::make_shared<RowFacts>();
  equation->degree = degree(p);
  for (const auto& [m, c] : p.terms) equation->work += work_of(m);
  equation->occurrences = occurrences_in(p);
  if (equation->degree == 1) equation->divisors = divisors_of(p, limits);
  equation->p = std::move(p);
  return equation;
}

Substitution to_substitution(const AffineForm& form) {
  Substitution result;
  result.variable = form.variable;
  for (const auto& [m, c] : form.terms) {
    const Coefficient value{ratio(c.re, form.divisor), ratio(c.im, form.divisor)};
    if (m.empty()) {
      result.constant = value;
    } else {
      result.terms.emplace_back(m.front().variable, value);
    }
  }
  return result;
}

std::vector<std::uint64_t> degrees_of(const std::vector<Row>& rows) {
  std::vector<std::uint64_t> result;
  for (const Row& row : rows) result.push_back(row.degree());
  return result;
}

double unknowns_left(const State& s) {
  return static_cast<double>(std::count(s.is_eliminated.begin(), s.is_eliminated.end(), false));
}

}  // namespace moivre::elimination
