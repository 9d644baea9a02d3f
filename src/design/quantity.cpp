// SPDX-License-Identifier: MIT
// The quantities of each group, and how they are read off a sample.
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "moivre/closures/idle_joints.h"
#include "moivre/design/readings.h"
#include "moivre/factorization/svd.h"
#include "moivre/kinematics/own_units.h"
#include "moivre/kinematics/state.h"
#include "moivre/numeric/invalid_input.h"
#include "pose_between.h"
#include "sampled_pose.h"

namespace moivre {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

using Rules = std::vector<QuantityRule>;

std::string length_unit(const Mechanism& mechanism) {
  return mechanism.units.length.empty() ? "length" : mechanism.units.length;
}

/// Value, velocity and acceleration.
void add_motion(QuantityGroup group, const Observable& what, const Mechanism& mechanism,
                Rules& rules) {
  const std::string length = what.is_angle ? "" : length_unit(mechanism);
  rules.push_back({{group, what.name, what.name, QuantityOrder::value, what.is_angle, what.turns,
                    length, false},
                   [what](const SampledPose& at) {
                     const VectorXd rest = VectorXd::Zero(at.pose().q.size());
                     return what.state(at.pose().q, rest, rest).value;
                   },
                   std::nullopt,
                   nullptr});
  for (const QuantityOrder order : {QuantityOrder::velocity, QuantityOrder::acceleration}) {
    const bool is_first = order == QuantityOrder::velocity;
    rules.push_back({{group, what.name + (is_first ? ".velocity" : ".acceleration"), what.name,
                      order, what.is_angle, false, length + (is_first ? "/s" : "/s^2"), true},
                     [what, is_first](const SampledPose& at) {
                       if (!at.has_velocity()) return kNothing;
                       const BranchSample& pose = at.pose();
                       const ScalarState state =
                           what.state(pose.q, pose.velocity, pose.acceleration);
                       return is_first ? state.velocity : state.acceleration;
                     },
                     what,
                     nullptr});
  }
}

/// "mm/rad", "1/rad", "-": of what turns or slides, `order` times by what turns or slides.
std::string ratio_unit(bool of_angle, bool by_angle, int order, const std::string& length) {
  const auto power = [](const std::string& unit, int n) {
    return n == 1 ? unit : unit + '^' + std::to_string(n);
  };
  const std::string by = by_angle ? "rad" : length;
  if (of_angle != by_angle) return (of_angle ? "rad" : length) + '/' + power(by, order);
  return order == 1 ? "-" : "1/" + power(by, order - 1);
}

void add_coefficients(const Observable& what, const Mechanism& mechanism, Rules& rules) {
  const std::string length = length_unit(mechanism);
  const auto drivers = static_cast<Index>(mechanism.drivers.size());
  const auto driver = [&](Index a) -> const Driver& {
    return mechanism.drivers[static_cast<std::size_t>(a)];
  };
  const auto turns = [&](Index a) {
    return kind_of(mechanism, driver(a)) == CoordinateKind::angle;
  };
  const auto add = [&](const std::string& name, const std::string& unit,
                       std::function<double(const SampledPose&)> value) {
    rules.push_back(
        {{QuantityGroup::coefficients, name, name, QuantityOrder::value, false, false, unit, true},
         std::move(value),
         what,
         nullptr});
  };
  for (Index a = 0; a < drivers; ++a) {
    const std::string by = label_of(driver(a));
    add("d " + what.name + "/d " + by, ratio_unit(what.is_angle, turns(a), 1, length),
        [what, a](const SampledPose& at) { return at.along(what, a).velocity; });
    add("d2 " + what.name + "/d " + by + "^2", ratio_unit(what.is_angle, turns(a), 2, length),
        [what, a](const SampledPose& at) { return at.along(what, a).acceleration; });
    for (Index b = 0; b < a; ++b) {
      // Of an angle and a slide the unit is written out.
      const std::string top = what.is_angle ? "rad" : length;
      const std::string unit = turns(a) == turns(b) ? ratio_unit(what.is_angle, turns(a), 2, length)
                                                    : top + "/(rad " + length + ")";
      add("d2 " + what.name + "/d " + label_of(driver(b)) + " d " + by, unit,
          [what, a, b](const SampledPose& at) { return at.mixed(what, a, b); });
    }
  }
}

void add_advantages(const Observable& output, const Mechanism& mechanism, Rules& rules) {
  for (std::size_t k = 0; k < mechanism.drivers.size(); ++k) {
    const Driver& driver = mechanism.drivers[k];
    const bool turns = kind_of(mechanism, driver) == CoordinateKind::angle;
    const std::string name = label_of(driver) + '-' + output.name + " advantage";
    const std::string length = length_unit(mechanism);
    // A radian is a length over a length: torque over force is a length.
    const std::string unit =
        turns == output.is_angle ? "-" : (output.is_angle ? length : "1/" + length);
    const auto a = static_cast<Index>(k);
    const auto rate = [output, a](const SampledPose& at) { return at.along(output, a).velocity; };
    rules.push_back(
        {{QuantityGroup::advantage, name, name, QuantityOrder::value, false, false, unit, false},
         [output, rate](const SampledPose& at) {
           if (!at.coefficients().is_determined) return at.runs_away(output) ? 0.0 : kNothing;
           return std::abs(1 / rate(at));
         },
         std::nullopt,
         rate});
  }
}

/// `held`: what the angles are of; joints have the names and numbers that they have in `mechanism`.
void add_transmissions(const Mechanism& mechanism, const Mechanism& held, Rules& rules) {
  const std::vector<TransmissionJoint> joints = transmission_joints(held);
  const auto name_of = [&](const TransmissionJoint& at) {
    const Joint& joint = mechanism.joints[at.joint];
    return mechanism.bodies[joint.at[0].body].name + '-' + mechanism.bodies[joint.at[1].body].name;
  };
  for (const TransmissionJoint& at : joints) {
    std::string name = name_of(at);
    const auto namesakes =
        std::count_if(joints.begin(), joints.end(),
                      [&](const TransmissionJoint& other) { return name_of(other) == name; });
    if (namesakes > 1) name += " at " + mechanism.joints[at.joint].name;
    name += " transmission";
    rules.push_back(
        {{QuantityGroup::transmission, name, name, QuantityOrder::value, true, false, "", false},
         [&held, at](const SampledPose& reading) {
           return transmission_angle(held, reading.phi(), at, reading.pose().q, reading.jacobian())
               .value_or(kNothing);
         },
         std::nullopt,
         nullptr});
  }
}

QuantityRule distance_to_singularity() {
  const std::string name = "distance to singularity";
  return {{QuantityGroup::singularity, name, name, QuantityOrder::value, false, false, "-", false},
          [](const SampledPose& at) {
            const Eigen::MatrixXd& J = at.jacobian();
            if (J.rows() < J.cols()) return 0.0;
            return singular_values(equilibrated(in_own_units(at.phi(), J)))[J.cols() - 1];
          },
          std::nullopt,
          nullptr};
}

}  // namespace

