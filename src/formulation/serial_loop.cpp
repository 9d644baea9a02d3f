// SPDX-License-Identifier: MIT
// A loop of ties as a chain of turns and slides, and where it is cut.
#include "serial_loop.h"

#include <algorithm>
#include <stdexcept>

#include "loop_equations.h"

namespace moivre {
namespace {

constexpr std::size_t kFewest = 3;
constexpr std::size_t kMost = 6;

class Chain {
 public:
  /// Slides are their own unknowns where they are to be linear; else infinity is brought to a finite place. `at`: where it begins.
  Chain(SpatialFrame& frame, const RigidGroups& groups, bool has_plain_slides, ExactPose at)
      : frame_(frame), groups_(groups), has_plain_slides_(has_plain_slides), at_(std::move(at)) {}

  void follow(const Tie& tie, bool is_last) {
    const std::vector<std::string>& owners = groups_.bodies[is_last ? tie.i : tie.j];
    MovingPose pose = to_moving(identity_pose());
    for (const TieStep& step : steps_of(tie, true)) {
      if (step.kind == TieStep::Kind::fixed) {
        at_ = at_ * step.pose;
        pose = pose * to_moving(step.pose);
      } else {
        pose = pose * add(step, owners);
      }
    }
    if (!is_last) frame_.place(tie.j, tie.i, pose);
  }

  std::vector<LoopElement> take() && { return std::move(elements_); }
  ExactPose end() const { return at_; }

 private:
  MovingPose add(const TieStep& step, const std::vector<std::string>& owners) {
    LoopElement element;
    element.is_turn = step.kind == TieStep::Kind::turn;
    element.axis = axis_at(at_, element.is_turn);
    element.owners = owners;
    element.name = step.name;
    if (element.is_turn) {
      element.fixed = frame_.random_number();
      element.unknown = frame_.add_turn(step.name, owners);
    } else {
      if (!has_plain_slides_) element.fixed = frame_.random_number() / Rational(frame_.length());
      element.unknown = frame_.add_slide(step.name, element.fixed, owners);
    }
    elements_.push_back(element);
    return element.is_turn ? turn_of(element.unknown, element.fixed)
                           : slide_of(element.unknown, element.fixed);
  }

  SpatialFrame& frame_;
  const RigidGroups& groups_;
  bool has_plain_slides_;
  std::vector<LoopElement> elements_;
  ExactPose at_;  ///< where the chain has come with all joints at rest
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
  // Seen from the first joint: places far from the origin would be rounded by more, and a loop that moves would not.
  const Quaternion<Rational> first = shift_of(loop.front().at_i);
  const Rational half(1, 2);
  const ExactPose origin{{1, 0, 0, 0}, {0, half * first[1], half * first[2], half * first[3]}};
  const auto followed = [&](SpatialFrame& into, bool has_plain_slides) {
    Chain chain(into, groups, has_plain_slides, conjugate(origin));
    for (std::size_t k = 0; k < loop.size(); ++k) chain.follow(loop[k], k + 1 == loop.size());
    const ExactPose whole = conjugate(shortened(chain.end() * origin));
    return JointLoop{std::move(chain).take(), whole};
  };
  frame.note_rounding();
  SpatialFrame plain = frame;
  LoopForm form = form_of(followed(plain, true), frame.length());
  if (has_linear_slides(form.kind)) {
    frame = std::move(plain);
  } else {
    form = form_of(followed(frame, false), frame.length());
    if (has_linear_slides(form.kind)) {
      throw std::logic_error("a loop's form hangs on how its slides are written");
    }
  }
  add_loop_equations(frame, std::move(form));
}

}  // namespace moivre
