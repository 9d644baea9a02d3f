// SPDX-License-Identifier: MIT
// How is the program of a homotopy made in one real type? Terms are sorted into those that stand
// still and those that move, and the sums over them are written out.
//
// The definition of make_program() (homotopy/program.h), for those who instantiate it in a real
// type of their own:
// RealScalar<Real> has to round to it (numeric/scalar.h).
#pragma once

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "moivre/homotopy/program.h"
#include "moivre/numeric/scalar.h"

namespace moivre {
namespace detail {

/// On which side a term stands still; it moves where it has none.
enum class Side { f, g, both };

template <class Real>
class ProgramWriter {
 public:
  explicit ProgramWriter(const Homotopy& homotopy) : homotopy_(homotopy), tape_(homotopy.tape()) {}

  HomotopyProgram<Real> write() {
    program_.law = homotopy_.law();
    program_.is_framed = homotopy_.is_framed();
    program_.variables = tape_.variables;
    program_.register_count = static_cast<std::uint32_t>(tape_.register_count());
    program_.products = tape_.products;
    program_.value_products = tape_.value_products;
    list_moving();
    for (std::uint32_t i = 0; i < tape_.equations; ++i) {
      program_.values.push_back(
          blend(parts(tape_.value_summands, tape_.value_begin[i], tape_.value_begin[i + 1])));
    }
    write_jacobian();
    return std::move(program_);
  }

 private:
  using Program = HomotopyProgram<Real>;

  struct Rounded {
    Real re, im;
  };
  static Rounded round(const Coefficient& c) {
    return {RealScalar<Real>::round(c.re), RealScalar<Real>::round(c.im)};
  }

  std::size_t term_of(const Tape::Origin& origin) const {
    return homotopy_.first_term(origin.equation) + origin.term;
  }

  Side side_of(std::size_t term) const {
    if (homotopy_.law() != CoefficientLaw::straight || homotopy_.is_framed()) return Side::both;
    if (is_zero(homotopy_.g(term))) return Side::f;
    return is_zero(homotopy_.f(term)) ? Side::g : Side::both;
  }

  void list_moving() {
    for (std::uint32_t k = 0; k < homotopy_.terms(); ++k) {
      if (side_of(k) != Side::both) continue;
      const Rounded f = round(homotopy_.f(k));
      const Rounded g = round(homotopy_.g(k));
      places_[{k, 1}] = static_cast<std::uint32_t>(program_.moving.size());
      program_.moving.push_back({k, f.re, f.im, g.re, g.im});
    }
  }

  /// Place of factor times the moving coefficient of a term.
  std::uint32_t moving_place(std::uint32_t term, std::uint32_t factor) {
    const auto next = static_cast<std::uint32_t>(program_.moving_count());
    const auto [found, is_new] = places_.try_emplace({term, factor}, next);
    if (is_new) {
      program_.multiples.push_back({places_.at({term, 1}), static_cast<double>(factor)});
    }
    return found->second;
  }

  /// A sum's summands by where they stand still, and those that move.
  struct Parts {
    std::vector<Tape::Summand> f, g, moving;

    auto counts() const { return std::make_tuple(f.size(), g.size(), moving.size()); }
  };

  Parts parts(const std::vector<Tape::Summand>& summands, std::uint32_t begin,
              std::uint32_t end) const {
    Parts result;
    for (std::uint32_t k = begin; k < end; ++k) {
      switch (side_of(term_of(tape_.coefficients[summands[k].coefficient]))) {
        case Side::f:
          result.f.push_back(summands[k]);
          break;
        case Side::g:
          result.g.push_back(summands[k]);
          break;
        case Side::both:
          result.moving.push_back(summands[k]);
          break;
      }
    }
    return result;
  }

  Rounded coefficient_of(const Tape::Summand& summand) const {
    const Tape::Origin& origin = tape_.coefficients[summand.coefficient];
    const std::size_t term = term_of(origin);
    const Coefficient& c = side_of(term) == Side::f ? homotopy_.f(term) : homotopy_.g(term);
    const Rational factor(origin.factor);
    return round(origin.factor == 1 ? c : Coefficient{c.re * factor, c.im * factor});
  }

