// SPDX-License-Identifier: MIT
// Scaling by powers of two: least squares on the logarithms of the coefficients.
#include "moivre/polynomial/scale.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "moivre/factorization/qr.h"
#include "moivre/numeric/integer.h"
#include "moivre/numeric/invalid_input.h"

namespace moivre {
namespace {

/// Unknowns are scaled where the deviations within the equations fall at least to this fraction.
constexpr double kWorthwhile = 0.5;

/// Relative size below which an eigenvalue of the normal matrix counts as zero. Its entries are
/// sums of products of small integers over term counts, so that true eigenvalues are far above.
constexpr double kRankTolerance = 1e-10;

/// Largest shift of one coefficient: beyond it a scaled coefficient would take megabytes.
constexpr double kLargestShift = 1 << 20;

/// Bits kept of a long integer before its logarithm is taken: more than a double holds.
constexpr unsigned kLeadingBits = 64;

double log2_size(const Integer& a) {
  const auto bits = msb(a) + 1;
  const auto dropped = bits > kLeadingBits ? bits - kLeadingBits : 0;
  return std::log2(static_cast<double>(Integer(a >> dropped))) + static_cast<double>(dropped);
}

double log2_size(const Rational& a) {
  return log2_size(Integer(abs(numerator(a)))) - log2_size(denominator(a));
}

double shift(const Monomial& m, const std::vector<double>& v) {
  double sum = 0;
  for (const Power& p : m) sum += p.exponent * v[p.variable];
  return sum;
}

/// log2|c_ik|: one row for each equation, one entry for each term.
using Sizes = std::vector<std::vector<double>>;

Sizes log2_sizes(const System& f) {
  Sizes sizes;
  for (const Polynomial& p : f.polynomials) {
    std::vector<double> row;
    for (const Term& term : p.terms) row.push_back(log2_size(term.coefficient));
    sizes.push_back(std::move(row));
  }
  return sizes;
}

Sizes shifted(const System& f, Sizes sizes, const std::vector<double>& v) {
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    for (std::size_t k = 0; k < sizes[i].size(); ++k) {
      sizes[i][k] += shift(f.polynomials[i].terms[k].monomial, v);
    }
  }
  return sizes;
}

double mean(const std::vector<double>& row) {
  double sum = 0;
  for (double a : row) sum += a;
  return row.empty() ? 0 : sum / static_cast<double>(row.size());
}

bool is_mild(const std::vector<double>& row) {
  return std::all_of(row.begin(), row.end(), [](double a) { return std::abs(a) <= kMildSize; });
}

/// The objective when every r_i is at its best: an equation's weight is 1 + its number of terms,
/// since the sum of (E_k - E_l)^2 over the pairs is the number of terms times the sum of (E_k -
/// mean)^2.
double weight(const std::vector<double>& row) { return 1 + static_cast<double>(row.size()); }

double deviation(const Sizes& sizes) {
  double sum = 0;
  for (const auto& row : sizes) {
    const double centre = mean(row);
    for (double a : row) sum += weight(row) * (a - centre) * (a - centre);
  }
  return std::sqrt(sum);
}

/// v of least norm that minimizes the deviation: normal equations  A v = b  from the centred
/// exponents of each equation.
Eigen::VectorXd least_squares(const System& f, const Sizes& sizes) {
  const auto n = static_cast<Eigen::Index>(f.variables.size());
  Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(n, n);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(n);
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    const double w = weight(sizes[i]);
    const double centre = mean(sizes[i]);
    const double count = static_cast<double>(sizes[i].size());
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(n);
    for (std::size_t k = 0; k < sizes[i].size(); ++k) {
      const Monomial& m = f.polynomials[i].terms[k].monomial;
      for (const Power& p : m) {
        sum[p.variable] += p.exponent;
        right[p.variable] -= w * p.exponent * (sizes[i][k] - centre);
        for (const Power& q : m) {
          normal(p.variable, q.variable) += w * p.exponent * static_cast<double>(q.exponent);
        }
      }
    }
    if (count > 0) normal.noalias() -= (w / count) * sum * sum.transpose();
  }
  return shortest_solution(normal, right, kRankTolerance);
}

