// SPDX-License-Identifier: MIT
// Compiles F and G into one tape and writes it out for the lane interpreter.
#include "lane_program.h"

#include <algorithm>
#include <map>
#include <utility>

namespace moivre {
namespace {

template <class Real>
struct Rounded {
  Real re, im;
};

System both_sides(const Homotopy& homotopy) {
  System both = homotopy.target().system;
  const auto& start = homotopy.start().system.polynomials;
  both.polynomials.insert(both.polynomials.end(), start.begin(), start.end());
  return both;
}

Rounded<double> round(const Coefficient& c, double) { return {to_double(c.re), to_double(c.im)}; }
Rounded<DoubleDouble> round(const Coefficient& c, DoubleDouble) {
  return {to_double_double(c.re), to_double_double(c.im)};
}
bool is_zero(double a) { return a == 0; }
bool is_zero(const DoubleDouble& a) { return a.hi == 0; }

template <class Real>
class Writer {
 public:
  explicit Writer(const Homotopy& homotopy)
      : n_(static_cast<std::uint32_t>(homotopy.equations())),
        system_(both_sides(homotopy)),
        tape_(make_tape(system_)),
        c_(round_coefficients<Rounded<Real>>(
            tape_, system_, [](const Coefficient& c) { return round(c, Real()); })) {}

  LaneProgram<Real> write() {
    program_.variables = tape_.variables;
    program_.register_count = static_cast<std::uint32_t>(tape_.register_count());
    program_.products = tape_.products;
    program_.value_products = tape_.value_products;
    for (std::uint32_t i = 0; i < n_; ++i) {
      program_.values.push_back({value_sum(i), value_sum(i + n_)});
    }
    write_jacobian();
    return std::move(program_);
  }

 private:
  using Sum = typename LaneProgram<Real>::Sum;

  Sum sum(const std::vector<Tape::Summand>& summands, std::uint32_t begin, std::uint32_t end) {
    Sum result;
    result.real_begin = static_cast<std::uint32_t>(program_.real_terms.size());
    result.complex_begin = static_cast<std::uint32_t>(program_.complex_terms.size());
    for (std::uint32_t k = begin; k < end; ++k) {
      const Rounded<Real>& c = c_[summands[k].coefficient];
      if (is_zero(c.im)) {
        program_.real_terms.push_back({c.re, summands[k].monomial});
      } else {
        program_.complex_terms.push_back({c.re, c.im, summands[k].monomial});
      }
    }
    result.real_end = static_cast<std::uint32_t>(program_.real_terms.size());
    result.complex_end = static_cast<std::uint32_t>(program_.complex_terms.size());
    return result;
  }

  Sum value_sum(std::uint32_t i) {
    return sum(tape_.value_summands, tape_.value_begin[i], tape_.value_begin[i + 1]);
  }

  /// The summands of an entry of H_x on F's and on G's side; nullptr: none.
  struct Sides {
    std::uint32_t row, column;
    const Tape::Entry* f = nullptr;
    const Tape::Entry* g = nullptr;

    auto term_counts() const {
      const auto count = [](const Tape::Entry* e) { return e == nullptr ? 0 : e->end - e->begin; };
      return std::make_pair(count(f), count(g));
    }
  };

  std::vector<Sides> entries() {
    std::map<std::pair<std::uint32_t, std::uint32_t>, Sides> found;
    for (const Tape::Entry& entry : tape_.jacobian) {
      const bool is_target = entry.row < n_;
      const std::uint32_t row = is_target ? entry.row : entry.row - n_;
      Sides& sides = found.try_emplace({row, entry.column}, Sides{row, entry.column}).first->second;
      (is_target ? sides.f : sides.g) = &entry;
    }
    std::vector<Sides> all;
    for (std::uint32_t i = 0; i < n_; ++i) {
      for (std::uint32_t j = 0; j < tape_.variables; ++j) {
        const auto sides = found.find({i, j});
        if (sides == found.end()) {
          program_.zeros.push_back({i, j});
        } else {
          all.push_back(sides->second);
        }
      }
    }
    // Branches of the interpreter are foreseen where its loops have one length for long.
    std::stable_sort(all.begin(), all.end(), [](const Sides& a, const Sides& b) {
      return a.term_counts() < b.term_counts();
    });
    return all;
  }

  void write_jacobian() {
    const std::vector<Sides> all = entries();
    const std::map<std::uint32_t, std::uint32_t> by_t = registers_of(all, &Sides::f, 0);
    const auto first_of_g = static_cast<std::uint32_t>(by_t.size());
    const std::map<std::uint32_t, std::uint32_t> by_rest = registers_of(all, &Sides::g, first_of_g);
    // Products by t and 1 - t are taken of registers or of entries, whichever are fewer.
    if (by_t.size() + by_rest.size() < all.size()) {
      for (const auto& [monomial, place] : by_t) program_.by_t.push_back(monomial);
      for (const auto& [monomial, place] : by_rest) program_.by_rest.push_back(monomial);
      for (const Sides& e : all) {
        std::vector<Tape::Summand> summands = moved(e.f, by_t);
        const std::vector<Tape::Summand> more = moved(e.g, by_rest);
        summands.insert(summands.end(), more.begin(), more.end());
        const auto count = static_cast<std::uint32_t>(summands.size());
        program_.jacobian.push_back({e.row, e.column, {sum(summands, 0, count), Sum{}}});
      }
    } else {
      for (const Sides& e : all) {
        const Sum f = entry_sum(e.f);
        const Sum g = entry_sum(e.g);
        program_.jacobian.push_back({e.row, e.column, {f, g}});
      }
    }
  }

  /// The registers that one side's entries read, each with its place among the weighted registers from `first` on.
  std::map<std::uint32_t, std::uint32_t> registers_of(const std::vector<Sides>& all,
                                                      const Tape::Entry* Sides::*side,
                                                      std::uint32_t first) const {
    std::map<std::uint32_t, std::uint32_t> places;
    for (const Sides& e : all) {
      if (e.*side == nullptr) continue;
      for (std::uint32_t k = (e.*side)->begin; k < (e.*side)->end; ++k) {
        places[tape_.jacobian_summands[k].monomial] = 0;
      }
    }
    for (auto& [monomial, place] : places) place = first++;
    return places;
  }

  /// An entry's summands over weighted registers.
  std::vector<Tape::Summand> moved(const Tape::Entry* entry,
                                   const std::map<std::uint32_t, std::uint32_t>& places) const {
    std::vector<Tape::Summand> summands;
    if (entry == nullptr) return summands;
    for (std::uint32_t k = entry->begin; k < entry->end; ++k) {
      const Tape::Summand& summand = tape_.jacobian_summands[k];
      summands.push_back({summand.coefficient, places.at(summand.monomial)});
    }
    return summands;
  }

  Sum entry_sum(const Tape::Entry* entry) {
    return entry == nullptr ? Sum{} : sum(tape_.jacobian_summands, entry->begin, entry->end);
  }

  std::uint32_t n_;
  System system_;
  Tape tape_;
  std::vector<Rounded<Real>> c_;
  LaneProgram<Real> program_;
};

}  // namespace

template <class Real>
LaneProgram<Real> make_lane_program(const Homotopy& homotopy) {
  return Writer<Real>(homotopy).write();
}
template LaneProgram<double> make_lane_program(const Homotopy&);
template LaneProgram<DoubleDouble> make_lane_program(const Homotopy&);

}  // namespace moivre
