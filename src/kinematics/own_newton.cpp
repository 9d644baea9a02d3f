// SPDX-License-Identifier: MIT
// The run on a function of which nothing is known but its values.
#include "moivre/kinematics/own_newton.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "moivre/expression/counted.h"
#include "moivre/factorization/svd.h"
#include "moivre/numeric/invalid_input.h"

namespace moivre {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Relative to |q|, which is 1 at least:
constexpr double kFarAway = 1e9;       // times the guess's
constexpr double kNoStep = 1e-12;      // the run has come to rest
constexpr double kAtRest = 1e-12;      // scaled residual, for a run at rest
constexpr double kCameBack = 1e-9;     // of an earlier iterate
constexpr double kStillMoving = 1e-6;  // a cycle's steps are larger than this

double size_of_own(const VectorXd& q) { return std::max(1.0, q.lpNorm<Eigen::Infinity>()); }

/// f and J, of the sizes that they have at the guess.
class Checked {
 public:
  Checked(const OwnFunction& f, const VectorXd& guess) : f_(f), n_(guess.size()) {
    m_ = f_.value(guess).size();
  }

  VectorXd value(const VectorXd& q) const {
    VectorXd values = f_.value(q);
    if (values.size() == m_) return values;
    throw InvalidInput("the function has " + counted(m_, "value") + " at the guess and " +
                       std::to_string(values.size()) + " later");
  }

  MatrixXd jacobian(const VectorXd& q) const {
    if (!f_.jacobian) return by_differences(q);
    MatrixXd J = f_.jacobian(q);
    if (J.rows() == m_ && J.cols() == n_) return J;
    throw InvalidInput("the Jacobian must be " + std::to_string(m_) + " x " + std::to_string(n_) +
                       ", not " + std::to_string(J.rows()) + " x " + std::to_string(J.cols()));
  }

 private:
  MatrixXd by_differences(const VectorXd& q) const {
    const double h = std::cbrt(std::numeric_limits<double>::epsilon()) * size_of_own(q);
    MatrixXd J(m_, n_);
    for (Index k = 0; k < n_; ++k) {
      VectorXd ahead = q;
      VectorXd behind = q;
      ahead[k] += h;
      behind[k] -= h;
      J.col(k) = (value(ahead) - value(behind)) / (ahead[k] - behind[k]);
    }
    return J;
  }

