// SPDX-License-Identifier: MIT
// Where a loop is cut, and the equations of the cut.
#include "loop_equations.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>

#include "dyad.h"
#include "four_turns.h"

namespace moivre {
namespace {

constexpr std::size_t kSix = 6;
constexpr std::size_t kTurnsOfSpace = 3;

/// How a loop of six is cut: which way round, from which joint, and whether its last three joints
/// stay in one 3-space.
struct Cut {
  JointLoop loop;
  bool has_common_space = false;
  double merit = -1;
};

// A dyad whose 3-space is nearer to Study's quadric than this lies in it: its axes meet or are
// parallel.
constexpr double kOnQuadric = 1e-10;

// Directions farther apart than this are not one: what a dozen frames leave of rounding.
constexpr double kParallel = 1e-13;

Eigen::Vector3d direction_of(const ExactPose& axis) {
  const Quaternion<double> q = to_double(axis).q;
  return Eigen::Vector3d(q[1], q[2], q[3]).normalized();
}

bool lies_on_quadric(const LoopElement& a, const LoopElement& b, double length) {
  return distance_from_quadric(a, b, length) <= kOnQuadric;
}

Cut best_cut(const JointLoop& loop, double length) {
  Cut best;
  for (JointLoop& way : all_ways(loop)) {
    const auto& e = way.elements;
    const double inner = distance_from_quadric(e[1], e[2], length);
    // Two slides in a row span a plane of displacements, too few for the coordinates of a dyad.
    const bool is_dyad = e[4].is_turn || e[5].is_turn;
    // Four paths and two for each beat any other cut. Without an inner dyad there is an equation
    // too many: better than none.
    const bool decouples = is_dyad && spans_common_space(e[3], e[4], e[5], length) &&
                           !spans_common_space(e[0], e[1], e[2], length);
    double merit = distance_from_quadric(e[4], e[5], length);
    if (decouples) merit = inner > kOnQuadric ? 2 + inner : kOnQuadric;
    if (merit > best.merit) best = {std::move(way), decouples, merit};
  }
  return best;
}

/// Dyads of two slides among those that are used of three to five elements: A B = 0 there, and they
/// span no 3-space.
int flat_dyads(const JointLoop& loop) {
  const auto& e = loop.elements;
  const auto is_flat = [&](std::size_t k) { return !e[k].is_turn && !e[k + 1].is_turn; };
  const std::size_t last = e.size() - 2;
  const bool has_inner = last == 3;
  return (is_flat(last) ? 1 : 0) + (has_inner && is_flat(1) ? 1 : 0);
}

/// Begun where few dyads are flat; as it is where none is.
JointLoop short_cut(const JointLoop& loop) {
  const std::vector<JointLoop> ways = all_ways(loop);
  return *std::min_element(ways.begin(), ways.end(), [](const JointLoop& a, const JointLoop& b) {
    return flat_dyads(a) < flat_dyads(b);
  });
}

class LoopEquations {
 public:
  LoopEquations(SpatialFrame& frame, const JointLoop& loop) : frame_(frame), loop_(loop) {}

  /// E_1 E_2 E_3 E_4 in the space of 5 and 6.
  void add_general() {
    const DyadSpace outer = dyad_at(4);
    const MovingPose rest = rest_behind(element(0) * element(1) * element(2) * element(3));
    in_space(rest, outer);
    const std::array<Polynomial, 4> c = coordinates_in(outer, rest);
    if (lies_on_quadric(e(4), e(5), frame_.length())) {
      add_quadric(frame_, e(4), c);
    } else {
      bound_closures();
    }
    add_half_angles(frame_, e(4), e(5), c);
  }

  /// E_1, or E_1 E_2, or E_1 D_23 in the space of the last two, where they need not be on its
  /// quadric; of six elements E_1 D_23 in the space of the last three, which E_4 does not leave, or
  /// E_1 E_2 E_3 where D says too little. Of five elements the four equations of the space, which
  /// come first, have 4 paths alone, and D's quadric is a check; of six it holds, since the space
  /// lies in Study's.
  void add_by_dyads() {
    const std::size_t last = loop_.elements.size() - 2;
    const DyadSpace outer = dyad_at(last);
    MovingPose before = element(0);
    std::array<Polynomial, 4> inner;
    const bool has_dyad = last == 3 || (last == 4 && !lies_on_quadric(e(1), e(2), frame_.length()));
    if (has_dyad) {
      inner = add_inner_dyad();
      before = before * pose_in(dyad_at(1), inner);
    } else {
      for (std::size_t k = 1; k < std::min<std::size_t>(last, 3); ++k) before = before * element(k);
    }
    const MovingPose rest = rest_behind(before);
    in_space(rest, outer);
    if (last == 3) add_quadric(frame_, e(1), inner);
    const auto c = coordinates_in(outer, last == 4 ? conjugate(element(3)) * rest : rest);
    add_quadric(frame_, e(last), c);
    add_half_angles(frame_, e(last), e(last + 1), c);
  }

  /// Three turns and three slides: the turns alone close like a spherical loop, and then the slides
  /// are linear.
  void add_turns_first() {
    JointLoop turns{{}, {loop_.whole.q, {}}};
    for (LoopElement element : loop_.elements) {
      if (!element.is_turn) continue;
      element.axis.g = {};
      turns.elements.push_back(std::move(element));
    }
    LoopEquations(frame_, turns).add_by_dyads();
    add_shift();
  }

