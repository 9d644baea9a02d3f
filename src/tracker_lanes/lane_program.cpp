// SPDX-License-Identifier: MIT
// Compiles F and G into one tape and writes it out for the lane interpreter.
#include "lane_program.h"

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

  void write_jacobian() {
    std::map<std::pair<std::uint32_t, std::uint32_t>,
             std::pair<const Tape::Entry*, const Tape::Entry*>>
        entries;
    for (const Tape::Entry& entry : tape_.jacobian) {
      if (entry.row < n_) {
        entries[{entry.row, entry.column}].first = &entry;
      } else {
        entries[{entry.row - n_, entry.column}].second = &entry;
      }
    }
    for (std::uint32_t i = 0; i < n_; ++i) {
      for (std::uint32_t j = 0; j < tape_.variables; ++j) {
        const auto found = entries.find({i, j});
        if (found == entries.end()) {
          program_.zeros.push_back({i, j});
          continue;
        }
        const Sum f = entry_sum(found->second.first);
        const Sum g = entry_sum(found->second.second);
        program_.jacobian.push_back({i, j, {f, g}});
      }
    }
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
