// SPDX-License-Identifier: MIT
// The arithmetic of expand.h, charged for its memory and time.
// Every step is charged before it can cost more than allowed.
#include "expand.h"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>

#include "moivre/expression/words.h"
#include "moivre/numeric/integer.h"
#include "moivre/polynomial/digits.h"
#include "moivre/polynomial/double_range.h"
#include "number_functions.h"

namespace moivre {

namespace {

/// A limit was passed; what() says which.
struct Excess : std::runtime_error {
  using std::runtime_error::runtime_error;
};

std::size_t bits(const Coefficient& c) { return std::max(bit_length(c.re), bit_length(c.im)); }

}  // namespace

/// Counts the work of a file against kMaximumWork.
class Account {
 public:
  explicit Account(std::uint64_t& work) : work_(work) {}

  /// Reducing a fraction of L limbs takes about L^2 / 4 times a small fraction's time, and a
  /// complex product holds four real ones and two sums, each to be reduced.
  void charge(const Coefficient& c) {
    constexpr std::size_t kLimb = 64;
    constexpr std::uint64_t kComplexWork = 6;
    const std::size_t size = bits(c);
    if (size > kMaximumBits) {
      throw Excess("a coefficient of the expansion has more than " + std::to_string(kMaximumBits) +
                   " bits");
    }
    const std::size_t limbs = size / kLimb;
    charge((is_real(c) ? 1 : kComplexWork) * (1 + limbs * limbs / 4));
  }

  void charge(std::uint64_t work) {
    work_ += work;
    require(0);
  }

  /// Refuses work before it begins; it is charged piece by piece while it is done.
  void require(std::uint64_t work) const {
    if (work_ + work <= kMaximumWork) return;
    throw Excess("the expansion takes more than " + std::to_string(kMaximumWork) +
                 " products of terms (with all before it in this file)");
  }