struct QuantityReader::Parts {
  Parts(const Mechanism& original, const QuantityChoice& choice)
      : mechanism(original), held(hold_idle(original).mechanism), phi(held) {
    outputs = choice.outputs.empty() ? default_outputs(mechanism) : choice.outputs;
    std::string refusals;
    for (const std::string& name : outputs) {
      try {
        output_observable(mechanism, name);
      } catch (const std::invalid_argument& refusal) {
        refusals += (refusals.empty() ? "" : "\n") + std::string(refusal.what());
      }
    }
    if (!refusals.empty()) throw InvalidInput(refusals);
    for (const QuantityGroup group : choice.groups) add(group);
    for (const QuantityRule& rule : rules) quantities.push_back(rule.quantity);
  }
  Parts(const Parts&) = delete;
  Parts& operator=(const Parts&) = delete;

  void add(QuantityGroup group) {
    const auto add_all = [&](const std::vector<Observable>& observables) {
      for (const Observable& one : observables) add_motion(group, one, mechanism, rules);
    };
    switch (group) {
      case QuantityGroup::coordinates:
        return add_all(coordinate_observables(mechanism));
      case QuantityGroup::points:
        return add_all(point_observables(mechanism));
      case QuantityGroup::joints:
        return add_all(joint_observables(mechanism));
      case QuantityGroup::coefficients:
        for (const Observable& one : driven_observables(mechanism))
          add_coefficients(one, mechanism, rules);
        return;
      case QuantityGroup::transmission:
        return add_transmissions(mechanism, held, rules);
      case QuantityGroup::advantage:
        for (const std::string& name : outputs)
          add_advantages(output_observable(mechanism, name), mechanism, rules);
        return;
      case QuantityGroup::singularity:
        rules.push_back(distance_to_singularity());
        return;
    }
  }

  const Mechanism mechanism;
  const Mechanism held;  ///< idle joints welded
  const Phi phi;
  std::vector<std::string> outputs;
  Rules rules;
  std::vector<Quantity> quantities;
};

QuantityReader::QuantityReader(const Mechanism& mechanism, const QuantityChoice& choice)
    : parts_(std::make_unique<const Parts>(mechanism, choice)) {}

QuantityReader::~QuantityReader() = default;

const std::vector<Quantity>& QuantityReader::quantities() const { return parts_->quantities; }
const std::vector<std::string>& QuantityReader::outputs() const { return parts_->outputs; }

std::vector<double> QuantityReader::read(const BranchSample& pose) const {
  const SampledPose reading(parts_->phi, pose);
  std::vector<double> values;
  for (const QuantityRule& rule : parts_->rules) values.push_back(rule.value(reading));
  return values;
}

double QuantityReader::read(std::size_t quantity, const BranchSample& pose) const {
  return parts_->rules[quantity].value(SampledPose(parts_->phi, pose));
}

double QuantityReader::rate(std::size_t quantity, const BranchSample& pose) const {
  const QuantityRule& rule = parts_->rules[quantity];
  return rule.rate ? rule.rate(SampledPose(parts_->phi, pose)) : kNothing;
}

bool QuantityReader::runs_away(std::size_t quantity, const VectorXd& q, double time) const {
  const QuantityRule& rule = parts_->rules[quantity];
  BranchSample pose;
  pose.time = time;
  pose.q = q;
  return rule.moves && SampledPose(parts_->phi, pose).runs_away(*rule.moves);
}

BranchSample QuantityReader::sample_at(double time, const VectorXd& q) const {
  const MotionState state = motion_state(parts_->phi, q, time);
  BranchSample sample;
  sample.time = time;
  sample.q = q;
  sample.velocity = state.velocity;
  sample.acceleration = state.acceleration;
  sample.is_determined = state.is_determined;
  return sample;
}

BranchSample QuantityReader::between(const BranchSample& before, const BranchSample& after,
                                     double time) const {
  return pose_between(parts_->phi, before, after, time);
}

}  // namespace moivre
