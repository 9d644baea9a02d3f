// SPDX-License-Identifier: MIT
// A motion as a table: one sample of one branch a line.
#include "moivre/closure_report/motion_report.h"
#include "moivre/mechanism/phi.h"
#include "moivre/mechanism/pose.h"
#include "moivre/report/number_text.h"

namespace moivre {
namespace {

Eigen::Index point_size(const Mechanism& mechanism) {
  return mechanism.space == Space::planar ? 2 : 3;
}

std::string column(const std::string& name) {
  return ',' + name + ',' + name + ".velocity," + name + ".acceleration";
}

std::string head(const Mechanism& mechanism) {
  std::string text = "branch,t";
  for (const Driver& driver : mechanism.drivers) text += ",driver " + driver.name;
  for (const Coordinate& coordinate : coordinates(mechanism)) text += column(coordinate.name);
  for (std::size_t body = 1; body < mechanism.bodies.size(); ++body) {
    for (const BodyPoint& point : mechanism.bodies[body].points) {
      const std::string name = mechanism.bodies[body].name + '.' + point.name;
      for (Eigen::Index k = 0; k < point_size(mechanism); ++k)
        text += column(name + '.' + "xyz"[k]);
    }
  }
  return text + '\n';
}

std::string cells(double value, double velocity, double acceleration) {
  return ',' + exact_text(value) + ',' + exact_text(velocity) + ',' + exact_text(acceleration);
}

std::string line(const BranchSample& sample, const Mechanism& mechanism, const Phi& phi) {
  std::string text = ',' + exact_text(sample.time);
  for (const double value : driver_values(mechanism, sample.time)) text += ',' + exact_text(value);
  const Eigen::VectorXd q = phi.canonical(sample.q);
  for (Eigen::Index k = 0; k < q.size(); ++k) {
    text += cells(q[k], sample.velocity[k], sample.acceleration[k]);
  }
  for (std::size_t body = 1; body < mechanism.bodies.size(); ++body) {
    for (std::size_t p = 0; p < mechanism.bodies[body].points.size(); ++p) {
      const PointState at =
          point_state(mechanism, {body, p}, sample.q, sample.velocity, sample.acceleration);
      for (Eigen::Index k = 0; k < point_size(mechanism); ++k) {
        text += cells(at.position[k], at.velocity[k], at.acceleration[k]);
      }
    }
  }
  return text + '\n';
}

}  // namespace

std::string motion_csv(const MotionResult& result, const Mechanism& mechanism) {
  const Phi phi(mechanism);
  std::string text = head(mechanism);
  for (const MotionBranch& branch : result.branches) {
    for (const BranchSample& sample : branch.samples) {
      text += branch.id + line(sample, mechanism, phi);
    }
  }
  return text;
}

}  // namespace moivre