  /// Slides alone turn nothing: what turns once round the loop must stand, and the slides are
  /// linear.
  void add_slides() {
    constexpr double kTurned = 1;
    for (std::size_t k = 1; k < loop_.whole.q.size(); ++k) {
      frame_.add_equation("loop", without_noise(to_moving(loop_.whole).q[k], kTurned));
    }
    add_shift();
  }

 private:
  const LoopElement& e(std::size_t k) const { return loop_.elements[k]; }
  MovingPose element(std::size_t k) const { return element_pose(e(k)); }
  MovingPose whole() const { return to_moving(loop_.whole); }
  DyadSpace dyad_at(std::size_t k) const { return dyad_space(e(k), e(k + 1), frame_.length()); }

  /// A general loop of six turns has 16 closures [LeeLiang88], and so none has more that are
  /// isolated; a slide is a turn about a line at infinity. The outer dyad has one pair of angles
  /// for each.
  void bound_closures() {
    constexpr std::uint64_t kMostClosures = 16;
    Formulation::Bound bound{"a loop of six joints", {}, kMostClosures};
    for (std::size_t k = 0; k < 4; ++k) {
      bound.unknowns.push_back(e(k).unknown.terms.front().monomial.front().variable);
    }
    std::sort(bound.unknowns.begin(), bound.unknowns.end());
    frame_.bound(std::move(bound));
  }

  /// What the other elements have to be, which close the loop: whole^-1 before = conj(rest).
  MovingPose rest_behind(const MovingPose& before) const {
    return conjugate(conjugate(whole()) * before);
  }

  /// Unknown coordinates for the dyad of elements 1 and 2, with their half angles.
  std::array<Polynomial, 4> add_inner_dyad() {
    const std::array<Polynomial, 4> c = add_dyad_coordinates(frame_, e(1), e(2));
    add_half_angles(frame_, e(1), e(2), c);
    return c;
  }

  /// Where axes meet in a point all shifts cancel, and each part is rounding of what a shift of the
  /// mechanism's length would give.
  void in_space(const MovingPose& pose, const DyadSpace& space) {
    double turn = 0;
    for (const Polynomial& p : pose.q) turn = std::max(turn, largest_coefficient(p));
    for (const ExactPose& normal : space.normals) {
      Polynomial sum;
      double size = 0;
      for (std::size_t k = 0; k < pose.size(); ++k) {
        const Polynomial part = Coefficient{normal[k], 0} * pose[k];
        const double whole = turn * (k < 4 ? 1 : frame_.length());
        size = std::max({size, largest_coefficient(part), std::abs(to_double(normal[k])) * whole});
        sum = sum + part;
      }
      frame_.add_equation("loop", frame_.without_rounding(std::move(sum), size));
    }
  }

  /// The loop's displacement is none, where its turn is none.
  void add_shift() {
    MovingPose rest = conjugate(whole());
    for (std::size_t k = 0; k < loop_.elements.size(); ++k) rest = rest * element(k);
    const char* const parts[] = {"x", "y", "z"};
    for (std::size_t k = 0; k < std::size(parts); ++k) {
      frame_.add_equation(std::string("loop: ") + parts[k], rest.g[k + 1]);
    }
  }

  SpatialFrame& frame_;
  const JointLoop& loop_;
};

template <void (LoopEquations::*Add)()>
void stated(SpatialFrame& frame, const JointLoop& loop) {
  (LoopEquations(frame, loop).*Add)();
}

}  // namespace

double turn_not_made_up(const JointLoop& loop) {
  double most = 0;
  for (const JointLoop& way : all_ways(loop)) {
    std::vector<Eigen::Vector3d> directions;
    for (const std::size_t k : turns_of(way)) {
      const Eigen::Vector3d direction = direction_of(way.elements[k].axis);
      const bool is_new =
          directions.empty() || directions.back().cross(direction).norm() > kParallel;
      if (is_new) directions.push_back(direction);
    }
    if (directions.empty() || directions.size() > 2) continue;
    const Quaternion<double> q = to_double(way.whole).q;
    const Eigen::Quaterniond whole = Eigen::Quaterniond(q[0], q[1], q[2], q[3]).normalized();
    const Eigen::Vector3d& a = directions.front();
    const Eigen::Vector3d& b = directions.back();
    const Eigen::Vector3d turned = whole * b;
    // A single turn leaves its own direction; two leave the angle between theirs.
    const double left = directions.size() == 1 ? (turned - b).norm() : std::abs(a.dot(turned - b));
    most = std::max(most, left);
  }
  return most;
}

LoopForm form_of(const JointLoop& loop, double length) {
  const std::size_t turns = turns_of(loop).size();
  if (turns == 0) return {loop, true, stated<&LoopEquations::add_slides>};
  if (loop.elements.size() < kSix) {
    return {short_cut(loop), false, stated<&LoopEquations::add_by_dyads>};
  }
  if (turns == kTurnsOfSpace) return {loop, true, stated<&LoopEquations::add_turns_first>};
  Cut cut = best_cut(loop, length);
  if (cut.has_common_space) {
    return {std::move(cut.loop), false, stated<&LoopEquations::add_by_dyads>};
  }
  if (auto begun = begun_with_slide(loop)) return {std::move(*begun), true, add_four_turns};
  return {std::move(cut.loop), false, stated<&LoopEquations::add_general>};
}

}  // namespace moivre
