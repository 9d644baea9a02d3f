// SPDX-License-Identifier: MIT
// Angles and slides from each other, round after round.
#include "known_motions.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "moivre/mechanism/driven_joint.h"
#include "moivre/mechanism/joint_type.h"
#include "moivre/numeric/invalid_input.h"

namespace moivre {
namespace {

/// Of the second body relative to the first.
std::optional<double> relative_angle(std::size_t i, std::size_t j,
                                     const std::vector<std::optional<KnownAngle>>& angles) {
  const auto& first = angles[i];
  const auto& second = angles[j];
  if (!first || !second || first->root != second->root) return std::nullopt;
  return second->value - first->value;
}

/// What the angles say of a rack's slide or a cam's lift.
std::optional<double> slide_by_angles(const Joint& joint,
                                      const std::vector<std::optional<KnownAngle>>& angles) {
  const bool is_rack = joint.type == JointType::rack;
  const auto angle = is_rack ? relative_angle(joint.at[0].body, joint.at[1].body, angles)
                             : relative_angle(joint.gear.carrier, joint.at[0].body, angles);
  if (!angle) return std::nullopt;
  const double turned = *angle - joint.gear.phase_rad;
  return is_rack ? joint.radius * turned : periodic_state(joint.profile, turned).value;
}

bool reads(const Mechanism& mechanism, const Driver& driver, std::size_t body) {
  const std::vector<std::size_t> bodies = bodies_of(mechanism, driver);
  return std::find(bodies.begin(), bodies.end(), body) != bodies.end();
}

/// Whether the other joint guides the cam's tappet along the cam's line.
bool guides(const Joint& other, const Joint& cam) {
  constexpr double kParallel = 1e-9;
  return other.type == JointType::prismatic && other.at[0].body == cam.gear.carrier &&
         other.at[1].body == cam.at[1].body && other.axis[0].cross(cam.axis[0]).norm() <= kParallel;
}

/// Whether the second body of a rack or a cam is held by that and by pins at one place, or a tappet
/// by its guide, and by nothing else.
bool is_followed_freely(const Mechanism& mechanism, const Joint& joint) {
  const std::size_t body = joint.at[1].body;
  const auto pivot = pivot_of(mechanism, joint);
  const auto is_at_pivot = [&](const PointOf& end) {
    return end.body != body || (pivot && mechanism.bodies[body].points[end.point].at ==
                                             mechanism.bodies[body].points[pivot->point].at);
  };
  const auto leaves_free = [&](const Joint& other) {
    if (&other == &joint) return true;
    if (is_transmission(other.type) && other.gear.carrier == body) return false;
    if (other.at[0].body != body && other.at[1].body != body) return true;
    if (joint.type == JointType::cam) return guides(other, joint);
    return other.type == JointType::revolute && is_at_pivot(other.at[0]) &&
           is_at_pivot(other.at[1]);
  };
  const auto& joints = mechanism.joints;
  const bool is_held = joint.type == JointType::cam
                           ? std::any_of(joints.begin(), joints.end(),
                                         [&](const Joint& other) { return guides(other, joint); })
                           : pivot.has_value();
  return body != 0 && is_held && std::all_of(joints.begin(), joints.end(), leaves_free) &&
         std::none_of(mechanism.drivers.begin(), mechanism.drivers.end(),
                      [&](const Driver& driver) { return reads(mechanism, driver, body); });
}

class MotionsInTurn {
 public:
  MotionsInTurn(const Mechanism& mechanism, double t) : mechanism_(mechanism), t_(t) {
    known_.slides.resize(mechanism.joints.size());
    known_.is_followed.resize(mechanism.joints.size());
    for (std::size_t k = 0; k < mechanism.joints.size(); ++k) {
      const auto driven = driven_joint(mechanism, k, t).slide;
      if (is_rack(k) && driven) known_.slides[k] = KnownSlide{*driven, false};
    }
  }

  KnownMotions run(const FindSlides& find_slides) && {
    do {
      settle_by_angles();
    } while (!open().empty() && take(find_slides(known_)));
    for (const std::size_t k : open()) follow(k);
    return std::move(known_);
  }

 private:
  bool is_rack(std::size_t k) const { return mechanism_.joints[k].type == JointType::rack; }
  bool is_open(std::size_t k) const {
    const JointTurn turn = traits(mechanism_.joints[k].type).turn;
    return (turn == JointTurn::by_rack || turn == JointTurn::by_cam) && !known_.slides[k];
  }
  std::vector<std::size_t> open() const {
    std::vector<std::size_t> all;
    for (std::size_t k = 0; k < known_.slides.size(); ++k) {
      if (is_open(k)) all.push_back(k);
    }
    return all;
  }

  void settle_by_angles() {
    for (bool has_grown = true; has_grown;) {
      has_grown = false;
      known_.angles = known_angles(mechanism_, t_, known_.slides);
      for (const std::size_t k : open()) {
        const auto slide = slide_by_angles(mechanism_.joints[k], known_.angles);
        if (!slide) continue;
        known_.slides[k] = KnownSlide{*slide, false};
        has_grown = true;
      }
    }
  }

  /// Whether any of these is new.
  bool take(const std::vector<std::optional<double>>& found) {
    bool is_new = false;
    for (const std::size_t k : open()) {
      if (!found[k]) continue;
      known_.slides[k] = KnownSlide{*found[k], true};
      is_new = true;
    }
    return is_new;
  }

  void follow(std::size_t k) {
    const Joint& joint = mechanism_.joints[k];
    known_.is_followed[k] = is_followed_freely(mechanism_, joint);
    if (known_.is_followed[k]) return;
    const std::string name = "the " + to_string(joint.type) + " '" + joint.name + "' ";
    throw InvalidInput(
        is_rack(k)
            ? name +
                  "ties an angle to a length, which no polynomial says, and neither is known "
                  "before the other; drive the pinion or the rack (slide = \"" +
                  joint.name + "\"), or follow one pose with `follow_guesses`"
            : name +
                  "lifts by a table, which no polynomial says; drive the cam's angle, or follow "
                  "one pose with `follow_guesses`");
  }

  const Mechanism& mechanism_;
  double t_;
  KnownMotions known_;
};

}  // namespace

KnownMotions known_motions(const Mechanism& mechanism, double t, const FindSlides& find_slides) {
  return MotionsInTurn(mechanism, t).run(find_slides);
}

std::optional<PointOf> pivot_of(const Mechanism& mechanism, const Joint& joint) {
  if (joint.type == JointType::rack) return joint.at[1];
  for (const Joint& other : mechanism.joints) {
    if (other.type != JointType::revolute) continue;
    for (const PointOf& end : other.at) {
      if (end.body == joint.at[1].body) return end;
    }
  }
  return std::nullopt;
}

double disagreement(const Joint& joint, const KnownSlide& slide,
                    const std::vector<std::optional<KnownAngle>>& angles) {
  const auto angle = relative_angle(turn_body(joint), joint.at[1].body, angles);
  return angle
             ? std::abs(std::remainder(*angle - turn_by(joint, slide.value), 2 * std::numbers::pi))
             : 0;
}

}  // namespace moivre
