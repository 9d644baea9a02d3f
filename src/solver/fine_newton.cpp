// SPDX-License-Identifier: MIT
// Newton's step in double-double: the tape evaluated, J factored, right-hand sides solved.
#include "fine_newton.h"

#include <algorithm>

namespace moivre {

FineNewton::FineNewton(const RefinerProgram& program)
    : program_(program),
      n_(program.tape.variables),
      registers_(program.tape.register_count()),
      value_(n_),
      jacobian_(program.tape.jacobian.size()),
      lu_(n_),
      dx_(n_),
      rounded_(n_) {}

bool FineNewton::correct(const std::vector<Number>& x) {
  evaluate<Number, Number>(program_.tape, program_.exact, x, registers_, value_, jacobian_);
  const auto j = lu_.matrix();
  std::fill(j.begin(), j.end(), Number(0.0));
  for (std::size_t k = 0; k < jacobian_.size(); ++k) {
    const Tape::Entry& entry = program_.tape.jacobian[k];
    j[entry.row * n_ + entry.column] = jacobian_[k];
  }
  row_size_.assign(n_, 0);
  for (std::size_t i = 0; i < n_ * n_; ++i) row_size_[i / n_] += magnitude1(j[i]);
  if (!lu_.factor()) return false;
  for (std::size_t i = 0; i < n_; ++i) dx_[i] = -value_[i];
  solve();
  return true;
}

void FineNewton::solve(std::span<const double> b) {
  for (std::size_t i = 0; i < n_; ++i) dx_[i] = b[i];
  solve();
}

void FineNewton::add_to(std::vector<Number>& x) const {
  for (std::size_t i = 0; i < n_; ++i) x[i] += dx_[i];
}

double FineNewton::condition() {
  std::vector<double> sum(n_);
  for (std::size_t k = 0; k < n_; ++k) {
    std::fill(dx_.begin(), dx_.end(), Number(0.0));
    dx_[k] = row_size_[k];
    solve();
    for (std::size_t i = 0; i < n_; ++i) sum[i] += std::abs(rounded_[i]);
  }
  return *std::max_element(sum.begin(), sum.end());
}

void FineNewton::solve() {
  lu_.solve(dx_);
  std::transform(dx_.begin(), dx_.end(), rounded_.begin(),
                 [](const Number& d) { return to_complex(d); });
}

}  // namespace moivre
