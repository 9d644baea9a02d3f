// SPDX-License-Identifier: MIT
// How does a Newton-Raphson run go, and how does it end?
#include "moivre/kinematics/newton.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "extreme_singular_values.h"
#include "moivre/expression/counted.h"
#include "moivre/kinematics/own_units.h"
#include "moivre/numeric/invalid_input.h"
#include "noise.h"

namespace moivre {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Of sizes in own units:
constexpr double kEscape = 1e9;          // times the guess's size: nothing assembles out there
constexpr double kStandstill = 1e-12;    // step relative to q: the run has come to rest
constexpr double kRestResidual = 1e-12;  // |Phi_i| relative to its scale: rounding, at rest
// Where rows are given up as dependent, they may be short links beside long ones: only rounding
// itself is zero there.
constexpr double kRestResidualOfLostRows = 64 * std::numeric_limits<double>::epsilon();
constexpr double kReturn = 1e-9;  // distance relative to q at which an earlier iterate is back
constexpr double kMoving = 1e-6;  // step relative to q: a cycle's steps are larger than this

void validate(const Phi& phi, const VectorXd& guess, double t, const NewtonOptions& options) {
  std::string broken;
  if (guess.size() != phi.dimension()) {
    broken += "the guess has " + std::to_string(guess.size()) + " entries, there are " +
              counted(phi.dimension(), "coordinate") + ". ";
  }
  if (!guess.allFinite()) broken += "the guess must be finite. ";
  if (!std::isfinite(t)) broken += "the time must be finite. ";
  if (!(options.residual_tolerance > 0) || !std::isfinite(options.residual_tolerance)) {
    broken += "residual_tolerance must be finite and positive. ";
  }
  if (options.maximum_iterations < 1) broken += "maximum_iterations must be 1 or more. ";
  for (const Index k : options.held) {
    if (k < 0 || k >= phi.dimension()) broken += "held names no coordinate. ";
  }
  if (!broken.empty()) throw InvalidInput(broken.substr(0, broken.size() - 1));
}

bool is_held(const NewtonOptions& options, Index k) {
  return std::find(options.held.begin(), options.held.end(), k) != options.held.end();
}

std::vector<Index> free_coordinates(const Phi& phi, const NewtonOptions& options) {
  std::vector<Index> free;
  for (Index k = 0; k < phi.dimension(); ++k) {
    if (!is_held(options, k)) free.push_back(k);
  }
  return free;
}

/// The columns of the free coordinates.
MatrixXd columns(const MatrixXd& J, const std::vector<Index>& free) {
  return static_cast<Index>(free.size()) == J.cols() ? J : MatrixXd(J(Eigen::all, free));
}

double own_size_of(const Phi& phi, const VectorXd& q) { return std::max(1.0, largest_of(phi, q)); }

NewtonIteration measured(const Phi& phi, const VectorXd& q, double t) {
  NewtonIteration row;
  row.q = q;
  row.residual = phi.size() == 0 ? 0 : phi.value(q, t).lpNorm<Eigen::Infinity>();
  row.scaled_residual = scaled_residual(phi, q, t);
  return row;
}

/// The row of an iterate. A row of Phi whose terms are all rounding noise has no scale of its own:
/// where noise alone keeps an iterate from passing, it is taken without the noise.
NewtonIteration look(const Phi& phi, const VectorXd& q, double t, const NewtonOptions& options) {
  NewtonIteration row = measured(phi, q, t);
  if (!q.allFinite() || row.scaled_residual <= options.residual_tolerance) return row;
  const NewtonIteration clean = measured(phi, without_noise(phi, q, options.held), t);
  return clean.scaled_residual <= options.residual_tolerance ? clean : row;
}

/// How many steps ago the last iterate was visited before; 0 when it is new.
int cycle_length(const Phi& phi, const std::vector<NewtonIteration>& rows) {
  const VectorXd& q = rows.back().q;
  const double size = own_size_of(phi, q);
  for (std::size_t back = 2; back < rows.size(); ++back) {
    const VectorXd& old = rows[rows.size() - 1 - back].q;
    const VectorXd& after_old = rows[rows.size() - back].q;
    const bool returned = largest_of(phi, q - old) <= kReturn * size;
    if (returned && largest_of(phi, after_old - old) > kMoving * size)
      return static_cast<int>(back);
  }
  return 0;
}

/// The verdict that the last row calls for, before another step is taken from it.
std::optional<NewtonStatus> verdict(const Phi& phi, const NewtonResult& run, const VectorXd& guess,
                                    const NewtonOptions& options) {
  const NewtonIteration& row = run.iterations.back();
  const bool is_number = row.q.allFinite() && std::isfinite(row.scaled_residual);
  if (!is_number || own_size_of(phi, row.q) > kEscape * own_size_of(phi, guess))
    return NewtonStatus::diverged;
  if (row.scaled_residual <= options.residual_tolerance) return NewtonStatus::converged;
  if (run.cycle_length > 0) return NewtonStatus::cycling;
  return std::nullopt;
}

/// The verdict on a step that hardly moves q.
NewtonStatus at_rest(const Phi& phi, const NewtonIteration& row, double t, Index full_rank) {
  const VectorXd residual = phi.value(row.q, t).cwiseAbs();
  const VectorXd scale = row_sizes(phi, row.q, t);
  const bool has_lost_rows = row.rank < full_rank;
  const double rounding = has_lost_rows ? kRestResidualOfLostRows : kRestResidual;
  if ((residual.array() <= rounding * scale.array()).all()) return NewtonStatus::converged;
  return has_lost_rows ? NewtonStatus::singular : NewtonStatus::no_solution;
}

std::string message_of(const NewtonResult& run) {
  const std::string after = " after " + counted(run.steps(), "step");
  switch (run.status) {
    case NewtonStatus::converged:
      return "converged" + after + (run.is_singular ? ", at a singular pose" : "");
    case NewtonStatus::diverged:
      return "diverged" + after + ": the iterates leave every bound; try another guess";
    case NewtonStatus::cycling:
      return "cycles" + after + ": the iterates repeat every " + counted(run.cycle_length, "step") +
             "; try another guess";
    case NewtonStatus::singular:
      return "stopped" + after + " at a singular Jacobian (rank " + std::to_string(run.rank) +
             ") where Phi is not zero; try another guess";
    case NewtonStatus::no_solution:
      return "stopped" + after +
             " at a least-squares minimum where Phi is not zero: the constraints contradict each "
             "other here";
    case NewtonStatus::iteration_limit:
      return "not converged" + after;
  }
  return "";
}

/// Rank, singular values and residuals where the run ended.
void describe_end(const Phi& phi, double t, const std::vector<Index>& free,
                  const NewtonOptions& options, NewtonResult& run) {
  NewtonIteration& last = run.iterations.back();
  run.q = last.q;
  run.residual = last.residual;
  run.scaled_residual = last.scaled_residual;
  if (!last.q.allFinite()) return;
  const MatrixXd all = phi.jacobian(last.q, t);
  const MatrixXd J = columns(all, free);
  if (J.size() == 0 || !J.allFinite()) return;
  const bool is_tall = J.rows() >= J.cols();
  const MatrixXd A = is_tall ? J : MatrixXd(J.transpose());
  const Index full_rank = A.cols();
  const StaircaseOrder order = staircase_order(A);
  run.smallest_singular_value = smallest_singular_value(A, order);
  run.rank = stays_regular(J, run.smallest_singular_value)
                 ? full_rank
                 : numerical_rank(columns(in_own_units(phi, all), free));
  last.rank = run.rank;
  run.is_singular = run.rank < full_rank;
  if (!options.with_condition) return;
  const MatrixXd scaled_J = equilibrated(J);
  const ExtremeSingularValues scaled =
      extreme_singular_values(is_tall ? scaled_J : MatrixXd(scaled_J.transpose()), order);
  run.condition = scaled.largest / scaled.smallest;
}

}  // namespace

