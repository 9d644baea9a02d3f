// SPDX-License-Identifier: MIT
// Formulations at Chebyshev's nodes, and the series through them.
#include "moving_polynomials.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace moivre {
namespace {

constexpr int kFewestNodes = 8;
constexpr int kMostNodes = 32;
// With the fewest nodes a smooth coefficient's last terms are this small already, beside the largest coefficient of its row.
constexpr double kSmooth = 1e-3;
// A stretch so much shorter is not halved again: there is a corner in it. Spatial ones are not halved, their formulations take long.
constexpr int kMostHalvings = 5;
// Beside the largest coefficient of its row: what the series leaves out is rounding.
constexpr double kRoundingOfSeries = 3e-14;

/// Values at cos(pi j / n), j = 0 .. n, to the coefficients of Chebyshev's polynomials.
std::vector<std::vector<Complex>> chebyshev(const std::vector<std::vector<Complex>>& nodes) {
  const std::size_t n = nodes.size() - 1;
  std::vector<std::vector<Complex>> series(n + 1, std::vector<Complex>(nodes.front().size()));
  for (std::size_t k = 0; k <= n; ++k) {
    for (std::size_t j = 0; j <= n; ++j) {
      const double angle =
          std::numbers::pi * static_cast<double>(j * k % (2 * n)) / static_cast<double>(n);
      double weight = 2.0 / static_cast<double>(n) * std::cos(angle);
      if (j == 0 || j == n) weight /= 2;
      if (k == 0 || k == n) weight /= 2;
      for (std::size_t c = 0; c < series[k].size(); ++c) series[k][c] += weight * nodes[j][c];
    }
  }
  return series;
}

/// Whether the last two terms are no more than `most`, beside the sizes.
bool has_fallen(const std::vector<std::vector<Complex>>& series, const std::vector<double>& sizes,
                double most) {
  for (std::size_t k = series.size() - 2; k < series.size(); ++k) {
    for (std::size_t c = 0; c < sizes.size(); ++c) {
      if (!(std::abs(series[k][c]) <= most * sizes[c])) return false;
    }
  }
  return true;
}

bool has_same_unknowns(const Formulation& a, const Formulation& b) {
  return a.system.variables == b.system.variables && a.equation_names == b.equation_names &&
         a.system.polynomials.size() == b.system.polynomials.size();
}

}  // namespace

MovingPolynomials::MovingPolynomials(const Mechanism& mechanism, std::vector<double> borders)
    : mechanism_(mechanism), borders_(std::move(borders)) {
  // Two times at which nothing is special: a monomial may be missing where a sine is zero.
  constexpr double kFirst = 0.3141;
  constexpr double kSecond = 0.7071;
  const auto within = [&](double share) {
    return borders_.front() + share * (borders_.back() - borders_.front());
  };
  formulation_ = formulate(mechanism, within(kFirst));
  const Formulation other = formulate(mechanism, within(kSecond));
  const double length = formulation_.length > 0 ? formulation_.length : 1;
  for (const bool is_direction : formulation_.is_direction) {
    units_.push_back(is_direction ? 1 : length);
  }
  number_.resize(formulation_.system.polynomials.size());
  rows_.resize(number_.size());
  if (!has_same_unknowns(formulation_, other)) return;
  for (std::size_t row = 0; row < rows_.size(); ++row) {
    const std::vector<Term> terms = formulation_.system.polynomials[row].terms;
    for (const std::vector<Term>* of : {&terms, &other.system.polynomials[row].terms}) {
      for (const Term& term : *of) {
        if (!number_[row].emplace(term.monomial, terms_).second) continue;
        if (of != &terms) formulation_.system.polynomials[row].terms.push_back(term);
        MovingTerm moving{terms_++, {}};
        for (const Power& power : term.monomial) {
          moving.factors.insert(moving.factors.end(), power.exponent, power.variable);
        }
        rows_[row].push_back(std::move(moving));
      }
    }
  }
}

std::optional<std::vector<ComplexDoubleDouble>> MovingPolynomials::coefficients(double t) const {
  const Formulation f = formulate(mechanism_, t);
  if (!has_same_unknowns(formulation_, f)) return std::nullopt;
  std::vector<ComplexDoubleDouble> c(terms_);
  for (std::size_t row = 0; row < rows_.size(); ++row) {
    for (const Term& term : f.system.polynomials[row].terms) {
      const auto at = number_[row].find(term.monomial);
      if (at == number_[row].end()) return std::nullopt;
      c[at->second] = to_complex_double_double(term.coefficient);
    }
    for (const MovingTerm& term : rows_[row]) {
      for (const std::uint32_t v : term.factors) {
        c[term.number] = product(DoubleDouble(units_[v]), c[term.number]);
      }
    }
  }
  return c;
}

