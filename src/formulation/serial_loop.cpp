// SPDX-License-Identifier: MIT
// A loop of ties as a chain of turns and slides, and where it is cut.
#include "serial_loop.h"

#include <algorithm>

#include "loop_equations.h"

namespace moivre {
namespace {

constexpr std::size_t kFewest = 3;
constexpr std::size_t kMost = 6;

/// The pose by numbers of double. Each is rounded once, from what it is exactly: axes that are
/// parallel or meet do so still, and what closes in a plane does not miss it by rounding.
ExactPose shortened(const ExactPose& pose) {
  const Rational half(1, 2);
  const Quaternion<Rational> exact = shift_of(pose);
  ExactPose shifted{{1, 0, 0, 0}, {}};
  for (std::size_t k = 1; k < exact.size(); ++k) {
    shifted.g[k] = half * Rational(to_double(exact[k]));
  }
  const Rational largest =
      *std::max_element(pose.q.begin(), pose.q.end(),
                        [](const Rational& x, const Rational& y) { return x * x < y * y; });
  Quaternion<double> turn;
  for (std::size_t k = 0; k < turn.size(); ++k) turn[k] = to_double(pose.q[k] / largest);
  return shifted * turn_by(turn);
}

/// The pose with a turn of which the largest part is 1.
ExactPose with_largest_one(const ExactPose& pose) {
  Rational largest = 0;
  for (const Rational& part : pose.q) {
    if (abs(largest) < abs(part)) largest = part;
  }
  return 1 / largest * pose;
}

/// Fractions that were typed stay so on their way round a loop, and need not be rounded: what is
/// special about the loop as typed is so of its equations. Products of rounded turns are longer.
bool is_short(const ExactPose& pose) {
  constexpr std::size_t kShort = 128;
  for (std::size_t k = 0; k < pose.size(); ++k) {
    if (bit_length(pose[k]) > kShort) return false;
  }
  return true;
}

/// A of a turn about the z axis of a frame, or of a slide along it.
ExactPose axis_at(const ExactPose& frame, bool is_turn) {
  const ExactPose z = is_turn ? ExactPose{{0, 0, 0, 1}, {}} : ExactPose{{}, {0, 0, 0, {1, 2}}};
  return 1 / norm(frame) * (frame * z * conjugate(frame));
}

/// Axes where all joints are at rest; without unknowns. Seen from the first joint: places far from
/// the origin would be rounded by more, and a loop that moves would not.
JointLoop at_rest(SpatialFrame& frame, const RigidGroups& groups, const std::vector<Tie>& loop) {
  const Quaternion<Rational> first = shift_of(loop.front().at_i);
  const Rational half(1, 2);
  const ExactPose origin{{1, 0, 0, 0}, {0, half * first[1], half * first[2], half * first[3]}};
  JointLoop joints;
  std::vector<ExactPose> frames;
  ExactPose at = conjugate(origin);
  for (const Tie& tie : loop) {
    for (const TieStep& step : steps_of(tie, true)) {
      if (step.kind == TieStep::Kind::fixed) {
        at = at * step.pose;
        continue;
      }
      const bool is_turn = step.kind == TieStep::Kind::turn;
      const bool is_last = &tie == &loop.back();
      frames.push_back(with_largest_one(at));
      joints.elements.push_back(
          {joints.elements.size(), {}, is_turn, step.name, groups.bodies[is_last ? tie.i : tie.j]});
    }
  }
  frames.push_back(with_largest_one(at * origin));
  const bool are_short = std::all_of(frames.begin(), frames.end(), is_short);
  if (!are_short || !groups.has_exact_frames) frame.note_rounding();
  if (!are_short) {
    for (ExactPose& near : frames) near = shortened(near);
  }
  for (LoopElement& element : joints.elements) {
    element.axis = axis_at(frames[element.number], element.is_turn);
  }
  joints.whole = conjugate(frames.back());
  return joints;
}

/// Slides are their own unknowns where they are to be linear; else infinity is brought to a finite
/// place.
void add_unknown(SpatialFrame& frame, bool has_linear_slides, LoopElement& element) {
  if (element.is_turn) {
    element.fixed = frame.random_number();
    element.unknown = frame.add_turn(element.name, element.owners);
  } else {
    if (!has_linear_slides) element.fixed = frame.random_number() / Rational(frame.length());
    element.unknown = frame.add_slide(element.name, element.fixed, element.owners);
  }
}

/// Where each group but the ground stands in the one before.
void place_groups(SpatialFrame& frame, const std::vector<Tie>& loop, const JointLoop& joints) {
  auto element = joints.elements.begin();
  for (std::size_t k = 0; k + 1 < loop.size(); ++k) {
    MovingPose pose = to_moving(ExactPose::identity());
    for (const TieStep& step : steps_of(loop[k], true)) {
      if (step.kind == TieStep::Kind::fixed) {
        pose = pose * to_moving(step.pose);
        continue;
      }
      pose = pose * (element->is_turn ? turn_of(element->unknown, element->fixed)
                                      : slide_of(element->unknown, element->fixed));
      ++element;
    }
    frame.place(loop[k].j, loop[k].i, pose);
  }
}

}  // namespace

std::optional<std::vector<Tie>> loop_of(const RigidGroups& groups, const Part& part) {
  std::vector<Tie> loop;
  std::vector<std::size_t> left = part.ties;
  std::size_t at = 0;
  std::size_t freedoms = 0;
  if (part.ties.size() != part.groups.size() + 1) return std::nullopt;
  do {
    const auto next = std::find_if(left.begin(), left.end(), [&](std::size_t k) {
      return groups.ties[k].i == at || groups.ties[k].j == at;
    });
    if (next == left.end()) return std::nullopt;
    const Tie& tie = groups.ties[*next];
    if (tie.turn == JointTurn::freely || tie.i == tie.j) return std::nullopt;
    loop.push_back(tie.i == at ? tie : reversed(tie));
    freedoms += freedom(tie);
    at = loop.back().j;
    left.erase(next);
  } while (at != 0);
  const bool is_driven = std::any_of(
      groups.driven_points.begin(), groups.driven_points.end(), [&](const auto& driven) {
        return std::find(part.groups.begin(), part.groups.end(), driven.group) != part.groups.end();
      });
  if (!left.empty() || is_driven || freedoms < kFewest || freedoms > kMost) return std::nullopt;
  return loop;
}

void add_loop(SpatialFrame& frame, const RigidGroups& groups, const std::vector<Tie>& loop) {
  JointLoop joints = at_rest(frame, groups, loop);
  // What is told from rounding by far.
  constexpr double kContradicts = 1e-8;
  const double left = turn_not_made_up(joints);
  if (left > kContradicts) {
    frame.add_contradiction(
        "a loop turns about two directions at most, which do not make up its turn", Rational(left));
  }
  LoopForm form = form_of(joints, frame.length());
  for (LoopElement& element : joints.elements) {
    add_unknown(frame, form.has_linear_slides, element);
  }
  place_groups(frame, loop, joints);
  for (LoopElement& element : form.loop.elements) {
    element.fixed = joints.elements[element.number].fixed;
    element.unknown = joints.elements[element.number].unknown;
  }
  form.add_equations(frame, form.loop);
}

}  // namespace moivre
