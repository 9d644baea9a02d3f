// SPDX-License-Identifier: MIT
// Does what a callback throws end the run and come to the caller, on any number of threads and with
// every tracker?
#include <stdexcept>

#include "moivre/arms/arm_closures.h"
#include "moivre/family/learn.h"
#include "moivre/family/members.h"
#include "moivre/mechanism/dimensions.h"
#include "moivre/mechanism/read.h"
#include "moivre/motion/motion.h"
#include "moivre/solver/solve.h"
#include "moivre/sweep/sweep.h"
#include "moivre/urdf/read.h"
#include "refused.h"

namespace moivre::test {
namespace {

/// What a user's own code throws.
struct Enough : std::runtime_error {
  Enough() : std::runtime_error("enough") {}
};

/// Throws when it is called for the k-th time, and counts.
template <class... Arguments>
std::function<void(Arguments...)> throwing_at(int k, int& calls) {
  return [k, &calls](Arguments...) {
    if (++calls == k) throw Enough();
  };
}

/// Of 2^n paths, so that there is something to be cut short.
System circles(std::size_t n) {
  const std::vector<Polynomial> x = unknowns(n);
  std::vector<std::string> names;
  std::vector<Polynomial> equations;
  for (std::size_t j = 0; j < n; ++j) {
    names.push_back("x" + std::to_string(j));
    equations.push_back(x[j] * x[j] + x[(j + 1) % n] * 3 - static_cast<int>(j) - 2);
  }
  return make_system(names, equations);
}

TEST(CallbackTest, ProgressThatThrowsEndsASolve) {
  const System f = circles(6);
  const auto cvode = make_cvode_tracker();
  const auto lanes = make_lane_tracker();
  for (const Tracker* tracker : {cvode.get(), lanes.get()}) {
    for (const int threads : {1, 4}) {
      for (const int k : {1, 5, 30}) {
        int calls = 0;
        SolveOptions options;
        options.threads = threads;
        options.progress = throwing_at<const Progress&>(k, calls);
        EXPECT_THROW(solve(f, *tracker, options), Enough);
        EXPECT_EQ(calls, k) << "it is not called again";
        options.progress = {};
        EXPECT_EQ(solve(f, *tracker, options).solutions.size(), 64U);
      }
    }
  }
}

TEST(CallbackTest, ProgressThatThrowsEndsAPolyhedralSolveAndItsSearchForCells) {
  const System f = circles(5);
  const auto tracker = make_cvode_tracker();
  SolveOptions options;
  options.start = StartKind::polyhedral;
  options.threads = 3;
  int calls = 0;
  options.progress = throwing_at<const Progress&>(1, calls);
  EXPECT_THROW(solve(f, *tracker, options), Enough);
  EXPECT_EQ(calls, 1);
}

Family unlearned_square_root() {
  const auto [x, p] = unknowns<2>();
  return unlearned_family(make_system({"x", "p"}, {x * x - p}), {{"p", 1}});
}

TEST(CallbackTest, ProgressThatThrowsEndsTheSolveOfMembers) {
  const auto tracker = make_lane_tracker();
  const Family family = learn(unlearned_square_root(), *tracker);
  std::vector<Point> members;
  for (int k = 1; k <= 300; ++k) members.push_back({Complex(k)});
  members[17] = {Complex(0)};  // a double root, which is judged by itself
  for (const int threads : {1, 4}) {
    for (const int k : {1, 100, 300}) {
      int calls = 0;
      SolveOptions options;
      options.threads = threads;
      options.progress = throwing_at<const Progress&>(k, calls);
      EXPECT_THROW(solve_members(family, members, *tracker, options), Enough);
      EXPECT_EQ(calls, k);
    }
  }
}

TEST(CallbackTest, ProgressThatThrowsEndsMonodromy) {
  const auto tracker = make_lane_tracker();
  int calls = 0;
  MonodromyOptions options;
  options.progress = throwing_at<const LoopProgress&>(2, calls);
  EXPECT_THROW(learn_by_monodromy(unlearned_square_root(), {{1.0}, {1.0}}, *tracker, options),
               Enough);
  EXPECT_EQ(calls, 2);
}

TEST(CallbackTest, ProgressThatThrowsEndsManyPoses) {
  const Arm arm =
      make_arm(read_urdf(read_source(MOIVRE_SOURCE_DIR "/problems/robots/puma560.urdf")), {});
  std::vector<Eigen::Isometry3d> poses;
  for (int k = 0; k < 40; ++k) {
    poses.push_back(forward_kinematics(arm, Eigen::VectorXd::Constant(6, 0.3 + 0.01 * k)));
  }
  const auto tracker = make_lane_tracker();
  for (const int threads : {1, 4}) {
    int calls = 0;
    SolveOptions options;
    options.threads = threads;
    options.progress = throwing_at<const Progress&>(3, calls);
    EXPECT_THROW(find_arm_closures(arm, poses, *tracker, options), Enough);
    EXPECT_EQ(calls, 3);
  }
}

TEST(CallbackTest, ProgressThatThrowsEndsAMotionAndASweep) {
  const Mechanism mechanism =
      read_mechanism(read_source(MOIVRE_SOURCE_DIR "/problems/mechanisms/four-bar.toml"));
  const auto tracker = make_cvode_tracker();
  int calls = 0;
  MotionOptions motion;
  motion.progress = throwing_at<double>(2, calls);
  EXPECT_THROW(find_motion(mechanism, *tracker, motion), Enough);
  EXPECT_EQ(calls, 2);
  for (const int threads : {1, 4}) {
    calls = 0;
    FamilyBook book;
    SweepOptions options;
    options.closures.solve.threads = threads;
    options.progress = throwing_at<std::size_t, std::size_t>(2, calls);
    const std::string name = dimension_names(mechanism).front();
    EXPECT_THROW(sweep(mechanism, {{name, 1, 5, 9}}, *tracker, book, options), Enough);
    EXPECT_EQ(calls, 2);
  }
}

}  // namespace
}  // namespace moivre::test
