// SPDX-License-Identifier: MIT
// From real roots to closures: polished, told from motion, filtered by limits, put in order.
#include "closure_poses.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "closure_sentences.h"
#include "fitted_poses.h"
#include "moivre/closures/canonical_order.h"
#include "moivre/closures/same_pose.h"
#include "moivre/factorization/svd.h"
#include "moivre/kinematics/newton.h"
#include "moivre/kinematics/own_units.h"
#include "moivre/mechanism/closure_id.h"
#include "moivre/mechanism/drawn_pose.h"
#include "moivre/mechanism/joint_type.h"
#include "moivre/mechanism/pose.h"
#include "moivre/mechanism/spins.h"
#include "moivre/numeric/near_points.h"
#include "moving_pose.h"

namespace moivre {
namespace {

// Newton-Raphson polishes a pose; it does not look for another.
constexpr double kPolish = 1e-4;
// From a pose of links as meant to one of the file's it goes some times as far as these are apart.
constexpr double kMoved = 10;

/// Along the direction v that Phi_q sees least, from the pose q: r + sigma s + b s^2 / 2.
struct Weakest {
  Eigen::VectorXd v;
  double r = 0;
  double sigma = 0;
  double b = 0;
};

/// nullopt: nothing is unknown, or no equation says anything of it.
std::optional<Weakest> weakest_at(const Phi& phi, const Eigen::VectorXd& q, double t) {
  const Eigen::VectorXd row_units = phi.own_row_units();
  const Svd J = svd(in_own_units(phi, phi.jacobian(q, t)), SingularVectors::thin);
  if (J.sigma.size() == 0) return std::nullopt;
  const Eigen::Index last = J.sigma.size() - 1;
  Weakest weakest;
  weakest.v = phi.own_units().cwiseProduct(J.V.col(last));
  weakest.sigma = J.sigma[last];
  const auto of_rows = [&](const Eigen::VectorXd& rows) {
    return J.U.col(last).dot(rows.cwiseQuotient(row_units));
  };
  weakest.r = of_rows(phi.value(q, t));
  weakest.b = of_rows(phi.second_derivative(q, weakest.v, t, 0));
  return weakest;
}

/// Whether a root is near the pose q, as Phi and its derivatives there say. Beside a fold there is
/// no real zero though r is next to nothing.
bool has_root_nearby(const Phi& phi, const Eigen::VectorXd& q, double t) {
  constexpr double kSure = 0.125;  // of sigma^2; from 1/2 on there is no zero
  const std::optional<Weakest> weakest = weakest_at(phi, q, t);
  if (!weakest) return true;
  const double rounding = std::numeric_limits<double>::epsilon() *
                          row_sizes(phi, q, t).cwiseQuotient(phi.own_row_units()).maxCoeff();
  const double r = std::abs(weakest->r) + rounding;
  return r * std::abs(weakest->b) < kSure * weakest->sigma * weakest->sigma;
}

/// Newton-Raphson's run from where the other root beside the fold next to q is: s = -2 sigma / b.
std::optional<NewtonResult> across_the_fold(const Phi& phi, const Eigen::VectorXd& q, double t) {
  const std::optional<Weakest> weakest = weakest_at(phi, q, t);
  if (!weakest || weakest->b == 0) return std::nullopt;
  const Eigen::VectorXd there = q - 2 * weakest->sigma / weakest->b * weakest->v;
  if (!there.allFinite()) return std::nullopt;
  return newton(phi, there, t);
}

void take_pose(ClosureSearch& search, const Solution& solution, const NewtonResult& polished) {
  ++search.result.counts.real;
  Closure closure = closure_at(search, polished);
  if (!is_allowed(search, closure.q)) {
    ++search.result.counts.filtered;
    return;
  }
  closure.path = solution.path;
  closure.multiplicity = solution.multiplicity;
  closure.cluster = solution.cluster;
  closure.singular = solution.singular;
  closure.certified = solution.certified;
  search.result.closures.push_back(std::move(closure));
}

/// A double root of the solved equations may be two that rounding has parted, of which a spare
/// equation leaves one. Their pose is regular, and nearer to one that is known than another regular
/// pose can be.
bool is_told(const ClosureSearch& search, const NewtonResult& pose) {
  const System& f = search.formulation.system;
  if (f.polynomials.size() <= f.variables.size() || pose.is_singular) return false;
  const auto& closures = search.result.closures;
  return std::any_of(closures.begin(), closures.end(), [&](const Closure& other) {
    return distance(search.phi, other.q, search.phi.canonical(pose.q)) <=
           kSamePose * std::min(1.0, other.smallest_singular_value);
  });
}

/// What rounding has parted of a multiple root comes back to one pose: that closure. nullptr where
/// there is none, or proofs tell the roots apart.
Closure* joined_by(ClosureSearch& search, const Solution& solution, const NewtonResult& pose) {
  if (!pose.is_singular || solution.certified == true) return nullptr;
  const Eigen::VectorXd q = search.phi.canonical(pose.q);
  auto& closures = search.result.closures;
  const auto at = std::find_if(closures.begin(), closures.end(), [&](const Closure& other) {
    return other.certified != true && is_same_pose(search.phi, other.q, q);
  });
  return at == closures.end() ? nullptr : &*at;
}

/// The closure and its root, one of those before, stand for this root, too.
void join(Closure& closure, const Solution& solution, std::vector<Solution>& before) {
  closure.multiplicity += solution.multiplicity;
  closure.cluster = closure.singular = true;
  const auto root = std::find_if(before.begin(), before.end(),
                                 [&](const Solution& other) { return other.path == closure.path; });
  if (root == before.end()) return;
  root->multiplicity = closure.multiplicity;
  root->cluster = root->singular = true;
  root->radius = std::max(root->radius, max_distance(root->x, solution.x));
}

bool is_known(const ClosureSearch& search, const Eigen::VectorXd& q) {
  const auto& closures = search.result.closures;
  return std::any_of(closures.begin(), closures.end(), [&](const Closure& other) {
    return distance(search.phi, other.q, q) <= kSamePose;
  });
}

enum class RootKind {
  isolated,  ///< and, where it is real, polished to a pose
  joined,    ///< to a closure at the same singular pose
  on_a_set,  ///< its pose is one of many
  /// Spare constraints keep Newton-Raphson away from zero, or leave one of several roots at its
  /// pose.
  does_not_close
};

/// The root is alone, as the numbers were typed: that double sees nothing hold its pose says how
/// far double sees, and not that it moves.
bool is_proved_as_typed(const ClosureSearch& search, const Solution& solution) {
  return solution.certified == true && search.proves_as_typed();
}

/// Newton-Raphson's run from a root, and whether it came to a pose next to it.
struct Polished {
  NewtonResult pose;
  bool stayed = false;
};

/// The run that ends where it began, at a proved root whose residual is rounding; nothing where it
/// is more. Where Phi_q is singular in double a step goes as far along its null space as rounding
/// likes, and the root is known better than where it leads.
std::optional<NewtonResult> at_proved_root(const ClosureSearch& search, const Solution& solution,
                                           const Eigen::VectorXd& guess) {
  constexpr double kRounding = 1e-12;
  if (!is_proved_as_typed(search, solution)) return std::nullopt;
  NewtonOptions options;
  options.residual_tolerance = kRounding;
  NewtonResult run = newton(search.phi, guess, search.options.time, options);
  return run.steps() == 0 ? std::optional(std::move(run)) : std::nullopt;
}

/// Of the two roots beside a fold of links as meant both may lead to one of the file's two: then
/// the second one leads to the other.
Polished polished_from(const ClosureSearch& search, const Solution& solution) {
  const Phi& phi = search.phi;
  const double meant_within = search.formulation.meant_within;
  const Eigen::VectorXd guess = coordinates_of_root(search.formulation, solution.x);
  const double most =
      std::max(kPolish, kMoved * meant_within) * std::max(1.0, largest_of(phi, guess));
  const auto has_stayed = [&](const Eigen::VectorXd& q) {
    // At half a turn the same angle has two names.
    return largest_of(phi, phi.canonical(q) - phi.canonical(guess)) <= most ||
           largest_of(phi, q - guess) <= most;
  };
  NewtonResult pose = newton(phi, guess, search.options.time);
  if (pose.is_singular) {
    if (auto root = at_proved_root(search, solution, guess)) pose = std::move(*root);
  }
  if (meant_within > 0 && pose.status == NewtonStatus::converged && !pose.is_singular &&
      is_known(search, phi.canonical(pose.q))) {
    std::optional<NewtonResult> other = across_the_fold(phi, pose.q, search.options.time);
    if (other && other->status == NewtonStatus::converged && has_stayed(other->q)) {
      pose = std::move(*other);
    }
  }
  const bool stayed = has_stayed(pose.q);
  return {std::move(pose), stayed};
}

/// Polishes a real root to a pose. `before`: those that are isolated.
RootKind polish(ClosureSearch& search, const Solution& solution, std::vector<Solution>& before) {
  const Phi& phi = search.phi;
  const auto [polished, stayed] = polished_from(search, solution);
  if (polished.status == NewtonStatus::no_solution && phi.size() > phi.dimension() && stayed) {
    search.near_misses.push_back({solution});
    return RootKind::does_not_close;
  }
  if (polished.status != NewtonStatus::converged || !stayed) {
    ++search.unpolished;
    return RootKind::isolated;
  }
  const bool may_move = polished.is_singular && !is_proved_as_typed(search, solution);
  if (may_move && lies_on_motion(search, phi.canonical(polished.q))) {
    return RootKind::on_a_set;
  }
  const bool is_meant = search.formulation.meant_within > 0;
  if (is_told(search, polished) || (is_meant && is_known(search, phi.canonical(polished.q)))) {
    return RootKind::does_not_close;
  }
  if (Closure* const same = joined_by(search, solution, polished)) {
    join(*same, solution, before);
    return RootKind::joined;
  }
  take_pose(search, solution, polished);
  return RootKind::isolated;
}

/// A root that an equation whose terms nearly cancel does not know, but all of Phi does: it is one.
void take_back(ClosureSearch& search, Solution solution, const NewtonResult& pose) {
  solution.real = true;
  solution.residual = residual_by_size(search.phi, pose.q, search.options.time);
  if (search.has_proofs()) solution.certified = false;
  --search.result.counts.rejected;
  take_pose(search, solution, pose);
  search.result.solutions.push_back(std::move(solution));
}

/// Keeps the pose, once, where it misses by what the third digit of lengths explains and is none
/// that closes.
void note_near_closure(ClosureSearch& search, const Closure& pose) {
  constexpr double kRounded = 1e-3;
  if (pose.misfit > kRounded * search.phi.length()) return;
  if (broken_limit(search.mechanism, pose.q)) return;
  const auto is_it = [&](const Closure& other) {
    return is_same_pose(search.phi, other.q, pose.q);
  };
  for (const auto* poses : {&search.result.closures, &search.near_closures}) {
    if (std::any_of(poses->begin(), poses->end(), is_it)) return;
  }
  search.near_closures.push_back(pose);
}

/// What misses by little: the least squares beside each near miss, taken where it closes after all,
/// or is within Mechanism::fit. The drawn pose comes first: it stands for all that hang together
/// with it.
void take_near_misses(ClosureSearch& search) {
  const double t = search.options.time;
  if (search.mechanism.fit && is_drawn_at(search.mechanism, t)) {
    const NewtonResult drawn = settled(search, Eigen::VectorXd::Zero(search.phi.dimension()));
    if (!is_at_root(search, drawn)) take_fitted(search, drawn);
  }
  for (const auto& [near, is_rejected, is_near] : search.near_misses) {
    const NewtonResult least = settled(search, coordinates_of_root(search.formulation, near.x));
    if (!least.q.allFinite()) continue;
    const Closure closure = closure_at(search, least);
    if (is_near && is_rejected && !is_known(search, closure.q) && shows_a_loss(search, least)) {
      take_back(search, near, least);
      continue;
    }
    if (is_at_root(search, least)) continue;
    if (is_near) {
      note_misfit(search, closure);
      note_near_closure(search, closure);
    }
    take_fitted(search, least);
  }
  for (const Eigen::VectorXd& q : search.fitted_before) take_fitted(search, settled(search, q));
}

}  // namespace

bool is_allowed(ClosureSearch& search, const Eigen::VectorXd& q) {
  const Joint* const broken = broken_limit(search.mechanism, q);
  if (broken) ++search.beyond_limits[broken];
  return !broken;
}

// At rest Newton-Raphson takes for zero what twelve digits leave; where constraints contradict each
// other by so little, no root is a closure, and no such pose is one.
bool closes(const ClosureSearch& search, const NewtonResult& pose) {
  constexpr double kRounding = 1e-14;  // beside a row's size
  if (pose.status != NewtonStatus::converged) return false;
  return search.phi.size() <= search.phi.dimension() ||
         residual_by_size(search.phi, pose.q, search.options.time) <= kRounding;
}

void tell_limits(ClosureSearch& search) {
  for (const auto& [joint, count] : search.beyond_limits) {
    search.result.left_out.push_back(closures_beyond_limits_left_out(count, *joint));
  }
}

bool lies_on_motion(ClosureSearch& search, const Eigen::VectorXd& q) {
  // Sets would take away of what the isolated roots are counted against.
  const bool has_no_set = search.result.completeness == RootCompleteness::proved;
  if (has_no_set && search.proves_as_typed()) return false;
  auto moves = moves_at(search.phi, q, search.options.time, search.options.solve.seed);
  if (!moves) return false;
  search.result.moves = std::move(moves);
  // What was shown of isolated closures is not.
  auto& completeness = search.result.completeness;
  if (completeness) completeness = RootCompleteness::open;
  return true;
}

bool has_gears(const Mechanism& mechanism) {
  return std::any_of(mechanism.joints.begin(), mechanism.joints.end(),
                     [](const Joint& joint) { return is_transmission(joint.type); });
}

bool is_at_root(const ClosureSearch& search, const NewtonResult& pose) {
  const double t = search.options.time;
  return closes(search, pose) &&
         (has_root_nearby(search.phi, pose.q, t) ||
          moves_at(search.phi, search.phi.canonical(pose.q), t, search.options.solve.seed));
}

bool shows_a_loss(const ClosureSearch& search, const NewtonResult& pose) {
  // It may be in another meshing of the teeth than the drawn one.
  return is_at_root(search, pose) && !pose.is_singular && !search.result.moves &&
         !has_gears(search.mechanism) && are_spins_as_meant(search.mechanism, pose.q) &&
         !broken_limit(search.mechanism, search.phi.canonical(pose.q));
}

void note_misfit(ClosureSearch& search, const Closure& pose) {
  ClosureResult& result = search.result;
  if (result.least_misfit && *result.least_misfit <= pose.misfit) return;
  Eigen::Index worst = 0;
  row_misfits(search.phi, pose.q, search.options.time).maxCoeff(&worst);
  result.least_misfit = pose.misfit;
  result.misses_most = search.phi.row_names()[static_cast<std::size_t>(worst)];
}

Closure closure_at(const ClosureSearch& search, const NewtonResult& polished) {
  Closure closure;
  closure.q = search.phi.canonical(polished.q);
  closure.residual = residual_by_size(search.phi, closure.q, search.options.time);
  closure.misfit = misfit(search.phi, closure.q, search.options.time);
  closure.newton_iterations = polished.steps();
  closure.smallest_singular_value = polished.smallest_singular_value;
  return closure;
}

void letter(std::vector<Closure>& closures, const Phi& phi) {
  std::vector<Eigen::VectorXd> poses;
  poses.reserve(closures.size());
  for (const Closure& closure : closures) poses.push_back(closure.q);
  std::vector<Closure> ordered;
  for (const std::size_t k : canonical_order(poses, phi.coordinates(), phi.length())) {
    ordered.push_back(std::move(closures[k]));
    ordered.back().id = closure_id(ordered.size() - 1);
  }
  closures = std::move(ordered);
}

// A root where motions cross may look isolated to the solver; its pose tells, and its paths are
// counted anew.
void find_poses(ClosureSearch& search) {
  ClosureResult& result = search.result;
  search.beyond_limits.clear();
  search.fitted_beyond_limits.clear();
  search.near_closures.clear();
  std::vector<Solution> isolated;
  for (Solution& solution : result.solutions) {
    const RootKind kind = solution.real ? polish(search, solution, isolated) : RootKind::isolated;
    switch (kind) {
      case RootKind::isolated:
        isolated.push_back(std::move(solution));
        break;
      case RootKind::joined:
        break;
      case RootKind::on_a_set:
        result.paths.on_positive_dimensional += solution.multiplicity;
        result.stages.back().paths.on_positive_dimensional += solution.multiplicity;
        break;
      case RootKind::does_not_close:
        ++result.counts.rejected;
        break;
    }
  }
  result.solutions = std::move(isolated);
  take_near_misses(search);
  result.counts.complex = result.solutions.size();
  letter(result.closures, search.phi);
}

}  // namespace moivre
