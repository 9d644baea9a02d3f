// SPDX-License-Identifier: MIT
// Polynomials for tests, and exact evaluation.
#include "build.h"

#include <utility>

namespace moivre::build {

Polynomial constant(const Rational& re, const Rational& im) {
  TermMap terms;
  terms[{}] = Coefficient{re, im};
  return to_polynomial(terms);
}

Polynomial variable(std::uint32_t j) { return {{Term{Coefficient{1, 0}, {{j, 1}}}}}; }

Polynomial power(const Polynomial& p, int exponent) {
  Polynomial result = constant(1);
  for (int i = 0; i < exponent; ++i) result = result * p;
  return result;
}

System system(std::size_t unknowns, std::vector<Polynomial> polynomials) {
  System f;
  for (std::size_t j = 0; j < unknowns; ++j)
    f.variables.push_back(std::string("x").append(std::to_string(j + 1)));
  f.polynomials = std::move(polynomials);
  return f;
}

Coefficient value(const Polynomial& p, const Point& x) {
  Coefficient sum;
  for (const Term& term : p.terms) {
    Coefficient product = term.coefficient;
    for (const Power& factor : term.monomial) {
      for (std::uint32_t e = 0; e < factor.exponent; ++e) product = product * x[factor.variable];
    }
    sum = sum + product;
  }
  return sum;
}

Point value(const System& f, const Point& x) {
  Point values;
  for (const Polynomial& p : f.polynomials) values.push_back(value(p, x));
  return values;
}

Coefficient random_number(std::mt19937_64& random) {
  std::uniform_int_distribution<int> numerator(-9, 9);
  std::uniform_int_distribution<int> denominator(1, 5);
  return {Rational(numerator(random), denominator(random)),
          Rational(numerator(random), denominator(random))};
}

Coefficient random_integer(std::mt19937_64& random, bool is_real) {
  std::uniform_int_distribution<int> part(-9, 9);
  const int re = part(random);
  return {re, is_real ? 0 : part(random)};
}

Polynomial through(const Polynomial& p, const Point& x) { return p + (-value(p, x)) * constant(1); }

Point random_point(std::size_t n, std::mt19937_64& random) {
  Point x;
  for (std::size_t j = 0; j < n; ++j) x.push_back(random_number(random));
  return x;
}

Polynomial random_polynomial(std::uint32_t unknowns, int degree, std::mt19937_64& random) {
  Polynomial affine = constant(1);
  for (std::uint32_t j = 0; j < unknowns; ++j) affine = affine + variable(j);
  Polynomial p = power(affine, degree);
  for (Term& term : p.terms) {
    do {
      term.coefficient = random_number(random);
    } while (is_zero(term.coefficient));
  }
  return p;
}

std::size_t rank(std::vector<Point> rows) {
  std::size_t rank = 0;
  const std::size_t columns = rows.empty() ? 0 : rows[0].size();
  for (std::size_t column = 0; column < columns && rank < rows.size(); ++column) {
    std::size_t pivot = rank;
    while (pivot < rows.size() && is_zero(rows[pivot][column])) ++pivot;
    if (pivot == rows.size()) continue;
    std::swap(rows[rank], rows[pivot]);
    for (std::size_t i = rank + 1; i < rows.size(); ++i) {
      const Coefficient multiple = rows[i][column] / rows[rank][column];
      for (std::size_t k = column; k < columns; ++k) {
        rows[i][k] = rows[i][k] - multiple * rows[rank][k];
      }
    }
    ++rank;
  }
  return rank;
}

System katsura(std::uint32_t n) {
  std::vector<Polynomial> equations;
  const auto u = [n](int k) {
    const auto m = static_cast<std::uint32_t>(k < 0 ? -k : k);
    return m <= n ? variable(m) : Polynomial{};
  };
  Polynomial sum = u(0) - constant(1);
  for (std::uint32_t k = 1; k <= n; ++k) sum = sum + Rational(2) * variable(k);
  equations.push_back(sum);
  const int last = static_cast<int>(n);
  for (int m = 0; m < last; ++m) {
    Polynomial p = Rational(-1) * u(m);
    for (int k = -last; k <= last; ++k) p = p + u(k) * u(m - k);
    equations.push_back(p);
  }
  return system(n + 1, equations);
}

System cyclic(std::uint32_t n) {
  std::vector<Polynomial> equations;
  for (std::uint32_t length = 1; length <= n; ++length) {
    Polynomial sum;
    for (std::uint32_t first = 0; first < (length == n ? 1 : n); ++first) {
      Polynomial term = constant(1);
      for (std::uint32_t k = 0; k < length; ++k) term = term * variable((first + k) % n);
      sum = sum + term;
    }
    equations.push_back(length == n ? sum - constant(1) : sum);
  }
  return system(n, equations);
}

System noon(std::uint32_t n) {
  std::vector<Polynomial> equations;
  for (std::uint32_t i = 0; i < n; ++i) {
    Polynomial others;
    for (std::uint32_t k = 0; k < n; ++k) {
      if (k != i) others = others + variable(k) * variable(k);
    }
    equations.push_back(variable(i) * others - Rational(11, 10) * variable(i) + constant(1));
  }
  return system(n, equations);
}

System eco(std::uint32_t n) {
  std::vector<Polynomial> equations;
  const Polynomial last = variable(n - 1);
  for (std::uint32_t k = 1; k < n; ++k) {
    Polynomial sum = variable(k - 1);
    for (std::uint32_t i = 1; i + k <= n - 1; ++i) {
      sum = sum + variable(i - 1) * variable(i + k - 1);
    }
    equations.push_back(sum * last - constant(k));
  }
  Polynomial linear = constant(1);
  for (std::uint32_t k = 0; k + 1 < n; ++k) linear = linear + variable(k);
  equations.push_back(linear);
  return system(n, equations);
}

}  // namespace moivre::build