/// Integers nearest to the minimum, or zeros where they do not pay or would make coefficients of
/// megabytes.
std::vector<double> variable_exponents(const System& f, const Sizes& sizes) {
  std::vector<double> none(f.variables.size(), 0.0);
  if (none.empty()) return none;
  const Eigen::VectorXd best = least_squares(f, sizes);
  std::vector<double> v(none.size());
  for (std::size_t j = 0; j < v.size(); ++j) {
    v[j] = std::round(best[static_cast<Eigen::Index>(j)]);
    if (!(std::abs(v[j]) <= std::numeric_limits<int>::max())) return none;
  }
  for (const Polynomial& p : f.polynomials) {
    for (const Term& term : p.terms) {
      if (std::abs(shift(term.monomial, v)) > kLargestShift) return none;
    }
  }
  return deviation(shifted(f, sizes, v)) <= kWorthwhile * deviation(sizes) ? v : none;
}

}  // namespace

Rational times_power_of_two(const Rational& a, std::int64_t exponent) {
  const auto bits = static_cast<unsigned>(std::abs(exponent));
  return exponent >= 0 ? ratio(numerator(a) << bits, denominator(a))
                       : ratio(numerator(a), denominator(a) << bits);
}

double log2_size(const Coefficient& c) {
  if (is_real(c)) return log2_size(c.re);
  if (c.re.is_zero()) return log2_size(c.im);
  const double re = log2_size(c.re);
  const double im = log2_size(c.im);
  const double unit = std::floor(std::max(re, im));
  return unit + std::log2(std::hypot(std::exp2(re - unit), std::exp2(im - unit)));
}

Scaling choose_scaling(const System& f) {
  Scaling scaling{std::vector<int>(f.variables.size(), 0),
                  std::vector<int>(f.polynomials.size(), 0)};
  const Sizes sizes = log2_sizes(f);
  if (std::all_of(sizes.begin(), sizes.end(), is_mild)) return scaling;

  const std::vector<double> v = variable_exponents(f, sizes);
  const Sizes now = shifted(f, sizes, v);
  const bool scales_unknowns = std::any_of(v.begin(), v.end(), [](double a) { return a != 0; });
  for (std::size_t j = 0; j < v.size(); ++j) scaling.variable_log2[j] = static_cast<int>(v[j]);
  for (std::size_t i = 0; i < now.size(); ++i) {
    const double r = -std::round(mean(now[i]));
    if ((scales_unknowns || !is_mild(now[i])) && std::abs(r) <= kLargestShift) {
      scaling.equation_log2[i] = static_cast<int>(r);
    }
  }
  return scaling;
}

System scale(const System& f, const Scaling& scaling) {
  if (scaling.variable_log2.size() != f.variables.size() ||
      scaling.equation_log2.size() != f.polynomials.size()) {
    throw InvalidInput("the scaling has another shape than the system");
  }
  System g = f;
  for (std::size_t i = 0; i < g.polynomials.size(); ++i) {
    for (Term& term : g.polynomials[i].terms) {
      std::int64_t exponent = scaling.equation_log2[i];
      for (const Power& p : term.monomial) {
        exponent += std::int64_t{p.exponent} * scaling.variable_log2[p.variable];
      }
      term.coefficient = {times_power_of_two(term.coefficient.re, exponent),
                          times_power_of_two(term.coefficient.im, exponent)};
    }
  }
  return g;
}

bool is_identity(const Scaling& scaling) {
  const auto is_zero = [](int exponent) { return exponent == 0; };
  return std::all_of(scaling.variable_log2.begin(), scaling.variable_log2.end(), is_zero) &&
         std::all_of(scaling.equation_log2.begin(), scaling.equation_log2.end(), is_zero);
}

std::string to_text(const Scaling& scaling) {
  std::string text;
  const auto tell = [&](const char* what, const std::vector<int>& exponents) {
    const auto [low, high] = std::minmax_element(exponents.begin(), exponents.end());
    if (exponents.empty() || (*low == 0 && *high == 0)) return;
    text += (text.empty() ? "" : ", ") + std::string(what) + " by 2^" + std::to_string(*low);
    if (*low < *high) text += " to 2^" + std::to_string(*high);
  };
  tell("unknowns", scaling.variable_log2);
  tell("equations", scaling.equation_log2);
  return text;
}

std::vector<std::complex<double>> restore(const Scaling& scaling,
                                          const std::vector<std::complex<double>>& y) {
  if (scaling.variable_log2.size() != y.size()) {
    throw InvalidInput("the point has another dimension than the scaling");
  }
  std::vector<std::complex<double>> x(y.size());
  for (std::size_t j = 0; j < y.size(); ++j) {
    x[j] = {std::ldexp(y[j].real(), scaling.variable_log2[j]),
            std::ldexp(y[j].imag(), scaling.variable_log2[j])};
  }
  return x;
}

}  // namespace moivre
