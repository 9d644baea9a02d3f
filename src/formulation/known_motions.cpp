// SPDX-License-Identifier: MIT
// Angles and slides from each other, round after round.
#include "known_motions.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "moivre/mechanism/driven_joint.h"

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

bool reads(const Driver& driver, std::size_t body) {
  switch (driver.kind) {
    case DriverKind::angle:
      return driver.bodies[0] == body || driver.bodies[1] == body;
    case DriverKind::x:
    case DriverKind::y:
    case DriverKind::z:
      return driver.point.body == body;
    case DriverKind::slide:
    case DriverKind::unknown:
      break;
  }
  return false;
}

/// Whether the pinion is held by pins at its centre and by this rack, and by nothing else.
bool is_followed_freely(const Mechanism& mechanism, const Joint& rack) {
  const std::size_t pinion = rack.at[1].body;
  const auto centre = mechanism.bodies[pinion].points[rack.at[1].point].at;
  const auto leaves_free = [&](const Joint& joint) {
    if (&joint == &rack) return true;
    if (traits(joint.type).turn == JointTurn::geared && joint.gear.carrier == pinion) return false;
    return std::all_of(joint.at.begin(), joint.at.end(), [&](const PointOf& end) {
      if (end.body != pinion) return true;
      return joint.type == JointType::revolute &&
             mechanism.bodies[pinion].points[end.point].at == centre;
    });
  };
  return pinion != 0 &&
         std::all_of(mechanism.joints.begin(), mechanism.joints.end(), leaves_free) &&
         std::none_of(mechanism.drivers.begin(), mechanism.drivers.end(),
                      [&](const Driver& driver) { return reads(driver, pinion); });
}

std::vector<std::optional<double>> values(const std::vector<std::optional<KnownSlide>>& slides) {
  std::vector<std::optional<double>> found;
  for (const auto& slide : slides) {
    found.push_back(slide ? std::optional(slide->value) : std::nullopt);
  }
  return found;
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
    settle_by_angles();
    while (has_open() && take(find_slides(known_))) settle_by_angles();
    for (std::size_t k = 0; k < known_.slides.size(); ++k) {
      if (is_open(k)) follow(k);
    }
    return std::move(known_);
  }

 private:
  bool is_rack(std::size_t k) const { return mechanism_.joints[k].type == JointType::rack; }
  bool is_open(std::size_t k) const {
    const JointTurn turn = traits(mechanism_.joints[k].type).turn;
    return (turn == JointTurn::by_rack || turn == JointTurn::by_cam) && !known_.slides[k];
  }
  bool has_open() const {
    for (std::size_t k = 0; k < known_.slides.size(); ++k) {
      if (is_open(k)) return true;
    }
    return false;
  }

  void settle_by_angles() {
    for (bool has_grown = true; has_grown;) {
      has_grown = false;
      known_.angles = known_angles(mechanism_, t_, values(known_.slides));
      for (std::size_t k = 0; k < known_.slides.size(); ++k) {
        const Joint& joint = mechanism_.joints[k];
        const auto slide = is_open(k) ? slide_by_angles(joint, known_.angles) : std::nullopt;
        if (!slide) continue;
        known_.slides[k] = KnownSlide{*slide, false};
        has_grown = true;
      }
    }
  }

  /// Whether any of these is new.
  bool take(const std::vector<std::optional<double>>& found) {
    bool is_new = false;
    for (std::size_t k = 0; k < found.size(); ++k) {
      if (!is_open(k) || !found[k]) continue;
      known_.slides[k] = KnownSlide{*found[k], true};
      is_new = true;
    }
    return is_new;
  }

  void follow(std::size_t k) {
    const Joint& rack = mechanism_.joints[k];
    if (!is_rack(k)) {
      throw std::invalid_argument(
          "the " + to_string(rack.type) + " '" + rack.name +
          "' lifts by a table, which no polynomial says; drive the cam's angle, or follow one pose "
          "with --from-guess");
    }
    if (!is_followed_freely(mechanism_, rack)) {
      throw std::invalid_argument(
          "the rack '" + rack.name +
          "' ties an angle to a length, which no polynomial says, and neither is known before the "
          "other; drive the pinion or the rack (slide = \"" +
          rack.name + "\"), or follow one pose with --from-guess");
    }
    known_.is_followed[k] = true;
  }

  const Mechanism& mechanism_;
  double t_;
  KnownMotions known_;
};

}  // namespace

KnownMotions known_motions(const Mechanism& mechanism, double t, const FindSlides& find_slides) {
  return MotionsInTurn(mechanism, t).run(find_slides);
}

double disagreement(const Joint& joint, const KnownSlide& slide,
                    const std::vector<std::optional<KnownAngle>>& angles) {
  const auto angle = relative_angle(turn_body(joint), joint.at[1].body, angles);
  return angle
             ? std::abs(std::remainder(*angle - turn_by(joint, slide.value), 2 * std::numbers::pi))
             : 0;
}

}  // namespace moivre
