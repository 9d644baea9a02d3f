// SPDX-License-Identifier: MIT
// A loop of ties as a chain of turns and slides, and where it is cut.
#include "serial_loop.h"

#include <algorithm>

#include "loop_equations.h"

namespace moivre {
namespace {

constexpr std::size_t kFewest = 3;
constexpr std::size_t kMost = 6;

class Chain {
 public:
  /// Slides are their own unknowns where they are to be linear; else infinity is brought to a finite place.
  Chain(SpatialFrame& frame, const RigidGroups& groups, bool has_plain_slides)
      : frame_(frame), groups_(groups), has_plain_slides_(has_plain_slides) {}

  void follow(const Tie& tie, bool is_last) {
    owners_ = groups_.bodies[is_last ? tie.i : tie.j];
    step_ = to_moving(identity_pose());
    fixed(tie.at_i);
    turns(tie);
    slides(tie);
    fixed(conjugate(tie.at_j));
    if (!is_last) frame_.place(tie.j, tie.i, step_);
  }

  std::vector<LoopElement> take() && { return std::move(elements_); }
  ExactPose end() const { return at_; }

 private:
  void turn(const std::string& name) {
    LoopElement element;
    element.fixed = frame_.random_number();
    element.axis = axis_at(at_);
    element.owners = owners_;
    element.is_turn = true;
    element.name = name;
    element.unknown = frame_.add_unknown(name, true, owners_);
    step_ = step_ * turn_of(element.unknown, element.fixed);
    elements_.push_back(std::move(element));
  }

  void slide(const std::string& name) {
    LoopElement element;
    if (!has_plain_slides_) {
      element.fixed = frame_.random_number();
      element.fixed /= Rational(frame_.length());
    }
    element.axis = slide_at(at_);
    element.owners = owners_;
    element.name = name;
    element.unknown = frame_.add_unknown(name, false, owners_);
    step_ = step_ * slide_of(element.unknown, element.fixed);
    elements_.push_back(std::move(element));
  }

  void turns(const Tie& tie) {
    if (turn_freedom(tie) == 1) turn("t_" + tie.name);
    if (turn_freedom(tie) != 2) return;
    turn("t1_" + tie.name);
    fixed(tilt(tie.half_tangent));
    turn("t2_" + tie.name);
  }

  void slides(const Tie& tie) {
    if (tie.place == JointPlace::on_line) slide("s_" + tie.name);
    if (tie.place != JointPlace::in_plane) return;
    for (const std::size_t k : {std::size_t{0}, std::size_t{1}}) {
      fixed(across(k));
      slide("s" + std::to_string(k + 1) + "_" + tie.name);
      fixed(conjugate(across(k)));
    }
  }

  void fixed(const ExactPose& pose) {
    at_ = at_ * pose;
    step_ = step_ * to_moving(pose);
  }

  SpatialFrame& frame_;
  const RigidGroups& groups_;
  bool has_plain_slides_;
  std::vector<LoopElement> elements_;
  ExactPose at_ = identity_pose();  ///< where the chain has come with all joints at rest
  MovingPose step_;                 ///< of the tie at work
  std::vector<std::string> owners_;
};

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
  const auto followed = [&](SpatialFrame& into, bool has_plain_slides) {
    Chain chain(into, groups, has_plain_slides);
    for (std::size_t k = 0; k < loop.size(); ++k) chain.follow(loop[k], k + 1 == loop.size());
    const ExactPose whole = conjugate(shortened(chain.end()));
    return JointLoop{std::move(chain).take(), whole};
  };
  SpatialFrame tried(frame.length());
  const bool has_plain_slides = takes_plain_slides(followed(tried, true), frame.length());
  frame.note_rounding();
  add_loop_equations(frame, followed(frame, has_plain_slides));
}

}  // namespace moivre
