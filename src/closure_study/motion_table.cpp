// SPDX-License-Identifier: MIT
// The motion of one pose with finer and finer samples: closures at some of them, differences
// between all.
#include "moivre/closure_study/motion_table.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>

#include "moivre/closures/closures.h"
#include "moivre/kinematics/branch.h"
#include "moivre/study/cpu_time.h"

namespace moivre {
namespace {

constexpr int kFewestSamples = 50;
constexpr int kMostSamples = 6400;
// The five-point difference needs two samples on both sides.
constexpr std::size_t kReach = 2;
// Closures are solved so often, evenly spaced; a divisor of every number of samples.
constexpr int kCheckpoints = 10;
static_assert(kFewestSamples % kCheckpoints == 0);
// Of a branch that ends, so much is compared.
constexpr double kShareOfABranch = 0.75;

using Member = Eigen::VectorXd BranchSample::*;

std::vector<double> times_of(double duration, int count) {
  std::vector<double> times;
  for (int k = 0; k <= count; ++k) times.push_back(duration / count * k);
  return times;
}

/// Largest |difference| of the samples' `derivative` from the differences of `of`, over the largest
/// |derivative|.
double largest_difference(const std::vector<BranchSample>& samples, double h, Member of,
                          Member derivative) {
  double difference = 0;
  double size = 0;
  for (std::size_t k = kReach; k + kReach < samples.size(); ++k) {
    const Eigen::VectorXd slope = (samples[k - 2].*of - 8 * samples[k - 1].*of +
                                   8 * samples[k + 1].*of - samples[k + 2].*of) /
                                  (12 * h);
    difference = std::max(difference, (slope - samples[k].*derivative).cwiseAbs().maxCoeff());
    size = std::max(size, (samples[k].*derivative).cwiseAbs().maxCoeff());
  }
  return size > 0 ? difference / size : difference;
}

/// All closures at the checkpoints after the first, and how far a pose is from them.
class Checkpoints {
 public:
  Checkpoints(const Mechanism& mechanism, const Tracker& reference_tracker, double duration,
              const std::atomic<bool>& stop)
      : coordinates_(coordinates(mechanism)) {
    for (int k = 1; k <= kCheckpoints && !stop.load(); ++k) {
      ClosureOptions options;
      options.time = duration / kCheckpoints * k;
      options.certify = false;
      closures_.push_back(find_closures(mechanism, reference_tracker, options, stop).closures);
    }
  }

  /// Largest distance of the samples at the checkpoints from the nearest closure; `samples` has all
  /// of them.
  double error(const std::vector<BranchSample>& samples) const {
    const std::size_t stride = (samples.size() - 1) / closures_.size();
    double largest = 0;
    for (std::size_t k = 0; k < closures_.size(); ++k) {
      const Eigen::VectorXd& q = samples[(k + 1) * stride].q;
      double nearest = std::numeric_limits<double>::infinity();
      for (const Closure& closure : closures_[k]) {
        nearest = std::min(nearest, distance(q, closure.q));
      }
      largest = std::max(largest, nearest / std::max(1.0, q.cwiseAbs().maxCoeff()));
    }
    return largest;
  }

 private:
  /// Angles modulo whole turns.
  double distance(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const {
    double largest = 0;
    for (Eigen::Index i = 0; i < a.size(); ++i) {
      const bool is_angle = coordinates_[static_cast<std::size_t>(i)].kind == CoordinateKind::angle;
      const double gap = is_angle ? std::remainder(a[i] - b[i], 2 * std::numbers::pi) : a[i] - b[i];
      largest = std::max(largest, std::abs(gap));
    }
    return largest;
  }

  std::vector<Coordinate> coordinates_;
  std::vector<std::vector<Closure>> closures_;
};

bool moves(const Branch& branch) {
  return std::any_of(branch.samples.begin(), branch.samples.end(),
                     [](const BranchSample& sample) { return !sample.velocity.isZero(0); });
}

std::string seconds_text(double seconds) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g s", seconds);
  return text;
}

}  // namespace

StudyTable motion_table(const Mechanism& mechanism, const Eigen::VectorXd& q0, double duration,
                        const Tracker& reference_tracker, const std::atomic<bool>& stop) {
  StudyTable table;
  const Branch whole = follow_branch(mechanism, q0, times_of(duration, kFewestSamples), {}, stop);
  if (!moves(whole)) return table;
  const bool ends = whole.event.has_value();
  const double compared = ends ? kShareOfABranch * whole.event->time : duration;
  table.title = "motion of the first closure over " + seconds_text(compared) +
                (ends ? ", of a branch that ends at " + seconds_text(whole.event->time) : "");
  table.columns = {"samples", "cpu_s", "position_error", "velocity_error", "acceleration_error",
                   "residual"};
  const Checkpoints checkpoints(mechanism, reference_tracker, compared, stop);
  for (int count = kFewestSamples; count <= kMostSamples; count *= 2) {
    const std::vector<double> times = times_of(compared, count);
    Branch branch;
    const auto seconds = time_runs([&] { branch = follow_branch(mechanism, q0, times, {}, stop); });
    if (stop.load() || branch.samples.size() != times.size()) break;
    double residual = 0;
    for (const BranchSample& sample : branch.samples) {
      residual = std::max(residual, sample.residual);
    }
    const double h = compared / count;
    table.rows.push_back(
        {static_cast<double>(count), spread_of(seconds).median, checkpoints.error(branch.samples),
         largest_difference(branch.samples, h, &BranchSample::q, &BranchSample::velocity),
         largest_difference(branch.samples, h, &BranchSample::velocity,
                            &BranchSample::acceleration),
         residual});
  }
  return table;
}

}  // namespace moivre
