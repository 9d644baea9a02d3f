// SPDX-License-Identifier: MIT
// The motion of one pose with finer and finer samples, and the differences between them.
#include "moivre/closure_study/motion_table.h"

#include <algorithm>
#include <cmath>

#include "moivre/kinematics/branch.h"
#include "moivre/study/cpu_time.h"

namespace moivre {
namespace {

constexpr int kFewestSamples = 50;
constexpr int kMostSamples = 800;
// The five-point difference needs two samples on both sides.
constexpr std::size_t kReach = 2;

using Member = Eigen::VectorXd BranchSample::*;

/// Largest difference between `derivative` and the differences of `of`, relative to the largest |derivative|.
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

}  // namespace

StudyTable motion_table(const Mechanism& mechanism, const Eigen::VectorXd& q0, double duration,
                        const std::atomic<bool>& stop) {
  StudyTable table{"motion of the first closure over " + std::to_string(duration) + " s",
                   {"samples", "cpu_s", "velocity_error", "acceleration_error", "residual"},
                   {}};
  for (int count = kFewestSamples; count <= kMostSamples; count *= 2) {
    const double h = duration / count;
    std::vector<double> times;
    for (int k = 0; k <= count; ++k) times.push_back(h * k);
    Branch branch;
    const auto seconds = time_runs([&] { branch = follow_branch(mechanism, q0, times, {}, stop); });
    if (stop.load() || branch.samples.size() <= 2 * kReach) break;
    double residual = 0;
    for (const BranchSample& sample : branch.samples) {
      residual = std::max(residual, sample.residual);
    }
    table.rows.push_back(
        {static_cast<double>(branch.samples.size() - 1), spread_of(seconds).median,
         largest_difference(branch.samples, h, &BranchSample::q, &BranchSample::velocity),
         largest_difference(branch.samples, h, &BranchSample::velocity,
                            &BranchSample::acceleration),
         residual});
  }
  return table;
}

}  // namespace moivre
