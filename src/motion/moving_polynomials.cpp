// SPDX-License-Identifier: MIT
// Formulations at Chebyshev's nodes, and the series through them.
#include "moving_polynomials.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace moivre {
namespace {

using Eigen::Index;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kFewestNodes = 8;
constexpr int kMostNodes = 32;
// With the fewest nodes a smooth coefficient's last terms are this small already, beside the
// largest coefficient of its rows.
constexpr double kSmooth = 1e-3;
// A stretch so much shorter is not halved again: there is a corner in it.
constexpr int kMostHalvings = 5;
// Beside the largest coefficient of its rows: what the series leaves out is rounding.
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
  find_groups();
}

/// Rows of one name with the same monomials.
void MovingPolynomials::find_groups() {
  const auto monomials = [](const std::map<Monomial, std::size_t>& numbers) {
    std::vector<Monomial> all;
    for (const auto& [monomial, number] : numbers) all.push_back(monomial);
    return all;
  };
  for (std::size_t row = 0; row < rows_.size(); ++row) {
    const auto known = std::find_if(groups_.begin(), groups_.end(), [&](const Group& group) {
      return formulation_.equation_names[group.front()] == formulation_.equation_names[row] &&
             monomials(number_[group.front()]) == monomials(number_[row]);
    });
    if (known == groups_.end()) {
      groups_.push_back({row});
    } else {
      known->push_back(row);
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

/// One row each, its monomials in their order.
Eigen::MatrixXcd MovingPolynomials::rows_of(const Group& group,
                                            const std::vector<Complex>& c) const {
  Eigen::MatrixXcd rows(static_cast<Index>(group.size()),
                        static_cast<Index>(number_[group.front()].size()));
  for (Index row = 0; row < rows.rows(); ++row) {
    Index column = 0;
    for (const auto& [monomial, number] : number_[group[static_cast<std::size_t>(row)]]) {
      rows(row, column++) = c[number];
    }
  }
  return rows;
}

/// (R M^H)^-1, the rows of M of length 1.
Eigen::MatrixXcd MovingPolynomials::to_span(const Group& group, const std::vector<Complex>& c,
                                            const std::vector<Complex>& middle) const {
  const Eigen::MatrixXcd M = rows_of(group, middle).rowwise().normalized();
  return (rows_of(group, c) * M.adjoint()).inverse();
}

template <class Number>
void MovingPolynomials::replace_rows(const Group& group, const Eigen::MatrixXcd& by,
                                     std::vector<Number>& c) const {
  for (const auto& [monomial, first] : number_[group.front()]) {
    std::vector<Number> column;
    for (const std::size_t row : group) column.push_back(c[number_[row].at(monomial)]);
    for (std::size_t i = 0; i < group.size(); ++i) {
      Number sum = 0.0;
      for (std::size_t k = 0; k < group.size(); ++k) {
        sum += product(Number(by(static_cast<Index>(i), static_cast<Index>(k))), column[k]);
      }
      c[number_[group[i]].at(monomial)] = sum;
    }
  }
}

/// How large the last two terms of the series are, beside the largest coefficient of the rows.
double MovingPolynomials::last_share(const Group& group,
                                     const std::vector<std::vector<Complex>>& series,
                                     const std::vector<std::vector<Complex>>& nodes) const {
  double size = 1;
  for (const auto& node : nodes) {
    size = std::max(size, rows_of(group, node).cwiseAbs().maxCoeff());
  }
  double last = 0;
  for (std::size_t k = series.size() - 2; k < series.size(); ++k) {
    const Eigen::MatrixXcd rows = rows_of(group, series[k]);
    last = rows.allFinite() ? std::max(last, rows.cwiseAbs().maxCoeff()) : kInfinity;
  }
  return last / size;
}

std::optional<std::vector<ComplexDoubleDouble>> MovingPolynomials::sharply_at(
    double t, const std::vector<std::size_t>& rows) const {
  const Stretch* here = stretch_at(t, rows);
  auto c = here == nullptr ? std::nullopt : coefficients(t);
  if (!c) return std::nullopt;
  std::vector<Complex> rounded;
  for (const ComplexDoubleDouble& exact : *c) rounded.push_back(to_complex(exact));
  // What is rounded of a factor is the same for whole rows.
  for (const Group& group : groups_) {
    if (!number_[group.front()].empty()) {
      replace_rows(group, to_span(group, rounded, here->middle), *c);
    }
  }
  return c;
}

/// The series of as many nodes as the rows want.
void MovingPolynomials::fill(Stretch& stretch) const {
  std::map<int, std::vector<Complex>> known;  // by the node's number among kMostNodes
  const auto at_node = [&](int number) -> const std::vector<Complex>* {
    const auto at = known.find(number);
    if (at != known.end()) return &at->second;
    const double x = std::cos(std::numbers::pi * number / kMostNodes);
    const double t = (stretch.from + stretch.to) / 2 + x * (stretch.to - stretch.from) / 2;
    const auto c = coefficients(t);
    if (!c) return nullptr;
    std::vector<Complex>& rounded = known[number];
    for (const ComplexDoubleDouble& exact : *c) rounded.push_back(to_complex(exact));
    if (stretch.middle.empty()) stretch.middle = rounded;
    for (const Group& group : groups_) {
      if (number_[group.front()].empty()) continue;
      replace_rows(group, to_span(group, rounded, stretch.middle), rounded);
    }
    return &rounded;
  };
  if (at_node(kMostNodes / 2) == nullptr) return;
  bool may_fall = true;
  for (int n = kFewestNodes; n <= kMostNodes && may_fall; n *= 2) {
    std::vector<std::vector<Complex>> nodes;
    for (int j = 0; j <= n; ++j) {
      const std::vector<Complex>* const node = at_node(j * (kMostNodes / n));
      if (node == nullptr) return;
      nodes.push_back(*node);
    }
    stretch.series = chebyshev(nodes);
    may_fall = false;
    for (const Group& group : groups_) {
      const bool is_empty = number_[group.front()].empty();
      const double last = is_empty ? 0 : last_share(group, stretch.series, nodes);
      for (const std::size_t row : group) stretch.is_smooth[row] = last <= kRoundingOfSeries;
      may_fall = may_fall || (last > kRoundingOfSeries && last <= kSmooth);
    }
  }
}

MovingPolynomials::Stretch MovingPolynomials::stretch(double from, double to) const {
  Stretch made{from, to, {}, {}, std::vector<bool>(rows_.size(), false)};
  fill(made);
  return made;
}

/// The longest stretch in which the rows are smooth; nullptr: there is none.
const MovingPolynomials::Stretch* MovingPolynomials::stretch_at(
    double t, const std::vector<std::size_t>& rows) const {
  const auto after = std::upper_bound(borders_.begin() + 1, borders_.end() - 1, t);
  double from = *(after - 1);
  double to = *after;
  for (int k = 0; k <= kMostHalvings; ++k) {
    auto known = stretches_.find({from, to});
    if (known == stretches_.end()) {
      known = stretches_.emplace(std::pair(from, to), stretch(from, to)).first;
    }
    const Stretch& here = known->second;
    if (std::all_of(rows.begin(), rows.end(), [&](std::size_t r) { return here.is_smooth[r]; })) {
      return &here;
    }
    const double middle = (from + to) / 2;
    (t < middle ? to : from) = middle;
  }
  return nullptr;
}

std::optional<MovingPolynomials::Coefficients> MovingPolynomials::at(
    double t, const std::vector<std::size_t>& rows) const {
  if (terms_ == 0 || !(t >= borders_.front() && t <= borders_.back())) return std::nullopt;
  const Stretch* const stretch = stretch_at(t, rows);
  if (stretch == nullptr) return std::nullopt;
  const Stretch& here = *stretch;
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
