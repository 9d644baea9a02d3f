// SPDX-License-Identifier: MIT
// The algebra of sparse polynomials with exact coefficients: order, sums, products, degrees.
#include "moivre/polynomial/system.h"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>

#include "moivre/numeric/invalid_input.h"

namespace moivre {

std::uint64_t degree(const Monomial& m) {
  std::uint64_t sum = 0;
  for (const Power& p : m) sum += p.exponent;
  return sum;
}

Monomial product(const Monomial& a, const Monomial& b) {
  Monomial ab;
  ab.reserve(a.size() + b.size());
  auto p = a.begin();
  auto q = b.begin();
  while (p != a.end() && q != b.end()) {
    if (p->variable < q->variable) {
      ab.push_back(*p++);
    } else if (q->variable < p->variable) {
      ab.push_back(*q++);
    } else {
      const std::uint32_t exponent = p->exponent + q->exponent;
      if (exponent < p->exponent) throw std::overflow_error("an exponent leaves 32 bits");
      ab.push_back({p->variable, exponent});
      ++p;
      ++q;
    }
  }
  ab.insert(ab.end(), p, a.end());
  ab.insert(ab.end(), q, b.end());
  return ab;
}

bool precedes(const Monomial& a, const Monomial& b) {
  const std::uint64_t degree_a = degree(a);
  const std::uint64_t degree_b = degree(b);
  if (degree_a != degree_b) return degree_a > degree_b;
  const auto [p, q] = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
  if (p == a.end() || q == b.end()) return false;  // of equal degree, so equal
  if (p->variable != q->variable) return p->variable < q->variable;
  return p->exponent > q->exponent;
}

Polynomial to_polynomial(TermMap terms) {
  Polynomial p;
  p.terms.reserve(terms.size());
  while (!terms.empty()) {
    auto node = terms.extract(terms.begin());
    if (is_zero(node.mapped())) continue;
    p.terms.push_back({std::move(node.mapped()), std::move(node.key())});
  }
  return p;
}

Polynomial unknown(std::uint32_t index) { return {{{Coefficient{1, 0}, {{index, 1}}}}}; }

Polynomial constant(const Coefficient& c) {
  if (is_zero(c)) return {};
  return {{{c, {}}}};
}

std::uint64_t degree(const Polynomial& p) {
  return p.terms.empty() ? 0 : degree(p.terms.front().monomial);
}

bool is_real(const Polynomial& p) {
  return std::all_of(p.terms.begin(), p.terms.end(),
                     [](const Term& term) { return is_real(term.coefficient); });
}

bool is_homogeneous(const Polynomial& p) {
  return p.terms.empty() || degree(p.terms.back().monomial) == degree(p);
}

Polynomial operator+(const Polynomial& a, const Polynomial& b) {
  Polynomial sum;
  sum.terms.reserve(a.terms.size() + b.terms.size());
  auto p = a.terms.begin();
  auto q = b.terms.begin();
  while (p != a.terms.end() && q != b.terms.end()) {
    if (precedes(p->monomial, q->monomial)) {
      sum.terms.push_back(*p++);
    } else if (precedes(q->monomial, p->monomial)) {
      sum.terms.push_back(*q++);
    } else {
      Coefficient c = p->coefficient + q->coefficient;
      if (!is_zero(c)) sum.terms.push_back({std::move(c), p->monomial});
      ++p;
      ++q;
    }
  }
  sum.terms.insert(sum.terms.end(), p, a.terms.end());
  sum.terms.insert(sum.terms.end(), q, b.terms.end());
  return sum;
}

Polynomial operator*(const Polynomial& a, const Polynomial& b) {
  TermMap terms;
  for (const Term& s : a.terms) {
    for (const Term& t : b.terms) {
      Coefficient& c = terms[product(s.monomial, t.monomial)];
      c = c + s.coefficient * t.coefficient;
    }
  }
  return to_polynomial(std::move(terms));
}

std::vector<Polynomial> unknowns(std::size_t n) {
  std::vector<Polynomial> x;
  x.reserve(n);
  for (std::size_t j = 0; j < n; ++j) x.push_back(unknown(static_cast<std::uint32_t>(j)));
  return x;
}

Polynomial operator+(const Polynomial& p, const Coefficient& c) { return p + constant(c); }
Polynomial operator+(const Coefficient& c, const Polynomial& p) { return p + constant(c); }
Polynomial operator-(const Polynomial& p) {
  Polynomial negative = p;
  for (Term& term : negative.terms) term.coefficient = -term.coefficient;
  return negative;
}
Polynomial operator-(const Polynomial& a, const Polynomial& b) { return a + -b; }
Polynomial operator-(const Polynomial& p, const Coefficient& c) { return p + constant(-c); }
Polynomial operator-(const Coefficient& c, const Polynomial& p) { return constant(c) + -p; }
Polynomial operator*(const Polynomial& p, const Coefficient& c) { return c * p; }
Polynomial operator/(const Polynomial& p, const Coefficient& c) { return Coefficient(1) / c * p; }
Polynomial& operator+=(Polynomial& a, const Polynomial& b) { return a = a + b; }
Polynomial& operator+=(Polynomial& p, const Coefficient& c) { return p = p + c; }
Polynomial& operator-=(Polynomial& a, const Polynomial& b) { return a = a - b; }
Polynomial& operator-=(Polynomial& p, const Coefficient& c) { return p = p - c; }
Polynomial& operator*=(Polynomial& a, const Polynomial& b) { return a = a * b; }
Polynomial& operator*=(Polynomial& p, const Coefficient& c) { return p = c * p; }
Polynomial& operator/=(Polynomial& p, const Coefficient& c) { return p = p / c; }

Polynomial pow(const Polynomial& p, int exponent) {
  if (exponent < 0) {
    throw InvalidInput("a polynomial has no power " + std::to_string(exponent) +
                       ": exponents are 0 or more");
  }
  Polynomial result = constant(1);
  Polynomial square = p;
  for (int k = exponent; k > 0; k /= 2) {
    if (k % 2 == 1) result = result * square;
    if (k > 1) square = square * square;
  }
  return result;
}

Polynomial operator*(const Coefficient& c, const Polynomial& p) {
  static const Coefficient kOne{1, 0};
  if (is_zero(c)) return {};
  Polynomial multiple = p;
  if (c == kOne) return multiple;
  for (Term& term : multiple.terms) term.coefficient = c * term.coefficient;
  return multiple;
}

std::vector<std::uint64_t> degrees(const System& f) {
  std::vector<std::uint64_t> d;
  d.reserve(f.polynomials.size());
  for (const Polynomial& p : f.polynomials) d.push_back(degree(p));
  return d;
}

std::optional<std::uint64_t> total_degree(const std::vector<std::uint64_t>& degrees) {
  if (std::find(degrees.begin(), degrees.end(), 0U) != degrees.end()) return 0;
  std::uint64_t product = 1;
  for (const std::uint64_t d : degrees) {
    if (product > std::numeric_limits<std::uint64_t>::max() / d) return std::nullopt;
    product *= d;
  }
  return product;
}

bool is_real(const System& f) {
  return std::all_of(f.polynomials.begin(), f.polynomials.end(),
                     [](const Polynomial& p) { return is_real(p); });
}

std::size_t term_count(const System& f) {
  std::size_t count = 0;
  for (const Polynomial& p : f.polynomials) count += p.terms.size();
  return count;
}

}  // namespace moivre