/// Of each row the number of its largest coefficient; terms_ of a row without terms.
std::vector<std::size_t> MovingPolynomials::largest_terms(const std::vector<Complex>& c) const {
  std::vector<std::size_t> largest;
  for (const std::vector<MovingTerm>& row : rows_) {
    largest.push_back(row.empty() ? terms_ : row.front().number);
    for (const MovingTerm& term : row) {
      if (std::abs(c[term.number]) > std::abs(c[largest.back()])) largest.back() = term.number;
    }
  }
  return largest;
}

void MovingPolynomials::divide_rows(const std::vector<std::size_t>& divisors,
                                    std::vector<Complex>& c) const {
  for (std::size_t row = 0; row < rows_.size(); ++row) {
    if (rows_[row].empty()) continue;
    const Complex divisor = c[divisors[row]];
    for (const MovingTerm& term : rows_[row]) c[term.number] /= divisor;
  }
}

std::optional<std::vector<ComplexDoubleDouble>> MovingPolynomials::sharply_at(double t) const {
  const Stretch& here = stretch_at(t);
  auto c = here.series.empty() ? std::nullopt : coefficients(t);
  if (!c) return std::nullopt;
  for (std::size_t row = 0; row < rows_.size(); ++row) {
    if (rows_[row].empty()) continue;
    // Rounded, it is one factor of the whole row.
    const ComplexDoubleDouble factor = reciprocal(to_complex((*c)[here.divisors[row]]));
    for (const MovingTerm& term : rows_[row]) {
      (*c)[term.number] = product(factor, (*c)[term.number]);
    }
  }
  return c;
}

MovingPolynomials::Stretch MovingPolynomials::stretch(double from, double to) const {
  Stretch made{from, to, {}, {}};
  std::map<int, std::vector<Complex>> known;  // by the node's number among kMostNodes
  for (int n = kFewestNodes; n <= kMostNodes; n *= 2) {
    std::vector<std::vector<Complex>> nodes;
    for (int j = 0; j <= n; ++j) {
      const int number = j * (kMostNodes / n);
      const double x = std::cos(std::numbers::pi * number / kMostNodes);
      auto at = known.find(number);
      if (at == known.end()) {
        const auto c = coefficients((from + to) / 2 + x * (to - from) / 2);
        if (!c) return made;
        std::vector<Complex> rounded;
        for (const ComplexDoubleDouble& exact : *c) rounded.push_back(to_complex(exact));
        at = known.emplace(number, std::move(rounded)).first;
      }
      nodes.push_back(at->second);
    }
    made.divisors = largest_terms(nodes[nodes.size() / 2]);
    for (std::vector<Complex>& node : nodes) divide_rows(made.divisors, node);
    std::vector<double> sizes(terms_);
    for (const std::vector<MovingTerm>& row : rows_) {
      double size = 1;
      for (const MovingTerm& term : row) {
        for (const auto& node : nodes) size = std::max(size, std::abs(node[term.number]));
      }
      for (const MovingTerm& term : row) sizes[term.number] = size;
    }
    auto series = chebyshev(nodes);
    if (!has_fallen(series, sizes, kSmooth)) return made;
    if (!has_fallen(series, sizes, kRoundingOfSeries)) continue;
    made.series = std::move(series);
    return made;
  }
  return made;
}

const MovingPolynomials::Stretch& MovingPolynomials::stretch_at(double t) const {
  for (const Stretch& known : stretches_) {
    if (known.from <= t && t <= known.to) return known;
  }
  const auto after = std::upper_bound(borders_.begin() + 1, borders_.end() - 1, t);
  double from = *(after - 1);
  double to = *after;
  Stretch made = stretch(from, to);
  const int most = mechanism_.space == Space::planar ? kMostHalvings : 0;
  for (int k = 0; made.series.empty() && k < most; ++k) {
    const double middle = (from + to) / 2;
    (t < middle ? to : from) = middle;
    made = stretch(from, to);
  }
  stretches_.push_back(std::move(made));
  return stretches_.back();
}

std::optional<MovingPolynomials::Coefficients> MovingPolynomials::at(double t) const {
  if (terms_ == 0 || !(t >= borders_.front() && t <= borders_.back())) return std::nullopt;
  const Stretch& here = stretch_at(t);
  if (here.series.empty()) return std::nullopt;
  const double x = (2 * t - here.from - here.to) / (here.to - here.from);
  Coefficients moving;
  moving.c = here.series[0];
  moving.rate.assign(terms_, 0);
  // T_k and dT_k/dx by T_{k+1} = 2 x T_k - T_{k-1}.
  double before = 1;
  double now = x;
  double rate_before = 0;
  double rate_now = 1;
  for (std::size_t k = 1; k < here.series.size(); ++k) {
    for (std::size_t c = 0; c < terms_; ++c) {
      moving.c[c] += now * here.series[k][c];
      moving.rate[c] += rate_now * here.series[k][c];
    }
    const double next = 2 * x * now - before;
    const double rate_next = 2 * now + 2 * x * rate_now - rate_before;
    before = now;
    now = next;
    rate_before = rate_now;
    rate_now = rate_next;
  }
  for (Complex& rate : moving.rate) rate *= 2 / (here.to - here.from);
  return moving;
}

}  // namespace moivre