  const OwnFunction& f_;
  Index n_;
  Index m_ = 0;
};

void require_usable(const OwnFunction& f, const VectorXd& guess, const OwnNewtonOptions& options) {
  std::vector<std::string> broken;
  if (!f.value) broken.emplace_back("there is no function");
  if (guess.size() == 0) broken.emplace_back("the guess is empty");
  if (!guess.allFinite()) broken.emplace_back("the guess must be finite");
  if (f.unknowns < 0) broken.emplace_back("the number of unknowns must be 0 or more");
  if (f.unknowns > 0 && guess.size() > 0 && guess.size() != f.unknowns) {
    broken.push_back("the guess has " + counted(guess.size(), "entry", "entries") +
                     ", the function has " + counted(f.unknowns, "unknown"));
  }
  if (!(options.residual_tolerance > 0) || !std::isfinite(options.residual_tolerance)) {
    broken.emplace_back("residual_tolerance must be finite and positive");
  }
  if (options.maximum_iterations < 1) broken.emplace_back("maximum_iterations must be 1 or more");
  require_unbroken(broken);
}

struct Here {
  VectorXd value;
  MatrixXd jacobian;
};

NewtonIteration row_at(const VectorXd& q, const Here& here) {
  NewtonIteration row;
  row.q = q;
  row.residual = here.value.size() == 0 ? 0 : here.value.lpNorm<Eigen::Infinity>();
  for (Index i = 0; i < here.value.size(); ++i) {
    const double scale = here.jacobian.row(i).lpNorm<Eigen::Infinity>() * size_of_own(q);
    const double share = std::abs(here.value[i]) / scale;
    if (here.value[i] != 0 && !(share <= row.scaled_residual)) row.scaled_residual = share;
  }
  return row;
}

/// How many steps ago the last iterate was visited before; 0 when it is new.
int length_of_cycle(const std::vector<NewtonIteration>& rows) {
  const VectorXd& q = rows.back().q;
  for (std::size_t back = 2; back < rows.size(); ++back) {
    const NewtonIteration& old = rows[rows.size() - 1 - back];
    const bool returned = (q - old.q).lpNorm<Eigen::Infinity>() <= kCameBack * size_of_own(q);
    if (returned && old.step > kStillMoving * size_of_own(q)) return static_cast<int>(back);
  }
  return 0;
}

std::optional<NewtonStatus> verdict_on(const NewtonResult& run, const Here& here,
                                       const OwnNewtonOptions& options) {
  const NewtonIteration& row = run.iterations.back();
  const bool is_number = row.q.allFinite() && here.value.allFinite() && here.jacobian.allFinite();
  const double far = kFarAway * size_of_own(run.iterations.front().q);
  if (!is_number || size_of_own(row.q) > far) return NewtonStatus::diverged;
  if (row.scaled_residual <= options.residual_tolerance) return NewtonStatus::converged;
  if (run.cycle_length > 0) return NewtonStatus::cycling;
  return std::nullopt;
}

std::string said(const NewtonResult& run) {
  const std::string after = " after " + counted(run.steps(), "step");
  switch (run.status) {
    case NewtonStatus::converged:
      return "converged" + after + (run.is_singular ? ", where the Jacobian is singular" : "");
    case NewtonStatus::diverged:
      return "diverged" + after;
    case NewtonStatus::cycling:
      return "cycles" + after + ": the iterates repeat every " + counted(run.cycle_length, "step");
    case NewtonStatus::singular:
      return "stopped" + after + " at a singular Jacobian where the function is not zero";
    case NewtonStatus::no_solution:
      return "stopped" + after + " at a least-squares minimum where the function is not zero";
    case NewtonStatus::iteration_limit:
      break;
  }
  return "not converged" + after;
}

void describe(const Here& here, NewtonResult& run) {
  const NewtonIteration& last = run.iterations.back();
  run.q = last.q;
  run.residual = last.residual;
  run.scaled_residual = last.scaled_residual;
  if (here.jacobian.size() == 0 || !here.jacobian.allFinite()) return;
  run.rank = numerical_rank(here.jacobian);
  run.iterations.back().rank = run.rank;
  run.is_singular = run.rank < std::min(here.jacobian.rows(), here.jacobian.cols());
  run.smallest_singular_value = singular_values(here.jacobian).minCoeff();
}

}  // namespace

NewtonResult newton(const OwnFunction& f, const VectorXd& guess, const OwnNewtonOptions& options) {
  require_usable(f, guess, options);
  const Checked function(f, guess);
  const auto look_at = [&](const VectorXd& q) {
    return Here{function.value(q), function.jacobian(q)};
  };
  NewtonResult run;
  Here here = look_at(guess);
  run.iterations.push_back(row_at(guess, here));
  std::optional<NewtonStatus> status = verdict_on(run, here, options);
  while (!status && run.steps() < options.maximum_iterations) {
    NewtonIteration& row = run.iterations.back();
    const Factorization factors(here.jacobian);
    const VectorXd step = factors.solve(-here.value);
    row.step = step.lpNorm<Eigen::Infinity>();
    row.rank = factors.rank();
    row.method = factors.method();
    const bool has_lost_rank = row.rank < std::min(here.jacobian.rows(), here.jacobian.cols());
    const VectorXd next = row.q + step;
    if (!next.allFinite()) {
      status = NewtonStatus::diverged;
      break;
    }
    const bool rests = row.step <= kNoStep * size_of_own(row.q);
    const NewtonStatus at_rest = row.scaled_residual <= kAtRest ? NewtonStatus::converged
                                 : has_lost_rank                ? NewtonStatus::singular
                                                                : NewtonStatus::no_solution;
    here = look_at(next);
    run.iterations.push_back(row_at(next, here));
    run.iterations.back().method = factors.method();
    run.cycle_length = length_of_cycle(run.iterations);
    status = verdict_on(run, here, options);
    if (!status && rests) status = at_rest;
  }
  run.status = status.value_or(NewtonStatus::iteration_limit);
  if (run.status != NewtonStatus::cycling) run.cycle_length = 0;
  describe(here, run);
  run.message = said(run);
  return run;
}

}  // namespace moivre
