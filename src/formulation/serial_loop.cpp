// SPDX-License-Identifier: MIT
// A loop of ties as a chain of turns and slides, and where it is cut.
#include "serial_loop.h"

#include <algorithm>

#include "loop_equations.h"

namespace moivre {
namespace {

constexpr std::size_t kFewest = 3;
constexpr std::size_t kMost = 6;

/// A shift by numbers of double.
ExactPose rounded_shift(const Quaternion<Rational>& exact) {
  const Rational half(1, 2);
  ExactPose shift{{1, 0, 0, 0}, {}};
  for (std::size_t k = 1; k < exact.size(); ++k) {
    shift.g[k] = half * Rational(to_double(exact[k]));
  }
  return shift;
}

/// The pose by numbers of double, each rounded once, from what it is exactly: what closes in a
/// plane does not miss it by rounding.
ExactPose shortened(const ExactPose& pose) {
  const Rational largest =
      *std::max_element(pose.q.begin(), pose.q.end(),
                        [](const Rational& x, const Rational& y) { return x * x < y * y; });
  Quaternion<double> turn;
  for (std::size_t k = 0; k < turn.size(); ++k) turn[k] = to_double(pose.q[k] / largest);
  return rounded_shift(shift_of(pose)) * turn_by(turn);
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

/// The line of a joint: the z axis of a frame, whichever way the frame is turned about it.
struct Line {
  /// Turns z to the line, about an axis across z: of parallel lines one. Lines look upwards, those
  /// that look down are reversed.
  Quaternion<Rational> turn;
  bool is_reversed = false;
  Quaternion<Rational> place;  ///< of a point on it
};

Line line_of(const ExactPose& frame) {
  const auto tilt_of = [](const Quaternion<Rational>& q) {
    return std::array<Rational, 2>{q[1] * q[3] + q[0] * q[2], q[2] * q[3] - q[0] * q[1]};
  };
  const Rational zero(0);
  Quaternion<Rational> q = frame.q;
  const Rational up = q[0] * q[0] + q[3] * q[3] - q[1] * q[1] - q[2] * q[2];
  const auto [x, y] = tilt_of(q);
  Line line;
  line.place = shift_of(frame);
  line.is_reversed = up != zero ? up < zero : y != zero ? y < zero : x < zero;
  if (line.is_reversed) q = product(q, Quaternion<Rational>{0, 1, 0, 0});
  const Rational scale = 1 / (q[0] * q[0] + q[3] * q[3]);
  const auto tilt = tilt_of(q);
  line.turn = {1, -scale * tilt[1], scale * tilt[0], 0};
  return line;
}

/// Whether two parallel lines are one.
bool passes_through(const Line& line, const Quaternion<Rational>& place) {
  Quaternion<Rational> apart = place;
  for (std::size_t k = 0; k < apart.size(); ++k) apart[k] -= line.place[k];
  // Turned back it is along z.
  const auto turned = product(product(conjugate(line.turn), apart), line.turn);
  return turned[1].is_zero() && turned[2].is_zero();
}

/// The frames' z axes by numbers of double, each line rounded once: what is parallel, meets at a
/// joint's place or is one line does and is so still.
std::vector<ExactPose> shortened_axes(const std::vector<ExactPose>& frames) {
  std::vector<Line> lines;
  std::vector<ExactPose> axes;
  for (const ExactPose& frame : frames) {
    Line line = line_of(frame);
    const auto same = std::find_if(lines.begin(), lines.end(), [&](const Line& other) {
      return other.turn == line.turn && passes_through(other, line.place);
    });
    if (same != lines.end()) line.place = same->place;
    Quaternion<double> turn;
    for (std::size_t k = 0; k < turn.size(); ++k) turn[k] = to_double(line.turn[k]);
    axes.push_back(rounded_shift(line.place) * turn_by(turn));
    if (line.is_reversed) axes.back() = axes.back() * ExactPose{{0, 1, 0, 0}, {}};
    lines.push_back(std::move(line));
  }
  return axes;
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
  ExactPose whole = with_largest_one(at * origin);
  const bool are_short = is_short(whole) && std::all_of(frames.begin(), frames.end(), is_short);
  if (!are_short || !groups.has_exact_frames) frame.note_rounding();
  if (!are_short) {
    whole = shortened(whole);
    frames = shortened_axes(frames);
  }
  for (LoopElement& element : joints.elements) {
    element.axis = axis_at(frames[element.number], element.is_turn);
  }
  joints.whole = conjugate(whole);
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
  // Far above rounding.
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
