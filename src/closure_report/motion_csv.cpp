// SPDX-License-Identifier: MIT
// A motion as a table: one sample of one branch a line.
#include "moivre/closure_report/motion_report.h"
#include "moivre/mechanism/phi.h"
#include "moivre/mechanism/pose.h"
#include "moivre/report/number_text.h"
#include "shown_angles.h"

namespace moivre {
namespace {

Eigen::Index point_size(const Mechanism& mechanism) {
  return mechanism.space == Space::planar ? 2 : 3;
}

std::string columns(const std::string& name, CoordinateKind kind, const AngleForm& form) {
  return ',' + column_name(name, kind, form) + ',' +
         column_name(name + ".velocity", kind, form, "/s") + ',' +
         column_name(name + ".acceleration", kind, form, "/s^2");
}

std::string head(const Mechanism& mechanism, const AngleForm& form) {
  std::string text = "branch,t";
  for (const Driver& driver : mechanism.drivers) {
    text += ',' + column_name("driver " + label_of(driver), kind_of(mechanism, driver), form);
  }
  for (const Coordinate& coordinate : coordinates(mechanism)) {
    text += columns(coordinate.name, coordinate.kind, form);
  }
  for (std::size_t body = 1; body < mechanism.bodies.size(); ++body) {
    for (const BodyPoint& point : mechanism.bodies[body].points) {
      const std::string name = mechanism.bodies[body].name + '.' + point.name;
      for (Eigen::Index k = 0; k < point_size(mechanism); ++k)
        text += columns(name + '.' + "xyz"[k], CoordinateKind::length, form);
    }
  }
  return text + '\n';
}

/// Without velocity and acceleration where the constraints do not determine them.
std::string cells(const BranchSample& sample, double value, double velocity, double acceleration,
                  CoordinateKind kind, const AngleForm& form) {
  std::string text = ',' + exact_text(in_form(value, kind, form));
  for (const double rate : {velocity, acceleration}) {
    text += sample.is_determined ? ',' + exact_text(in_form(rate, kind, form)) : ",";
  }
  return text;
}

/// `q`: the sample's, in the form that is wanted.
std::string line(const BranchSample& sample, const Eigen::VectorXd& q, const Mechanism& mechanism,
                 const AngleForm& form) {
  std::string text = ',' + exact_text(sample.time);
  const std::vector<double> drivers = driver_values(mechanism, sample.time);
  for (std::size_t k = 0; k < drivers.size(); ++k) {
    text += ',' + exact_text(in_form(drivers[k], kind_of(mechanism, mechanism.drivers[k]), form));
  }
  const std::vector<Coordinate> all = coordinates(mechanism);
  for (Eigen::Index k = 0; k < q.size(); ++k) {
    text += cells(sample, q[k], sample.velocity[k], sample.acceleration[k],
                  all[static_cast<std::size_t>(k)].kind, form);
  }
  for (std::size_t body = 1; body < mechanism.bodies.size(); ++body) {
    for (std::size_t p = 0; p < mechanism.bodies[body].points.size(); ++p) {
      const PointState at =
          point_state(mechanism, {body, p}, sample.q, sample.velocity, sample.acceleration);
      for (Eigen::Index k = 0; k < point_size(mechanism); ++k) {
        text += cells(sample, at.position[k], at.velocity[k], at.acceleration[k],
                      CoordinateKind::length, form);
      }
    }
  }
  return text + '\n';
}

}  // namespace

std::string motion_csv(const MotionResult& result, const Mechanism& mechanism,
                       const AngleForm& form) {
  const Phi phi(mechanism);
  std::string text = head(mechanism, form);
  for (const MotionBranch& branch : result.branches) {
    const Eigen::VectorXd turns = turns_to_begin(mechanism, branch);
    for (const BranchSample& sample : branch.samples) {
      text += branch.id + line(sample, shown(phi, sample, form, turns), mechanism, form);
    }
  }
  return text;
}

}  // namespace moivre
