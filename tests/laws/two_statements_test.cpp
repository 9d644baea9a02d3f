// SPDX-License-Identifier: MIT
// A mechanism is stated twice, as Phi(q, t) and as closure polynomials: both vanish at the same
// poses, and at no others.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "../mechanism/files.h"
#include "moivre/closures/closures.h"
#include "moivre/formulation/formulation.h"
#include "moivre/kinematics/newton.h"
#include "moivre/mechanism/pose.h"
#include "moivre/tracker_lanes/lane_tracker.h"
#include "random_values.h"

namespace moivre {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using test::RandomValues;

constexpr double kVanishes = 1e-11;  // residuals beside the sizes of their terms

/// The pose q in isotropic coordinates: p = x + iy, t = exp(i phi), and their conjugates pb and u.
Point isotropic(const Formulation& formulation, const Mechanism& mechanism, const VectorXd& q) {
  Point point;
  for (const std::string& name : formulation.system.variables) {
    const std::size_t bar = name.find('_');
    const std::string kind = name.substr(0, bar);
    std::size_t body = 1;
    while (mechanism.bodies.at(body).name != name.substr(bar + 1)) ++body;
    const auto at = static_cast<Index>(3 * (body - 1));
    const Complex value = kind[0] == 'p' ? Complex(q[at], q[at + 1]) : std::polar(1.0, q[at + 2]);
    point.push_back(kind == "pb" || kind == "u" ? std::conj(value) : value);
  }
  return point;
}

/// Assembled at a random time, where Newton-Raphson comes to a pose from near the file's guess.
std::optional<VectorXd> random_pose(const Phi& phi, const Mechanism& mechanism,
                                    RandomValues& random, double& t) {
  t = random.between(0, 0.3);
  VectorXd guess = initial_guess(mechanism, t);
  const double size = std::max(1.0, guess.cwiseAbs().maxCoeff());
  for (Index k = 0; k < guess.size(); ++k) {
    guess[k] += (k % 3 == 2 ? 1 : size) * random.between(-0.5, 0.5);
  }
  const NewtonResult run = newton(phi, guess, t);
  if (run.status != NewtonStatus::converged || run.is_singular) return std::nullopt;
  return run.q;
}

const char* const kPlanar[] = {"four-bar",
                               "jansen-leg",
                               "watt-1",
                               "stephenson-3",
                               "slider-crank",
                               "inverted-slider-crank",
                               "whitworth",
                               "scotch-yoke",
                               "five-bar",
                               "gear-five-bar",
                               "3-rpr",
                               "crane",
                               "double-parallel-crank",
                               "assur-7-serial"};

TEST(TwoStatements, PolynomialsVanishAtEveryPoseWherePhiVanishes) {
  for (const char* name : kPlanar) {
    const Mechanism mechanism = test::example(name);
    const Phi phi(mechanism);
    int poses = 0;
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
      RandomValues random(seed);
      double t = 0;
      const auto q = random_pose(phi, mechanism, random, t);
      if (!q) continue;
      ++poses;
      const Formulation formulation = formulate(mechanism, t);
      const Point root = isotropic(formulation, mechanism, *q);
      EXPECT_LE(residual_of_root(formulation, root), kVanishes) << name << ", seed " << seed;
      EXPECT_LE((phi.canonical(coordinates_of_root(formulation, root)) - phi.canonical(*q)).norm(),
                1e-9 * std::max(1.0, q->norm()))
          << name << ", seed " << seed;
    }
    EXPECT_GE(poses, 1) << name;
  }
}

TEST(TwoStatements, NeitherVanishesBesideAPose) {
  for (const char* name : kPlanar) {
    const Mechanism mechanism = test::example(name);
    const Phi phi(mechanism);
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      RandomValues random(seed);
      double t = 0;
      const auto pose = random_pose(phi, mechanism, random, t);
      if (!pose) continue;
      VectorXd q = *pose;
      const double size = std::max(1.0, q.cwiseAbs().maxCoeff());
      // Drivers and angles stay: what holds an angle is put into the polynomials and cannot be
      // broken there.
      for (Index k = 0; k < q.size(); ++k) {
        if (k % 3 != 2) q[k] += 1e-3 * size * random.between(0.5, 1);
      }
      const Formulation formulation = formulate(mechanism, t);
      EXPECT_GE(scaled_residual(phi, q, t), 1e-6) << name;
      EXPECT_GE(residual_of_root(formulation, isotropic(formulation, mechanism, q)), 1e-6) << name;
    }
  }
}

TEST(TwoStatements, PhiVanishesAtEveryRealRootOfThePolynomials) {
  const auto tracker = make_lane_tracker();
  for (const char* name :
       {"four-bar", "jansen-leg", "stephenson-3", "whitworth", "gear-five-bar", "3-rpr", "rssr",
        "octahedral-3-3", "spherical-four-bar", "slider-crank-equations"}) {
    const Mechanism mechanism = test::example(name);
    const Phi phi(mechanism);
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      RandomValues random(seed);
      ClosureOptions options;
      options.time = mechanism.drivers.empty() ? 0 : random.between(0, 0.1);
      options.solve.seed = seed;
      options.solve.threads = 1;
      const Formulation formulation = formulate(mechanism, options.time);
      const ClosureResult result = find_closures(mechanism, *tracker, options);
      for (const Solution& root : result.solutions) {
        EXPECT_LE(residual_of_root(formulation, root.x), kVanishes) << name;
        if (!root.real || root.singular) continue;
        const VectorXd q = coordinates_of_root(formulation, root.x);
        EXPECT_LE(residual_by_size(phi, q, options.time), 1e-9) << name << ", seed " << seed;
      }
    }
  }
}

}  // namespace
}  // namespace moivre
