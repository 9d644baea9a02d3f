// SPDX-License-Identifier: MIT
// The linear-product start: its random factors, how many terms it has, and G multiplied out.
#include "moivre/start/linear_product.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "exact_coefficient.h"
#include "moivre/numeric/invalid_input.h"
#include "moivre/numeric/random.h"
#include "moivre/numeric/saturating.h"
#include "moivre/start/total_degree.h"

namespace moivre {
namespace {

/// Of so many random candidates the one farthest from all that there are is taken.
constexpr int kCandidates = 16;

/// Random numbers one after another, all from the seed.
class Draw {
 public:
  explicit Draw(std::uint64_t seed) : seed_(seed) {}

  double unit() { return random_unit(seed_, RandomStream::linear_product, next_++); }
  Complex phase() { return std::polar(1.0, 2 * std::numbers::pi * unit()); }
  /// Complex normal, E|z|^2 = 1.
  Complex normal() { return std::sqrt(-std::log(1 - unit())) * phase(); }

 private:
  std::uint64_t seed_;
  std::uint64_t next_ = 0;
};

double shortened(double a) {
  return std::ldexp(std::nearbyint(std::ldexp(a, kConstantBits)), -kConstantBits);
}
Complex shortened(Complex a) { return {shortened(a.real()), shortened(a.imag())}; }

std::vector<Complex> roots_of(const Point& form, std::uint64_t d) {
  std::vector<Complex> roots;
  for (std::uint64_t k = 0; k < d; ++k) roots.push_back(de_moivre_root(-form[1] / form[0], d, k));
  return roots;
}

/// c1 x^d - c2 as (c1, -c2), its roots well away from those taken, which they join. They lie in a
/// ring around the unit circle, since many roots on the circle itself would crowd.
Point binomial(Draw& draw, std::uint64_t d, std::vector<Complex>& taken) {
  Point best;
  double widest = -1;
  for (int candidate = 0; candidate < kCandidates; ++candidate) {
    const double size = std::exp2(2 * draw.unit() - 1);  // roots' sizes: 2^(-1/d) to 2^(1/d)
    const Complex c1 = draw.phase();
    const Point form{shortened(c1), shortened(-size * draw.phase())};
    double gap = std::numeric_limits<double>::infinity();
    for (const Complex& root : roots_of(form, d)) {
      for (const Complex& other : taken) gap = std::min(gap, std::abs(root - other));
    }
    if (gap > widest) {
      widest = gap;
      best = form;
    }
    if (taken.empty()) break;
  }
  for (const Complex& root : roots_of(best, d)) taken.push_back(root);
  return best;
}

/// The linear part has length 1: |a^H a'| is the cosine of the angle between two factors.
double cosine(const Point& a, const Point& b) {
  Complex sum = 0;
  for (std::size_t l = 0; l + 1 < a.size(); ++l) sum += conjugate_product(a[l], b[l]);
  return std::abs(sum);
}

/// a . x + b in `size` unknowns, |a| = |b| = 1, not nearly parallel to any of those taken, which it
/// joins.
Point linear_form(Draw& draw, std::size_t size, std::vector<Point>& taken) {
  Point best;
  double least = std::numeric_limits<double>::infinity();
  for (int candidate = 0; candidate < kCandidates; ++candidate) {
    Point form;
    for (std::size_t l = 0; l < size; ++l) form.push_back(draw.normal());
    const double length = euclidean_norm(form);
    for (Complex& a : form) a /= length;
    form.push_back(draw.phase());
    double nearest = 0;
    for (const Point& other : taken) nearest = std::max(nearest, cosine(form, other));
    if (nearest < least) {
      least = nearest;
      best = std::move(form);
    }
    if (taken.empty()) break;
  }
  for (Complex& a : best) a = shortened(a);
  taken.push_back(best);
  return best;
}

void check(const GroupDegrees& degrees) {
  for (std::size_t i = 0; i < degrees.size(); ++i) {
    if (std::all_of(degrees[i].begin(), degrees[i].end(), [](auto d) { return d == 0; })) {
      throw InvalidInput("equation " + std::to_string(i + 1) + " is a constant");
    }
  }
}

/// C(n + d, d), saturating: monomials of degree d or less in n unknowns.
std::uint64_t dense_terms(std::uint64_t n, std::uint64_t d) {
  std::uint64_t count = 1;
  for (std::uint64_t k = 1; k <= std::min(n, d); ++k) {
    // Products of k neighbours: k divides exactly, and the quotient is the smaller binomial.
    const std::uint64_t next = saturating_product(count, std::max(n, d) + k);
    if (is_saturated(next)) return next;
    count = next / k;
  }
  return count;
}

Polynomial linear_polynomial(const Point& form, const std::vector<std::uint32_t>& group) {
  TermMap terms;
  for (std::size_t l = 0; l < group.size(); ++l)
    terms[{{group[l], 1}}] = exact_coefficient(form[l]);
  terms[{}] = exact_coefficient(form.back());
  return to_polynomial(std::move(terms));
}

Polynomial expanded(const GroupFactor& factor, std::uint64_t d,
                    const std::vector<std::uint32_t>& group) {
  if (group.size() == 1 && d > 0) {
    TermMap terms;
    terms[{{group[0], static_cast<std::uint32_t>(d)}}] = exact_coefficient(factor.forms[0][0]);
    terms[{}] = exact_coefficient(factor.forms[0][1]);
    return to_polynomial(std::move(terms));
  }
  Polynomial product = constant({1, 0});
  for (const Point& form : factor.forms) product = product * linear_polynomial(form, group);
  return product;
}

}  // namespace

LinearProductStart linear_product_start(const GroupDegrees& degrees, const Partition& groups,
                                        std::uint64_t seed) {
  check(degrees);
  auto completions = completion_table(degrees, groups);
  if (!completions || is_saturated(completions->back())) {
    throw std::overflow_error(
        "the Bezout number by groups does not fit into 64 bits, or its table is too large");
  }
  LinearProductStart start{groups, degrees, {}, {}, completions->back()};
  start.completions = std::move(*completions);
  start.factors.assign(degrees.size(), std::vector<GroupFactor>(groups.size()));
  Draw draw(seed);
  for (std::size_t j = 0; j < groups.size(); ++j) {
    std::vector<Complex> roots;
    std::vector<Point> forms;
    for (std::size_t i = 0; i < degrees.size(); ++i) {
      GroupFactor& factor = start.factors[i][j];
      const std::uint64_t d = degrees[i][j];
      if (groups[j].size() == 1) {
        if (d > 0) factor.forms.push_back(binomial(draw, d, roots));
        continue;
      }
      for (std::uint64_t k = 0; k < d; ++k) {
        factor.forms.push_back(linear_form(draw, groups[j].size(), forms));
      }
    }
  }
  return start;
}

LinearProductStart linear_product_start(const System& f, const Partition& groups,
                                        std::uint64_t seed) {
  return linear_product_start(group_degrees(f, groups), groups, seed);
}

std::uint64_t linear_product_terms(const GroupDegrees& degrees, const Partition& groups) {
  std::uint64_t sum = 0;
  for (const auto& row : degrees) {
    std::uint64_t terms = 1;
    for (std::size_t j = 0; j < groups.size(); ++j) {
      const bool is_binomial = groups[j].size() == 1 && row[j] > 0;
      terms = saturating_product(terms, is_binomial ? 2 : dense_terms(groups[j].size(), row[j]));
    }
    sum = saturating_sum(sum, terms);
  }
  return sum;
}

std::optional<System> start_system(const LinearProductStart& start,
                                   const std::vector<std::string>& variables) {
  if (linear_product_terms(start.degrees, start.groups) > kMaximumStartTerms) return std::nullopt;
  System g;
  g.variables = variables;
  for (std::size_t i = 0; i < start.factors.size(); ++i) {
    Polynomial product = constant({1, 0});
    for (std::size_t j = 0; j < start.groups.size(); ++j) {
      product = product * expanded(start.factors[i][j], start.degrees[i][j], start.groups[j]);
    }
    g.polynomials.push_back(std::move(product));
  }
  return g;
}

}  // namespace moivre
