// SPDX-License-Identifier: MIT
// Unknowns of ties, and what ties ask of a relative pose.
#include "spatial_frame.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "moivre/numeric/random.h"

namespace moivre {
namespace {

// The formulation of a mechanism is one, whatever seed solves it.
constexpr std::uint64_t kSeed = 1;

}  // namespace

Polynomial without_noise(Polynomial p, double size) {
  // What is left of terms that were to cancel: frames are right to 50 bits, and a product of a
  // dozen of them to 45.
  constexpr double kNoise = 1e-13;
  const auto is_noise = [&](const Term& term) {
    return std::abs(to_complex(term.coefficient)) <= kNoise * size;
  };
  p.terms.erase(std::remove_if(p.terms.begin(), p.terms.end(), is_noise), p.terms.end());
  return p;
}

Polynomial real_constant(const Rational& c) {
  return c.is_zero() ? Polynomial{} : constant({c, 0});
}

MovingPose to_moving(const ExactPose& pose) { return mapped(pose, real_constant); }

Polynomial SpatialFrame::without_rounding(Polynomial p, double size) {
  const std::size_t terms = p.terms.size();
  p = without_noise(std::move(p), size);
  if (p.terms.size() < terms) note_dropped();
  return p;
}

void SpatialFrame::note_dropped() {
  note_rounding();
  result().lacks_typed_terms = result().lacks_typed_terms || has_exact_frames_;
}

Polynomial SpatialFrame::difference(const Polynomial& a, const Polynomial& b) {
  Polynomial rest = rounded_difference(a, b);
  if (rest.terms.size() < (a - b).terms.size()) note_dropped();
  return rest;
}

void SpatialFrame::add_equation(const std::string& name, Polynomial p) {
  if (p.terms.empty()) return;
  if (degree(p) == 0) {
    result().contradictions.push_back(name + " cannot hold: what it joins is already held");
  }
  enter(name, std::move(p));
}

void SpatialFrame::add_contradiction(const std::string& clause, const Rational& left) {
  result().contradictions.push_back(clause);
  enter("loop", real_constant(left));
}

void SpatialFrame::add_check(const std::string& name, Polynomial p) {
  checks_.emplace_back(name, std::move(p));
}

void SpatialFrame::add_checks() {
  for (auto& [name, p] : std::exchange(checks_, {})) add_equation(name, std::move(p));
}

void SpatialFrame::exclude(Polynomial p, const std::string& reason) {
  result().exclusions.push_back({std::move(p), reason});
}

void SpatialFrame::place(std::size_t group, std::size_t parent, const MovingPose& relative) {
  result().poses.placements.push_back({group, parent, relative, {}});
}

Rational SpatialFrame::random_number() {
  constexpr std::int64_t kParts = 64;
  const std::uint64_t bits = random_bits(kSeed, RandomStream::formulation, random_count_++);
  const auto size = static_cast<std::int64_t>((bits >> 1) % (3 * kParts / 2));
  const Rational number(kParts / 2 + size, kParts);
  return (bits & 1) != 0 ? number : -number;
}

MovingPose turn_of(const Polynomial& t, const Rational& fixed) {
  const Polynomial o = real_constant(fixed);
  MovingPose turn;
  turn.q[0] = constant({1, 0}) - o * t;
  turn.q[3] = o + t;
  return turn;
}

MovingPose slide_of(const Polynomial& u, const Rational& fixed) {
  MovingPose slide;
  slide.q[0] = constant({1, 0}) - real_constant(fixed) * u;
  slide.g[3] = Coefficient{Rational(1, 2), 0} * u;
  return slide;
}

Polynomial SpatialFrame::add_turn(const std::string& name, const std::vector<std::string>& owners) {
  const Polynomial t = add_unknown(name, true, owners);
  exclude(constant({1, 0}) + t * t, "a half angle's tangent is i or -i there: nothing is turned");
  return t;
}

Polynomial SpatialFrame::add_slide(const std::string& name, const Rational& fixed,
                                   const std::vector<std::string>& owners) {
  const Polynomial u = add_unknown(name, false, owners);
  if (!fixed.is_zero()) {
    exclude(constant({1, 0}) - Coefficient{fixed, 0} * u, "a slide is infinitely long there");
  }
  return u;
}

Quaternion<Polynomial> SpatialFrame::add_patched(const std::string& name, bool is_direction,
                                                 const std::vector<std::string>& owners) {
  Quaternion<Polynomial> x;
  Polynomial patch = constant({-1, 0});
  for (std::size_t k = 0; k < x.size(); ++k) {
    x[k] = add_unknown(name + std::to_string(k), is_direction, owners);
    patch = patch + Coefficient{random_number(), 0} * x[k];
  }
  add_equation("patch of " + name, patch);
  return x;
}

MovingPose SpatialFrame::add_any_turn(const std::string& name,
                                      const std::vector<std::string>& owners) {
  const MovingPose turn{add_patched("q_" + name + "_", true, owners), {}};
  exclude(dot(turn.q, turn.q), "the quaternion has norm 0 there");
  return turn;
}

MovingPose SpatialFrame::add_any_pose(const std::string& name,
                                      const std::vector<std::string>& owners) {
  MovingPose pose = add_any_turn(name, owners);
  for (std::size_t k = 0; k < pose.g.size(); ++k) {
    pose.g[k] = add_unknown("g_" + name + "_" + std::to_string(k), false, owners);
  }
  add_equation("Study's quadric of " + name, dot(pose.q, pose.g));
  return pose;
}

std::vector<TieStep> steps_of(const Tie& tie, bool turns_first) {
  using Kind = TieStep::Kind;
  std::vector<TieStep> turns;
  const std::size_t count = turn_freedom(tie);
  if (count == 1) turns = {{Kind::turn, {}, "t_" + tie.name}};
  if (count == 2) {
    turns = {{Kind::turn, {}, "t1_" + tie.name},
             {Kind::fixed, tilt(tie.half_tangent)},
             {Kind::turn, {}, "t2_" + tie.name}};
  }
  if (count > 2) turns = {{Kind::any_turn, {}, tie.name}};
  std::vector<TieStep> slides;
  if (tie.place == JointPlace::on_line) slides = {{Kind::slide, {}, "s_" + tie.name}};
  if (tie.place == JointPlace::in_plane) {
    slides = {{Kind::fixed, across(0)},
              {Kind::slide, {}, "s1_" + tie.name},
              {Kind::fixed, conjugate(across(0)) * across(1)},
              {Kind::slide, {}, "s2_" + tie.name},
              {Kind::fixed, conjugate(across(1))}};
  }
  std::vector<TieStep> steps{{Kind::fixed, tie.at_i}};
  for (const auto* part : {turns_first ? &turns : &slides, turns_first ? &slides : &turns}) {
    steps.insert(steps.end(), part->begin(), part->end());
  }
  steps.push_back({Kind::fixed, conjugate(tie.at_j)});
  return steps;
}

MovingPose add_motion(SpatialFrame& frame, const Tie& tie, const std::vector<std::string>& owners) {
  if (is_loose(tie)) throw std::logic_error("a tie that holds one number places nothing");
  const auto moved = [&](const TieStep& step) {
    switch (step.kind) {
      case TieStep::Kind::turn:
        return turn_of(frame.add_turn(step.name, owners), frame.random_number());
      case TieStep::Kind::slide:
        return slide_of(frame.add_slide(step.name, 0, owners), 0);
      case TieStep::Kind::any_turn:
        return frame.add_any_turn(step.name, owners);
      case TieStep::Kind::fixed:
        break;
    }
    return to_moving(step.pose);
  };
  // The line of a point that turns freely is fixed in one group.
  MovingPose motion = to_moving(ExactPose::identity());
  for (const TieStep& step : steps_of(tie, tie.is_reversed)) motion = motion * moved(step);
  return motion;
}

Polynomial rod_equation(SpatialFrame& frame, const Tie& tie, const MovingPose& j_in_i) {
  const MovingPose motion = to_moving(conjugate(tie.at_i)) * j_in_i * to_moving(tie.at_j);
  // Rods of one pair of groups share the factor of their highest terms.
  const Rational factor = 1 / (norm(tie.at_i) * norm(tie.at_j));
  return frame.difference(Coefficient{4 * factor, 0} * dot(motion.g, motion.g),
                          Coefficient{factor * tie.square, 0} * dot(motion.q, motion.q));
}

void add_closing(SpatialFrame& frame, const Tie& tie, const MovingPose& j_in_i) {
  if (is_rod(tie)) throw std::logic_error("a rod closes by its length");
  const MovingPose motion = to_moving(conjugate(tie.at_i)) * j_in_i * to_moving(tie.at_j);
  const auto& [q, g] = motion;
  double turn_size = 0;
  for (const Polynomial& p : q) turn_size = std::max(turn_size, largest_coefficient(p));
  const auto vanish = [&](const Polynomial& p, double size, const char* part) {
    frame.add_equation(tie.name + ": " + part, frame.without_rounding(p, size));
  };
  const double shift_size = turn_size * frame.length();
  const bool is_aligned = turn_freedom(tie) <= 1;
  if (is_aligned) {
    vanish(q[1], turn_size, "tilt 1");
    vanish(q[2], turn_size, "tilt 2");
    if (tie.turn == JointTurn::not_at_all) vanish(q[3], turn_size, "turn");
  } else if (tie.turn == JointTurn::about_two_axes) {
    // cos = (along - across) / (along + across) = (1 - h^2) / (1 + h^2), h = tan of half the angle
    const Rational square = tie.half_tangent * tie.half_tangent;
    const Polynomial along = q[0] * q[0] + q[3] * q[3];
    const Polynomial across = q[1] * q[1] + q[2] * q[2];
    vanish(Coefficient{square, 0} * along - across, turn_size * turn_size, "angle");
  }
  // g is of the turned group's shift where q is not known to be about the axis; product(g, conj q)
  // is the shift itself.
  const bool has_x_and_y = tie.place != JointPlace::in_plane;
  const bool has_z = tie.place != JointPlace::on_line;
  if (tie.place == JointPlace::at_point || is_aligned) {
    if (has_x_and_y) vanish(g[1], shift_size, "x");
    if (has_x_and_y) vanish(g[2], shift_size, "y");
    if (has_z) vanish(g[3], shift_size, "z");
    // Study's quadric q g = 0 holds of every pose.
    const bool has_w = has_z || tie.turn == JointTurn::not_at_all;
    if (has_w) frame.add_check(tie.name + ": w", frame.without_rounding(g[0], shift_size));
    return;
  }
  const auto shift = product(g, conjugate(q));
  if (has_x_and_y) vanish(shift[1], turn_size * shift_size, "x");
  if (has_x_and_y) vanish(shift[2], turn_size * shift_size, "y");
  if (has_z) vanish(shift[3], turn_size * shift_size, "z");
}

}  // namespace moivre