  typename Program::Sum sum(const std::vector<Tape::Summand>& summands) {
    typename Program::Sum result;
    result.real_begin = static_cast<std::uint32_t>(program_.real_terms.size());
    result.complex_begin = static_cast<std::uint32_t>(program_.complex_terms.size());
    for (const Tape::Summand& summand : summands) {
      const Rounded c = coefficient_of(summand);
      if (c.im == Real(0.0)) {
        program_.real_terms.push_back({c.re, summand.monomial});
      } else {
        program_.complex_terms.push_back({c.re, c.im, summand.monomial});
      }
    }
    result.real_end = static_cast<std::uint32_t>(program_.real_terms.size());
    result.complex_end = static_cast<std::uint32_t>(program_.complex_terms.size());
    return result;
  }

  typename Program::Blend blend(const Parts& parts) {
    typename Program::Blend result;
    result.f = sum(parts.f);
    result.g = sum(parts.g);
    result.moving_begin = static_cast<std::uint32_t>(program_.moving_terms.size());
    for (const Tape::Summand& summand : parts.moving) {
      const Tape::Origin& origin = tape_.coefficients[summand.coefficient];
      const auto term = static_cast<std::uint32_t>(term_of(origin));
      program_.moving_terms.push_back({moving_place(term, origin.factor), summand.monomial});
    }
    result.moving_end = static_cast<std::uint32_t>(program_.moving_terms.size());
    return result;
  }

  struct Entry {
    std::uint32_t row, column;
    Parts parts;
  };

  std::vector<Entry> entries() {
    std::vector<Entry> all;
    std::uint32_t next = 0;  // position in the matrix, row by row
    for (const Tape::Entry& entry : tape_.jacobian) {
      add_zeros(next, entry.row * tape_.variables + entry.column);
      next = entry.row * tape_.variables + entry.column + 1;
      all.push_back(
          {entry.row, entry.column, parts(tape_.jacobian_summands, entry.begin, entry.end)});
    }
    add_zeros(next, tape_.equations * tape_.variables);
    // Branches of the interpreter are foreseen where its loops have one length for long.
    std::stable_sort(all.begin(), all.end(), [](const Entry& a, const Entry& b) {
      return a.parts.counts() < b.parts.counts();
    });
    return all;
  }

  void add_zeros(std::uint32_t begin, std::uint32_t end) {
    for (std::uint32_t k = begin; k < end; ++k) {
      program_.zeros.push_back({k / tape_.variables, k % tape_.variables});
    }
  }

  void write_jacobian() {
    std::vector<Entry> all = entries();
    const auto by_t = registers_of(all, &Parts::f, 0);
    const auto by_rest = registers_of(all, &Parts::g, static_cast<std::uint32_t>(by_t.size()));
    // Products by t and 1 - t are taken of registers or of entries, whichever are fewer.
    if (!by_t.empty() && by_t.size() + by_rest.size() < all.size()) {
      for (const auto& [monomial, place] : by_t) program_.by_t.push_back(monomial);
      for (const auto& [monomial, place] : by_rest) program_.by_rest.push_back(monomial);
      for (Entry& entry : all) {
        for (Tape::Summand& summand : entry.parts.f) summand.monomial = by_t.at(summand.monomial);
        for (Tape::Summand& summand : entry.parts.g) {
          summand.monomial = by_rest.at(summand.monomial);
          entry.parts.f.push_back(summand);
        }
        entry.parts.g.clear();
      }
    }
    for (const Entry& entry : all) {
      program_.jacobian.push_back({entry.row, entry.column, blend(entry.parts)});
    }
  }

  /// The registers that entries read on one side, each with its place among the weighted registers
  /// from `first` on.
  static std::map<std::uint32_t, std::uint32_t> registers_of(
      const std::vector<Entry>& all, std::vector<Tape::Summand> Parts::*side, std::uint32_t first) {
    std::map<std::uint32_t, std::uint32_t> places;
    for (const Entry& entry : all) {
      for (const Tape::Summand& summand : entry.parts.*side) places[summand.monomial] = 0;
    }
    for (auto& [monomial, place] : places) place = first++;
    return places;
  }

  const Homotopy& homotopy_;
  const Tape& tape_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> places_;  // of (term, factor)
  Program program_;
};

}  // namespace detail

template <class Real>
HomotopyProgram<Real> make_program(const Homotopy& homotopy) {
  return detail::ProgramWriter<Real>(homotopy).write();
}

}  // namespace moivre