 private:
  std::uint64_t& work_;
};

namespace {

[[noreturn]] void refuse_term_count() {
  throw Excess("the expansion has more than " + std::to_string(kMaximumTerms) + " terms");
}

void add(TermMap& sum, Monomial monomial, const Coefficient& c, Account& account) {
  account.charge(c);
  const auto [place, is_new] = sum.try_emplace(std::move(monomial), c);
  if (is_new) {
    if (sum.size() > kMaximumTerms) refuse_term_count();
    return;
  }
  place->second = place->second + c;
  account.charge(place->second);
  if (is_zero(place->second)) sum.erase(place);
}

/// Finding the place of a term among many takes as long as this many products of short
/// coefficients.
constexpr std::uint64_t kSearchWork = 3;
/// A copied term stays in memory; charging it like this many products keeps a file below some
/// gigabytes.
constexpr std::uint64_t kCopyWork = 10;

/// A term times a polynomial keeps the order of the terms, so nothing is sorted.
Polynomial product(const Term& factor, Polynomial p, Account& account) {
  for (Term& term : p.terms) {
    term.monomial = product(factor.monomial, term.monomial);
    term.coefficient = factor.coefficient * term.coefficient;
    account.charge(term.coefficient);
  }
  return p;
}

Polynomial product(Polynomial a, Polynomial b, Account& account) {
  if (a.terms.size() == 1) return product(a.terms.front(), std::move(b), account);
  if (b.terms.size() == 1) return product(b.terms.front(), std::move(a), account);
  TermMap terms;
  for (const Term& s : a.terms) {
    account.charge(kSearchWork * b.terms.size());
    for (const Term& t : b.terms) {
      add(terms, product(s.monomial, t.monomial), s.coefficient * t.coefficient, account);
    }
  }
  return to_polynomial(std::move(terms));
}

/// c^k by repeated squaring; refused before it is computed when it would be too long.
Coefficient raised(Coefficient c, std::uint64_t k, Account& account) {
  Coefficient result{1, 0};
  for (; k > 0; k /= 2) {
    if (k % 2 == 1) {
      result = result * c;
      account.charge(result);
    }
    if (k > 1) {
      c = c * c;
      account.charge(c);
    }
  }
  return result;
}

Monomial raised(Monomial m, std::uint64_t k) {
  for (Power& p : m) {
    const std::uint64_t exponent = p.exponent * k;
    if (exponent > std::numeric_limits<std::uint32_t>::max()) {
      throw std::overflow_error("an exponent leaves 32 bits");
    }
    p.exponent = static_cast<std::uint32_t>(exponent);
  }
  return m;
}

/// True when every monomial but at most one holds a variable that no other one holds: then no two
/// products of the terms fall together in any power of p.
bool has_independent_terms(const Polynomial& p) {
  std::unordered_map<std::uint32_t, std::size_t> holders;
  for (const Term& term : p.terms) {
    for (const Power& power : term.monomial) ++holders[power.variable];
  }
  const auto owns_a_variable = [&](const Term& term) {
    return std::any_of(term.monomial.begin(), term.monomial.end(),
                       [&](const Power& power) { return holders[power.variable] == 1; });
  };
  const auto owners = std::count_if(p.terms.begin(), p.terms.end(), owns_a_variable);
  return static_cast<std::size_t>(owners) + 1 >= p.terms.size();
}

/// Monomials of degree k in n letters, C(n+k-1, k), or a number above kMaximumTerms where that is
/// above it.
std::uint64_t monomial_count(std::uint64_t n, std::uint64_t k) {
  std::uint64_t count = 1;
  for (std::uint64_t j = 1; j <= std::min(k, n - 1) && count <= kMaximumTerms; ++j) {
    count = count * (std::max(k, n - 1) + j) / j;
  }
  return count;
}

/// A bound from below on the products of terms that p^k takes, for p of two terms or more: p^j has
/// at least j+1 terms (Hajos: a polynomial with a root of multiplicity j that is not zero has as
/// many).
std::uint64_t least_products(const Polynomial& p, std::uint64_t k) {
  const std::uint64_t sum_of_terms = k * (k - 1) / 2;  // k has 32 bits
  return std::min(sum_of_terms, kMaximumWork + 1) * p.terms.size();
}

/// p^k, multiplied by p again and again: for sparse p that costs less than squaring.
Polynomial raised(const Polynomial& p, std::uint64_t k, Account& account) {
  if (k == 0) return constant({1, 0});
  if (p.terms.empty()) return p;
  if (p.terms.size() == 1) {
    const Term& term = p.terms.front();
    return {{{raised(term.coefficient, k, account), raised(term.monomial, k)}}};
  }
  if (has_independent_terms(p) && monomial_count(p.terms.size(), k) > kMaximumTerms) {
    refuse_term_count();
  }
  account.require(least_products(p, k));
  Polynomial result = p;
  for (std::uint64_t j = 1; j < k; ++j) result = product(p, std::move(result), account);
  return result;
}

bool is_constant(const Polynomial& p) {
  return p.terms.empty() || (p.terms.size() == 1 && p.terms.front().monomial.empty());
}

Coefficient constant_of(const Polynomial& p) {
  return p.terms.empty() ? Coefficient{} : p.terms.front().coefficient;
}

constexpr std::int64_t kMaximumExponent = std::numeric_limits<std::uint32_t>::max();

std::string quoted(const Integer& n) {
  constexpr std::size_t kQuotedBits = 200;
  return bit_length(n) > kQuotedBits ? std::string() : ' ' + n.str();
}

std::string not_held() { return std::string("multiplied out, ") + kBeyondDouble; }

}  // namespace

template <class Operation>
Expander::Value Expander::within_limits(const SourcePosition& at, Operation operation) {
  const bool exhausted = work_ > kMaximumWork;
  try {
    Account account(work_);
    return operation(account);
  } catch (const Excess& excess) {
    if (exhausted) return std::nullopt;  // said already, where it happened
    return refuse(at, excess.what());
  } catch (const std::overflow_error&) {
    return refuse(at, "an exponent is beyond " + std::to_string(kMaximumExponent));
  }
}

Expander::Value Expander::refuse(const SourcePosition& at, const std::string& message) {
  faults_.push_back({at, message});
  return std::nullopt;
}

std::optional<Polynomial> Expander::expand(std::string_view text, const SourcePosition& begin,
                                           const Environment& names) {
  const std::size_t faults_before = faults_.size();
  Sum sum;
  parse_summands(text, begin, faults_, [&](const Expression& summand) {
    sum.is_sound = faults_.size() == faults_before;
    add_summand(summand, names, sum);
  });
  if (faults_.size() > faults_before) return std::nullopt;
  return to_polynomial(std::move(sum.terms));
}

void Expander::add_summand(const Expression& summand, const Environment& names, Sum& sum) {
  Value addend = value(summand, names);
  if (!addend) sum.is_sound = false;
  if (!sum.is_sound) return;
  const Value added = within_limits(summand.at, [&](Account& account) {
    for (Term& term : addend->terms) {
      add(sum.terms, std::move(term.monomial), term.coefficient, account);
    }
    return Polynomial{};
  });
  sum.is_sound = added.has_value();
}

Expander::Value Expander::value(const Expression& e, const Environment& names) {
  switch (e.kind) {
    case Expression::Kind::number:
      has_rounded_number_ = has_rounded_number_ || is_rounded(e.number);
      return constant({e.number, 0});
    case Expression::Kind::name:
      return named(e, names);
    case Expression::Kind::sum:
      return sum_of(e, names);
    case Expression::Kind::product:
      return product_of(e, names);
    case Expression::Kind::negate: {
      const Value operand = value(e.operands.front(), names);
      if (!operand) return std::nullopt;
      return Coefficient{-1, 0} * *operand;
    }
    case Expression::Kind::reciprocal:
      return reciprocal(e, names);
    case Expression::Kind::power:
      return power(e, names);
    case Expression::Kind::call:
      break;
  }
  if (names.count(e.name) > 0) {
    return refuse(e.at, "`" + e.name + "(`: an operator is missing behind `" + e.name +
                            "` (a product is written with `*`)");
  }
  return function_of_number(e, names);
}

Expander::Value Expander::rounded_number(const std::optional<Rational>& number,
                                         const SourcePosition& at, const std::string& what) {
  if (!number) return refuse(at, what + " has no real value here that can be computed");
  has_rounded_number_ = has_rounded_number_ || is_rounded(*number);
  return constant(*number);
}

Expander::Value Expander::function_of_number(const Expression& e, const Environment& names) {
  const auto function = number_function(e.name);
  if (!function || e.operands.size() != 1) {
    return refuse(e.at, "`" + e.name + "(`: function calls are not polynomials");
  }
  const Value operand = value(e.operands.front(), names);
  if (!operand) return std::nullopt;
  if (!is_constant(*operand) || !is_real(constant_of(*operand))) {
    return refuse(
        e.at, "`" + e.name + "(` of an unknown is no polynomial; of a real number it is a number");
  }
  return rounded_number(function(constant_of(*operand).re), e.at, "`" + e.name + "(`");
}

Expander::Value Expander::root_of_number(const Coefficient& base, const Rational& exponent,
                                         const SourcePosition& at) {
  if (!is_real(base)) return refuse(at, "a root of a number that is not real has many values");
  return rounded_number(number_power(base.re, exponent), at, "this root");
}

Expander::Value Expander::named(const Expression& e, const Environment& names) {
  const auto meaning = names.find(e.name);
  if (meaning == names.end()) return refuse(e.at, "the name `" + e.name + "` is not declared");
  if (!meaning->second) return std::nullopt;
  return within_limits(e.at, [&](Account& account) {
    const std::size_t terms = meaning->second->terms.size();
    account.charge(terms > 1 ? kCopyWork * terms : 1);
    return *meaning->second;
  });
}

Expander::Value Expander::sum_of(const Expression& e, const Environment& names) {
  Sum sum;
  for (const Expression& operand : e.operands) add_summand(operand, names, sum);
  if (!sum.is_sound) return std::nullopt;
  return to_polynomial(std::move(sum.terms));
}

Expander::Value Expander::product_of(const Expression& e, const Environment& names) {
  Value result = value(e.operands.front(), names);
  for (std::size_t k = 1; k < e.operands.size(); ++k) {
    Value factor = value(e.operands[k], names);
    if (!result || !factor) {
      result.reset();
      continue;
    }
    result = within_limits(e.operands[k].at, [&](Account& account) {
      return product(std::move(*result), std::move(*factor), account);
    });
  }
  return result;
}

Expander::Value Expander::reciprocal(const Expression& e, const Environment& names) {
  const Value operand = value(e.operands.front(), names);
  if (!operand) return std::nullopt;
  return reciprocal_of(*operand, e.at);
}

/// p = N / M, where M has all that p divides by: 1 / p = M / N.
Expander::Value Expander::reciprocal_of(const Polynomial& p, const SourcePosition& at) {
  return within_limits(at, [&](Account& account) -> Polynomial {
    Polynomial factor = constant(1);
    Polynomial whole = without_reciprocals(p, factor, account);
    if (whole.terms.empty()) throw Excess("division by zero");
    const Coefficient leading = Coefficient(1) / whole.terms.front().coefficient;
    if (is_constant(whole)) return leading * factor;
    whole = leading * whole;
    const auto known = std::find(denominators_.begin(), denominators_.end(), whole);
    const auto k = static_cast<std::uint32_t>(known - denominators_.begin());
    if (known == denominators_.end()) {
      if (!log2_into_double(whole)) throw Excess(not_held());
      denominators_.push_back(std::move(whole));
    }
    return product(leading * unknown(kFirstReciprocal + k), std::move(factor), account);
  });
}

/// p times `factor`, which is multiplied by the least powers of denominators that it takes.
Polynomial Expander::without_reciprocals(const Polynomial& p, Polynomial& factor,
                                         Account& account) const {
  Polynomial whole = p;
  for (std::size_t k = 0; k < denominators_.size(); ++k) {
    const auto reciprocal = kFirstReciprocal + static_cast<std::uint32_t>(k);
    const auto exponent_in = [&](const Monomial& m) -> std::uint32_t {
      for (const Power& power : m) {
        if (power.variable == reciprocal) return power.exponent;
      }
      return 0;
    };
    std::uint32_t most = 0;
    for (const Term& term : whole.terms) most = std::max(most, exponent_in(term.monomial));
    if (most == 0) continue;
    // Terms by how often they divide: each is multiplied by what is left of the highest power.
    std::vector<Polynomial> by_power(most + std::size_t{1});
    for (Term& term : whole.terms) {
      const std::uint32_t exponent = exponent_in(term.monomial);
      std::erase_if(term.monomial, [&](const Power& one) { return one.variable == reciprocal; });
      TermMap one;
      one.emplace(std::move(term.monomial), std::move(term.coefficient));
      by_power[exponent] = by_power[exponent] + to_polynomial(std::move(one));
    }
    whole = {};
    for (std::uint32_t j = 0; j <= most; ++j) {
      whole = whole + product(by_power[j], raised(denominators_[k], most - j, account), account);
    }
    factor = product(std::move(factor), raised(denominators_[k], most, account), account);
  }
  return whole;
}

std::optional<Polynomial> Expander::cleared(const Polynomial& p, const SourcePosition& at) {
  if (denominators_.empty()) return p;
  return within_limits(at, [&](Account& account) {
    Polynomial factor = constant(1);
    return without_reciprocals(p, factor, account);
  });
}

bool Expander::add_equation(const Polynomial& p, const SourcePosition& at, System& system) {
  std::optional<Polynomial> whole = cleared(p, at);
  if (!whole) return false;
  const bool is_held = moivre::add_equation(std::move(*whole), system);
  if (!is_held) refuse(at, not_held());
  return is_held;
}

std::vector<Polynomial> Expander::denominators() const {
  std::vector<Polynomial> held;
  for (const Polynomial& p : denominators_) {
    held.push_back(times_power_of_two(p, *log2_into_double(p)));
  }
  return held;
}

std::optional<Polynomial> Expander::expand_equation(std::string_view text,
                                                    const SourcePosition& begin,
                                                    const Environment& names) {
  const EqualsSign sign = equals_sign(text);
  if (sign.length == 0) return expand(text, begin, names);
  const std::string_view left_side = text.substr(0, sign.at);
  const std::string_view right_side = text.substr(sign.at + sign.length);
  const SourcePosition at = after(begin, left_side);
  const SourcePosition behind = after(at, text.substr(sign.at, sign.length));
  if (const EqualsSign second = equals_sign(right_side); second.length > 0) {
    const std::string_view between = right_side.substr(0, second.at);
    expand(left_side, begin, names);
    if (!trimmed(between).empty()) expand(between, behind, names);
    return refuse(after(behind, between), "a second `=`; an equation has one");
  }
  if (trimmed(left_side).empty() || trimmed(right_side).empty()) {
    return refuse(at, "a side of this `=` is missing");
  }
  const Value left = expand(left_side, begin, names);
  const Value right = expand(right_side, behind, names);
  if (!left || !right) return std::nullopt;
  return *left - *right;
}

std::optional<Rational> Expander::exponent(const Expression& e, const Environment& names) {
  const Value exact = value(e, names);
  if (!exact) return std::nullopt;
  if (!is_constant(*exact) || !is_real(constant_of(*exact))) {
    refuse(e.at,
           is_constant(*exact) ? "the exponent is not an integer" : "the exponent is not a number");
    return std::nullopt;
  }
  Rational k = constant_of(*exact).re;
  if (abs(k) > Rational(kMaximumExponent)) {
    refuse(e.at, "the exponent" + (denominator(k) == 1 ? quoted(numerator(k)) : "") +
                     " is beyond " + std::to_string(kMaximumExponent));
    return std::nullopt;
  }
  return k;
}

Expander::Value Expander::power(const Expression& e, const Environment& names) {
  Value base = value(e.operands[0], names);
  const std::optional<Rational> k = exponent(e.operands[1], names);
  if (!base || !k) return std::nullopt;
  if (denominator(*k) != 1) {
    if (!is_constant(*base)) return refuse(e.operands[1].at, "the exponent is not an integer");
    return root_of_number(constant_of(*base), *k, e.operands[1].at);
  }
  if (*k < 0) base = reciprocal_of(*base, e.at);
  if (!base) return std::nullopt;
  return within_limits(e.operands[1].at, [&](Account& account) {
    return raised(*base, static_cast<std::uint64_t>(numerator(abs(*k))), account);
  });
}

}  // namespace moivre
