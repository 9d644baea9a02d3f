// SPDX-License-Identifier: MIT
// Are paths followed that pass close by a singular point, and one that goes to 1e12 and comes back?
// Both known in closed form.
//
//   near:    H = x^2 + (t - 1/2) + i e    x(t) = +-sqrt(1/2 - t - i e); singular at t = 1/2 - i e,
//                                         x = 0
//   growth:  H = (t - 1/2 + i e) x - 1    x(t) = 1 / (t - 1/2 + i e), of size 1/e at t = 1/2
#include <gtest/gtest.h>

#include "moivre/polynomial/read.h"
#include "moivre/tracker/session.h"
#include "moivre/tracker_cvode/cvode_tracker.h"
#include "moivre/tracker_lanes/lane_tracker.h"

namespace moivre {
namespace {

/// Ends are corrected to 1e-9 and less (tracker/path_system.h).
constexpr double kArrived = 1e-8;
const std::vector<std::string> kDistances{"1e-4", "1e-8", "1e-12"};

System equation(const std::string& text) { return read_system({"test", "1\n" + text + ";\n"}); }

/// The ends of segments from `starts`, t from 0 to 1; nothing where a segment did not arrive.
std::vector<std::optional<Complex>> ends(const Tracker& tracker, const Homotopy& homotopy,
                                         const std::vector<Complex>& starts) {
  const auto session = tracker.open(homotopy);
  const std::atomic<bool> stop{false};
  std::vector<std::optional<Complex>> found;
  for (const Complex& start : starts) {
    const SegmentResult reached =
        follow(*session, {found.size(), Contour::segment(0, 1), {start, 1.0}, 0, 0, nullptr}, stop);
    found.push_back(reached.status == SegmentStatus::arrived
                        ? std::optional<Complex>(reached.x[0] / reached.x[1])
                        : std::nullopt);
  }
  return found;
}

struct NearSingular {
  explicit NearSingular(const std::string& e)
      : homotopy(equation("x^2 + 1/2 + " + e + "*i"), equation("x^2 - 1/2 + " + e + "*i")),
        start(std::sqrt(Complex(0.5, -std::stod(e)))),
        end(std::sqrt(Complex(-0.5, -std::stod(e)))) {}

  Homotopy homotopy;
  Complex start;
  Complex end;
};

/// Both paths arrive where they should.
void expect_followed(const Tracker& tracker, const std::string& e) {
  SCOPED_TRACE(tracker.kind() + ", distance " + e);
  const NearSingular scene(e);
  const auto found = ends(tracker, scene.homotopy, {scene.start, -scene.start});
  ASSERT_TRUE(found[0] && found[1]);
  EXPECT_LT(std::abs(*found[0] - scene.end), kArrived);
  EXPECT_LT(std::abs(*found[1] + scene.end), kArrived);
}

TEST(NearSingularPath, IsFollowedByCvodeWithProjectionAndBothIterations) {
  for (const CvodeIteration iteration : {CvodeIteration::fixed_point, CvodeIteration::newton}) {
    SCOPED_TRACE(to_string(iteration));
    const auto tracker = make_cvode_tracker({.iteration = iteration});
    for (const std::string& e : kDistances) expect_followed(*tracker, e);
  }
}

TEST(NearSingularPath, IsFollowedInLanes) {
  const auto tracker = make_lane_tracker();
  for (const std::string& e : kDistances) expect_followed(*tracker, e);
}

/// Without projection an integrator may come to the other root, or fail, but to no point that is no
/// root.
TEST(NearSingularPath, EndsAtARootOrFailsWithoutProjection) {
  for (const CvodeMethod method : {CvodeMethod::bdf, CvodeMethod::adams}) {
    for (const CvodeIteration iteration : {CvodeIteration::fixed_point, CvodeIteration::newton}) {
      const auto tracker =
          make_cvode_tracker({.method = method, .iteration = iteration, .rtol = 1e-6});
      for (const std::string& e : kDistances) {
        SCOPED_TRACE(to_string(method) + ", " + to_string(iteration) + ", " + e);
        const NearSingular scene(e);
        for (const auto& end : ends(*tracker, scene.homotopy, {scene.start, -scene.start})) {
          if (!end) continue;
          EXPECT_LT(std::min(std::abs(*end - scene.end), std::abs(*end + scene.end)), kArrived);
        }
      }
    }
  }
}

TEST(GrowingPath, GoesToTenToTheTwelveAndComesBack) {
  const Homotopy homotopy(equation("(1/2 + 1e-12*i)*x - 1"), equation("(-1/2 + 1e-12*i)*x - 1"));
  const Complex start = 1.0 / Complex(-0.5, 1e-12);
  const Complex end = 1.0 / Complex(0.5, 1e-12);
  for (const auto& tracker : {make_cvode_tracker(), make_lane_tracker()}) {
    SCOPED_TRACE(tracker->kind());
    const auto found = ends(*tracker, homotopy, {start});
    ASSERT_TRUE(found[0]);
    EXPECT_LT(std::abs(*found[0] - end), kArrived);
  }
}

}  // namespace
}  // namespace moivre