std::string to_string(NewtonStatus status) {
  switch (status) {
    case NewtonStatus::converged:
      return "converged";
    case NewtonStatus::diverged:
      return "diverged";
    case NewtonStatus::cycling:
      return "cycling";
    case NewtonStatus::singular:
      return "singular";
    case NewtonStatus::no_solution:
      return "no_solution";
    case NewtonStatus::iteration_limit:
      return "iteration_limit";
  }
  return "";
}

NewtonResult newton(const Phi& phi, const VectorXd& guess, double t, const NewtonOptions& options) {
  validate(phi, guess, t, options);
  const std::vector<Index> free = free_coordinates(phi, options);
  NewtonResult run;
  run.iterations.push_back(look(phi, guess, t, options));
  std::optional<NewtonStatus> status = verdict(phi, run, guess, options);
  while (!status && run.steps() < options.maximum_iterations) {
    NewtonIteration& row = run.iterations.back();
    const MatrixXd all = phi.jacobian(row.q, t);
    const MatrixXd J = columns(all, free);
    if (!J.allFinite()) {
      status = NewtonStatus::diverged;
      break;
    }
    LinearOptions linear = options.linear;
    linear.row_units = phi.own_row_units();
    linear.column_units = phi.own_units()(free);
    const Factorization factors(J, linear);
    const VectorXd step = factors.solve(-phi.value(row.q, t));
    row.step = step.lpNorm<Eigen::Infinity>();
    row.rank = factors.rank();
    row.method = factors.method();
    VectorXd change = VectorXd::Zero(row.q.size());
    change(free) = step;
    VectorXd next = row.q + change;
    if (options.held.empty() && phi.has_long_rotation(next)) next = phi.canonical(next);
    const bool rests = largest_of(phi, change) <= kStandstill * own_size_of(phi, row.q);
    const NewtonStatus rest_verdict = at_rest(phi, row, t, std::min(J.rows(), J.cols()));
    run.iterations.push_back(look(phi, next, t, options));
    run.iterations.back().method = factors.method();
    run.cycle_length = cycle_length(phi, run.iterations);
    status = verdict(phi, run, guess, options);
    if (!status && rests) status = rest_verdict;
  }
  run.status = status.value_or(NewtonStatus::iteration_limit);
  if (run.status != NewtonStatus::cycling) run.cycle_length = 0;
  describe_end(phi, t, free, options, run);
  run.message = message_of(run);
  return run;
}

}  // namespace moivre
