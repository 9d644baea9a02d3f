// SPDX-License-Identifier: MIT
// Least squares from many sides, each come to once.
#include "fitted_poses.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "closure_poses.h"
#include "moivre/closures/same_pose.h"
#include "moivre/factorization/svd.h"
#include "moivre/kinematics/least_squares.h"
#include "moivre/mechanism/joint_type.h"
#include "moivre/mechanism/pose.h"
#include "moivre/mechanism/spins.h"
#include "moving_pose.h"
#include "within_fit.h"

namespace moivre {
namespace {

using Eigen::VectorXd;

// Runs that come to nothing new before no more are made: some, and two for each pose that was new.
constexpr std::uint64_t kIdleRuns = 24;
constexpr std::uint64_t kIdleRunsEach = 2;
constexpr std::uint64_t kMostRuns = 200;

WithinFit within_fit(const ClosureSearch& search) {
  return {search.phi, search.mechanism.fit.value_or(0), search.options.time};
}

/// Half of what teeth are apart, in radians, where they are the finest.
double half_tooth(const Mechanism& mechanism) {
  int most = 1;
  for (const Joint& joint : mechanism.joints) {
    if (!is_transmission(joint.type)) continue;
    most = std::max({most, joint.gear.teeth[0], joint.gear.teeth[1]});
  }
  return std::numbers::pi / most;
}

/// Whether bodies whose angle is known, or is so beside another body's, stand so: where teeth leave
/// the way free, least squares may come to rest in another meshing than the drawn one.
bool is_as_meshed(const ClosureSearch& search, const VectorXd& q) {
  if (!has_gears(search.mechanism)) return true;
  const double most = half_tooth(search.mechanism);
  // Of each unknown direction, and of none: how far it is from the first body that has it.
  std::map<Monomial, double> turned{{Monomial(), 0.0}};
  const auto& readings = search.formulation.coordinates;
  for (std::size_t k = 0; k < readings.size(); ++k) {
    const Formulation::Reading& reading = readings[k];
    const bool is_direction = reading.part == Formulation::Reading::Part::argument && !reading.f;
    if (!is_direction || reading.of.terms.size() != 1) continue;
    const Term& term = reading.of.terms.front();
    const double beyond = q[static_cast<Eigen::Index>(k)] - std::arg(to_complex(term.coefficient));
    const double first = turned.try_emplace(term.monomial, beyond).first->second;
    if (std::abs(std::remainder(beyond - first, 2 * std::numbers::pi)) > most) return false;
  }
  return true;
}

/// Whether the pose is one of these, or hangs together with it.
bool is_one_of(const ClosureSearch& search, const std::vector<Closure>& poses, const VectorXd& q) {
  const WithinFit within = within_fit(search);
  const bool is_weak = within.is_weak(q);
  return std::any_of(poses.begin(), poses.end(), [&](const Closure& other) {
    return is_same_pose(search.phi, other.q, q) || (is_weak && within.joins(q, other.q));
  });
}

}  // namespace

NewtonResult settled(const ClosureSearch& search, const VectorXd& guess) {
  // Quadratic from there, or slow at a fold.
  constexpr int kIterations = 8;
  const double t = search.options.time;
  if (!search.mechanism.fit) return newton(search.phi, guess, t);
  NewtonResult run;
  run.q = least_squares_pose(search.phi, guess, t);
  if (!run.q.allFinite()) return run;
  const WithinFit within = within_fit(search);
  const auto tell_least = [&] {
    run.smallest_singular_value = singular_values(search.phi.jacobian(run.q, t)).tail(1)[0];
    return run;
  };
  run.iterations.resize(1);
  // Where least squares leave more than fit to some row no root is near.
  if (!within.has(run.q)) return within.enter(run.q) ? tell_least() : run;
  NewtonOptions options;
  options.maximum_iterations = kIterations;
  NewtonResult polished = newton(search.phi, run.q, t, options);
  const bool is_settled = polished.q.allFinite() && (polished.status == NewtonStatus::converged ||
                                                     polished.status == NewtonStatus::no_solution);
  if (is_settled && distance(search.phi, polished.q, run.q) <= kSamePlace) return polished;
  run.iterations = std::move(polished.iterations);
  return tell_least();
}

bool hang_together(const ClosureSearch& search, const VectorXd& a, const VectorXd& b) {
  const WithinFit within = within_fit(search);
  return within.is_weak(a) && within.has(a) && within.joins(a, b);
}

bool take_fitted(ClosureSearch& search, const NewtonResult& least) {
  const std::optional<double>& fit = search.mechanism.fit;
  if (!fit || !least.q.allFinite()) return false;
  Closure closure = closure_at(search, least);
  if (!(closure.misfit <= *fit) || !is_as_meshed(search, closure.q)) return false;
  if (is_one_of(search, search.result.closures, closure.q)) return false;
  if (is_one_of(search, search.fitted_beyond_limits, closure.q)) return false;
  if (!is_allowed(search, closure.q)) {
    search.fitted_beyond_limits.push_back(std::move(closure));
    ++search.result.fitted_beyond_limits;
    return false;
  }
  ++search.result.counts.fitted;
  closure.is_fitted = true;
  search.result.closures.push_back(std::move(closure));
  return true;
}

void look_for_fitted(ClosureSearch& search) {
  // A pose may be in another meshing of the teeth than the drawn one.
  if (!search.mechanism.fit || has_gears(search.mechanism)) return;
  const WithinFit within = within_fit(search);
  const VectorXd guess = initial_guess(search.mechanism, search.options.time);
  const System& f = search.formulation.system;
  const bool has_spare = f.polynomials.size() > f.variables.size();
  std::uint64_t found = 0;
  std::uint64_t idle = 0;
  for (std::uint64_t k = 0; k < kMostRuns && idle < kIdleRuns + kIdleRunsEach * found; ++k) {
    if (search.stop) return;
    // Behind those of moving_pose() and of the witness.
    const VectorXd start =
        k == 0 ? guess
               : random_pose(search.phi, guess, search.options.solve.seed, 2 * kMovingStarts + k);
    const NewtonResult least = settled(search, start);
    ++idle;
    if (!least.q.allFinite() || is_at_root(search, least)) continue;
    if (!are_spins_as_meant(search.mechanism, least.q) || !take_fitted(search, least)) continue;
    ++found;
    idle = 0;
    const bool is_lost = within.is_beside_roots(search.result.closures.back().q);
    if (is_lost || (has_spare && !search.is_combined)) ++search.rootless;
  }
}

void measure_play(ClosureSearch& search) {
  if (!search.mechanism.fit) return;
  const WithinFit within = within_fit(search);
  for (Closure& closure : search.result.closures) closure.play = within.play(closure.q);
}

}  // namespace moivre
