// SPDX-License-Identifier: MIT
// Angles and slides from each other, round after round.
#include "racks.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "moivre/mechanism/driven_joint.h"

namespace moivre {
namespace {

/// Of the pinion relative to the rack.
std::optional<double> relative_angle(const Joint& rack,
                                     const std::vector<std::optional<KnownAngle>>& angles) {
  const auto& first = angles[rack.at[0].body];
  const auto& second = angles[rack.at[1].body];
  if (!first || !second || first->root != second->root) return std::nullopt;
  return second->value - first->value;
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

class RacksInTurn {
 public:
  RacksInTurn(const Mechanism& mechanism, double t) : mechanism_(mechanism), t_(t) {
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
  bool is_open(std::size_t k) const { return is_rack(k) && !known_.slides[k]; }
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
        const Joint& rack = mechanism_.joints[k];
        const auto angle = is_open(k) ? relative_angle(rack, known_.angles) : std::nullopt;
        if (!angle) continue;
        known_.slides[k] = KnownSlide{rack.radius * (*angle - rack.turn_rad), false};
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
  return RacksInTurn(mechanism, t).run(find_slides);
}

double disagreement(const Joint& rack, const KnownSlide& slide,
                    const std::vector<std::optional<KnownAngle>>& angles) {
  const auto angle = relative_angle(rack, angles);
  if (!angle) return 0;
  return std::abs(
      std::remainder(*angle - rack.turn_rad - slide.value / rack.radius, 2 * std::numbers::pi));
}

}  // namespace moivre
