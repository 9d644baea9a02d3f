// SPDX-License-Identifier: MIT
// A path's number becomes a choice of factors, the choice a point: one small linear system a group.

#include "moivre/factorization/lu.h"
#include "moivre/numeric/invalid_input.h"
#include "moivre/start/linear_product.h"
#include "moivre/start/total_degree.h"

namespace moivre {
namespace {

/// Equation i takes factor `factor` of group `group`.
struct Chosen {
  std::size_t group = 0;
  std::uint64_t factor = 0;
};

/// The way through the numbers, equation by equation: a group j that may still be taken stands for
/// d_ij c(r - e_j) of them, c(r - e_j) a factor.
class Way {
 public:
  explicit Way(const LinearProductStart& start) : start_(start) {
    std::uint64_t entries = 1;
    for (const auto& group : start.groups) {
      left_.push_back(group.size());
      strides_.push_back(entries);
      entries *= group.size() + 1;
    }
    at_ = entries - 1;
  }

  /// c(r - e_j), 0 where equation i can't take group j.
  std::uint64_t numbers(std::size_t i, std::size_t j) const {
    if (left_[j] == 0 || start_.degrees[i][j] == 0) return 0;
    return start_.completions[at_ - strides_[j]];
  }
  void take(std::size_t j) {
    --left_[j];
    at_ -= strides_[j];
  }

 private:
  const LinearProductStart& start_;
  std::vector<std::uint64_t> left_;
  std::vector<std::uint64_t> strides_;
  std::uint64_t at_ = 0;
};

std::vector<Chosen> choice(const LinearProductStart& start, std::uint64_t number) {
  Way way(start);
  std::vector<Chosen> chosen;
  for (std::size_t i = 0; i < start.degrees.size(); ++i) {
    for (std::size_t j = 0; j < start.groups.size(); ++j) {
      const std::uint64_t rest = way.numbers(i, j);
      const std::uint64_t d = start.degrees[i][j];
      if (rest > 0 && number / rest < d) {
        chosen.push_back({j, number / rest});
        number %= rest;
        way.take(j);
        break;
      }
      number -= rest * d;
    }
  }
  return chosen;
}

/// The point of one group: the linear equations of those that chose it.
void solve_group(const LinearProductStart& start, const std::vector<Chosen>& chosen, std::size_t j,
                 Point& x) {
  const std::vector<std::uint32_t>& group = start.groups[j];
  Lu lu(group.size());
  Point b;
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    if (chosen[i].group != j) continue;
    const std::vector<Point>& forms = start.factors[i][j].forms;
    if (group.size() == 1) {
      const Complex z = -forms[0][1] / forms[0][0];
      x[group[0]] = de_moivre_root(z, start.degrees[i][j], chosen[i].factor);
      return;
    }
    const Point& form = forms[chosen[i].factor];
    for (std::size_t l = 0; l < group.size(); ++l)
      lu.matrix()[b.size() * group.size() + l] = form[l];
    b.push_back(-form.back());
  }
  lu.factor();
  lu.solve(b);
  for (std::size_t l = 0; l < group.size(); ++l) x[group[l]] = b[l];
}

}  // namespace

Point start_point(const LinearProductStart& start, std::uint64_t number) {
  if (number >= start.paths) {
    throw InvalidInput("path " + std::to_string(number) + " of " + std::to_string(start.paths));
  }
  const std::vector<Chosen> chosen = choice(start, number);
  Point x(start.degrees.size() + 1, 1.0);
  for (std::size_t j = 0; j < start.groups.size(); ++j) solve_group(start, chosen, j, x);
  return x;
}

}  // namespace moivre
