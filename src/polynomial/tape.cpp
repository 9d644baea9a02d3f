// SPDX-License-Identifier: MIT
// Compiles a system into a tape: which products to form once, and which sums to take over them.
#include "moivre/polynomial/tape.h"

#include <limits>
#include <map>

#include "moivre/numeric/invalid_input.h"

namespace moivre {
namespace {

/// m with one power of `variable` less.
Monomial lowered(const Monomial& m, std::size_t position) {
  Monomial result = m;
  if (--result[position].exponent == 0) {
    result.erase(result.begin() + static_cast<std::ptrdiff_t>(position));
  }
  return result;
}

/// Registers of monomials; a monomial is multiplied out once, from parts that are shared in their
/// turn.
class Products {
 public:
  explicit Products(Tape& tape) : tape_(tape) {}

  std::uint32_t register_of(const Monomial& m) {
    if (m.empty()) return tape_.variables;
    if (m.size() == 1 && m.front().exponent == 1) return m.front().variable;
    if (const auto known = registers_.find(m); known != registers_.end()) return known->second;
    const auto [left, right] = split(m);
    const std::uint32_t a = register_of(left);
    const std::uint32_t b = register_of(right);
    const std::size_t next = tape_.register_count();
    if (next >= std::numeric_limits<std::uint32_t>::max()) {
      throw InvalidInput("the system needs more than 2^32 products");
    }
    tape_.products.push_back({a, b});
    return registers_[m] = static_cast<std::uint32_t>(next);
  }

 private:
  bool is_known(const Monomial& m) const {
    return m.empty() || (m.size() == 1 && m.front().exponent == 1) || registers_.contains(m);
  }

  /// Two factors of m, one of them known already where that is possible.
  std::pair<Monomial, Monomial> split(const Monomial& m) const {
    for (std::size_t k = 0; k < m.size(); ++k) {
      if (Monomial rest = lowered(m, k); is_known(rest)) {
        return {std::move(rest), Monomial{{m[k].variable, 1}}};
      }
    }
    if (m.size() == 1) return split_power(m.front());
    const auto middle = m.begin() + static_cast<std::ptrdiff_t>(m.size() / 2);
    return {Monomial(m.begin(), middle), Monomial(middle, m.end())};
  }

  static std::pair<Monomial, Monomial> split_power(Power p) {
    const std::uint32_t half = p.exponent / 2;
    return {Monomial{{p.variable, p.exponent - half}}, Monomial{{p.variable, half}}};
  }

  Tape& tape_;
  std::map<Monomial, std::uint32_t> registers_;
};

class Compiler {
 public:
  explicit Compiler(const System& f) : f_(f), products_(tape_) {
    tape_.variables = static_cast<std::uint32_t>(f.variables.size());
    tape_.equations = static_cast<std::uint32_t>(f.polynomials.size());
  }

  Tape compile() {
    compile_values();
    compile_jacobian();
    return std::move(tape_);
  }

 private:
  std::uint32_t coefficient(std::uint32_t equation, std::size_t term, std::uint32_t factor) {
    tape_.coefficients.push_back({equation, static_cast<std::uint32_t>(term), factor});
    return static_cast<std::uint32_t>(tape_.coefficients.size() - 1);
  }

  void compile_values() {
    tape_.value_begin.push_back(0);
    for (std::uint32_t i = 0; i < tape_.equations; ++i) {
      const auto& terms = f_.polynomials[i].terms;
      for (std::size_t k = 0; k < terms.size(); ++k) {
        tape_.value_summands.push_back(
            {coefficient(i, k, 1), products_.register_of(terms[k].monomial)});
      }
      tape_.value_begin.push_back(static_cast<std::uint32_t>(tape_.value_summands.size()));
    }
    tape_.value_products = static_cast<std::uint32_t>(tape_.products.size());
  }

  void compile_jacobian() {
    std::uint32_t offset = 0;
    for (std::uint32_t i = 0; i < tape_.equations; ++i) {
      const auto& terms = f_.polynomials[i].terms;
      std::map<std::uint32_t, std::vector<Tape::Summand>> row;
      for (std::size_t k = 0; k < terms.size(); ++k) {
        const Monomial& m = terms[k].monomial;
        for (std::size_t p = 0; p < m.size(); ++p) {
          // The value's own coefficient serves where the exponent is 1.
          const std::uint32_t c = m[p].exponent == 1 ? offset + static_cast<std::uint32_t>(k)
                                                     : coefficient(i, k, m[p].exponent);
          row[m[p].variable].push_back({c, products_.register_of(lowered(m, p))});
        }
      }
      offset += static_cast<std::uint32_t>(terms.size());
      for (const auto& [column, summands] : row) {
        const auto begin = static_cast<std::uint32_t>(tape_.jacobian_summands.size());
        tape_.jacobian_summands.insert(tape_.jacobian_summands.end(), summands.begin(),
                                       summands.end());
        tape_.jacobian.push_back(
            {i, column, begin, static_cast<std::uint32_t>(tape_.jacobian_summands.size())});
      }
    }
  }

  const System& f_;
  Tape tape_;
  Products products_;
};

}  // namespace

Tape make_tape(const System& f) { return Compiler(f).compile(); }

std::vector<Complex> complex_coefficients(const Tape& tape, const System& f) {
  return round_coefficients<Complex>(tape, f, [](const Coefficient& c) { return to_complex(c); });
}

std::vector<double> real_coefficients(const Tape& tape, const System& f) {
  if (!is_real(f)) throw InvalidInput("real coefficients of a system that is not real");
  return round_coefficients<double>(tape, f, [](const Coefficient& c) { return to_double(c.re); });
}

}  // namespace moivre
