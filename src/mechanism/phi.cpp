// SPDX-License-Identifier: MIT
// How is Phi put together and differentiated? Constraints evaluated in Taylor arithmetic along
// lines of (q, t).
#include "moivre/mechanism/phi.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "constraint.h"
#include "dimension_jets.h"
#include "joint_lengths.h"
#include "moivre/mechanism/rules.h"

namespace moivre {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Rows of a typed equation, or of a driver of an unknown.
std::shared_ptr<const Constraint> typed_equation(const Equation& equation) {
  return make_constraint({{equation.name, 0}}, unknowns_of(equation.formula),
                         [formula = equation.formula](const auto& at, auto* row) {
                           row[0] = evaluate(formula, at.q, at.t);
                         });
}

std::shared_ptr<const Constraint> unknown_driver(const Mechanism& mechanism, const Driver& driver,
                                                 const Dimension* moving) {
  const std::size_t k = driver.unknown;
  const bool is_periodic = coordinates(mechanism)[k].is_periodic;
  return make_constraint(
      {{"driver " + driver.name + ": unknown", 0}}, {k},
      [law = prescription(mechanism, driver, moving), k, is_periodic](const auto& at, auto* row) {
        const auto gap = at.q[k] - law_at(law, at.t);
        row[0] = is_periodic ? within_half_turn(gap) : gap;
      });
}

Constraints joint_constraints(const Mechanism& mechanism) {
  Constraints constraints;
  for (const Equation& equation : mechanism.equations)
    constraints.push_back(typed_equation(equation));
  for (const Joint& joint : mechanism.joints) {
    constraints.push_back(joint_constraint(mechanism, joint));
  }
  return constraints;
}

/// Of points in their bodies and of rods, where they are not 0.
std::vector<double> lengths_of(const Mechanism& mechanism) {
  std::vector<double> lengths;
  for (const Body& body : mechanism.bodies) {
    for (const BodyPoint& point : body.points) lengths.push_back(point.at.norm());
  }
  for (const Joint& joint : mechanism.joints) {
    if (reads_length(joint.type)) lengths.push_back(std::abs(joint.length));
  }
  std::erase(lengths, 0.0);
  return lengths;
}

/// 1 where there is none.
double largest_of(const std::vector<double>& lengths) {
  return lengths.empty() ? 1 : *std::max_element(lengths.begin(), lengths.end());
}

/// The geometric mean, without what is rounding relative to the largest; 1 where there is none.
double mean_of(const std::vector<double>& lengths) {
  constexpr double kRounding = 1e-15;
  const double least = kRounding * largest_of(lengths);
  double sum = 0;
  int count = 0;
  for (const double length : lengths) {
    if (length <= least) continue;
    sum += std::log(length);
    ++count;
  }
  return count == 0 ? 1 : std::exp(sum / count);
}

/// The mechanism; throws where its form is broken.
const Mechanism& of_whole_form(const Mechanism& mechanism) {
  require_form(mechanism);
  return mechanism;
}

void require_size(const VectorXd& q, Index n) {
  if (q.size() == n) return;
  throw InvalidInput("q has " + std::to_string(n) + " numbers, one for each coordinate, not " +
                     std::to_string(q.size()));
}

bool is_length(const Coordinate& coordinate) { return coordinate.kind == CoordinateKind::length; }

/// How fast each row changes at most when one body (or unknown) is displaced; 0 for a row that
/// compares angles.
VectorXd rates_by_displacement(const Phi& phi, const MatrixXd& J) {
  MatrixXd squares = MatrixXd::Zero(J.rows(), static_cast<Index>(phi.group_names().size()));
  for (Index k = 0; k < J.cols(); ++k) {
    const Coordinate& coordinate = phi.coordinates()[static_cast<std::size_t>(k)];
    if (!is_length(coordinate)) continue;
    squares.col(static_cast<Index>(coordinate.group)) += J.col(k).cwiseAbs2();
  }
  return squares.cols() == 0 ? VectorXd(VectorXd::Zero(J.rows()))
                             : VectorXd(squares.rowwise().maxCoeff().cwiseSqrt());
}

/// `length` for each coordinate that is a length, 1 for an angle.
VectorXd sizes_by(const Phi& phi, double length) {
  VectorXd sizes = VectorXd::Ones(phi.dimension());
  for (Index k = 0; k < phi.dimension(); ++k) {
    if (is_length(phi, k)) sizes[k] = length;
  }
  return sizes;
}

}  // namespace

double largest_length(const Mechanism& mechanism) { return largest_of(lengths_of(mechanism)); }

std::shared_ptr<const Constraint> joint_constraint(const Mechanism& mechanism, const Joint& joint,
                                                   const Dimension* moving) {
  return mechanism.space == Space::planar ? planar_joint(mechanism, joint, moving)
                                          : spatial_joint(mechanism, joint, moving);
}

std::shared_ptr<const Constraint> driver_constraint(const Mechanism& mechanism,
                                                    const Driver& driver, const Dimension* moving) {
  if (is_typed(mechanism)) return unknown_driver(mechanism, driver, moving);
  return mechanism.space == Space::planar ? planar_driver(mechanism, driver, moving)
                                          : spatial_driver(mechanism, driver, moving);
}

/// The line (q + s qdot, t + s tdot), s = 0.
struct Phi::Line {
  const VectorXd& q;
  const VectorXd* qdot;  ///< null: zero
  double t;
  double tdot;
};

Phi::Phi(const Mechanism& mechanism)
    : coordinates_(moivre::coordinates(of_whole_form(mechanism))),
      constraints_(joint_constraints(mechanism)),
      length_(largest_length(mechanism)),
      mean_length_(mean_of(lengths_of(mechanism))) {
  for (std::size_t body = 1; body < mechanism.bodies.size(); ++body) {
    group_names_.push_back(mechanism.bodies[body].name);
  }
  for (const Unknown& unknown : mechanism.unknowns) group_names_.push_back(unknown.name);
  for (const Spin& spin : mechanism.held_spins) {
    constraints_.push_back(spin_constraint(mechanism, spin));
  }
  for (std::size_t a = 0; a < mechanism.drivers.size(); ++a) {
    Dimension value;
    value.kind = DimensionKind::driver;
    value.driver = a;
    constraints_.push_back(driver_constraint(mechanism, mechanism.drivers[a]));
    moving_drivers_.push_back(driver_constraint(mechanism, mechanism.drivers[a], &value));
  }
  for (const auto& constraint : constraints_) {
    for (const RowLabel& label : constraint->labels) {
      row_names_.push_back(label.name);
      row_powers_.push_back(label.power);
    }
  }
  driver_size_ = static_cast<Index>(mechanism.drivers.size());
  timeless_ = mechanism.equations.empty() ? constraints_.size() - mechanism.drivers.size() : 0;
}

std::vector<std::vector<Index>> Phi::reads() const {
  std::vector<std::vector<Index>> columns;
  columns.reserve(row_names_.size());
  for (const auto& constraint : constraints_) {
    const auto& on = constraint->depends_on;
    columns.insert(columns.end(), constraint->labels.size(),
                   std::vector<Index>(on.begin(), on.end()));
  }
  return columns;
}

Phi Phi::without_drivers() const {
  Phi joints = *this;
  const auto drivers = static_cast<std::size_t>(driver_size_);
  joints.constraints_.resize(constraints_.size() - drivers);
  joints.row_names_.resize(row_names_.size() - drivers);
  joints.row_powers_.resize(row_names_.size() - drivers);
  joints.moving_drivers_.clear();
  joints.driver_size_ = 0;
  return joints;
}

/// Derivative of that order (0, 1, 2) of every row along the line.
VectorXd Phi::derivative(const Line& line, int order) const {
  require_size(line.q, dimension());
  if (line.qdot != nullptr) require_size(*line.qdot, dimension());
  std::vector<Jet> q(coordinates_.size());
  for (std::size_t k = 0; k < q.size(); ++k) {
    const auto i = static_cast<Index>(k);
    q[k] = Jet(line.q[i], line.qdot == nullptr ? 0 : (*line.qdot)[i], 0);
  }
  std::vector<Jet> rows(row_names_.size());
  Jet* row = rows.data();
  const std::size_t still = line.qdot == nullptr && order > 0 ? timeless_ : 0;
  for (std::size_t k = 0; k < constraints_.size(); ++k) {
    if (k >= still) constraints_[k]->evaluate(At<Jet>{q, Jet(line.t, line.tdot, 0)}, row);
    row += constraints_[k]->labels.size();
  }
  VectorXd result(size());
  for (Index i = 0; i < size(); ++i) {
    const Jet& jet = rows[static_cast<std::size_t>(i)];
    result[i] = order == 0 ? jet.f : order == 1 ? jet.d : jet.dd;
  }
  return result;
}

VectorXd Phi::value(const VectorXd& q, double t) const { return derivative({q, nullptr, t, 0}, 0); }

VectorXd Phi::partial_t(const VectorXd& q, double t) const {
  return derivative({q, nullptr, t, 1}, 1);
}

VectorXd Phi::partial_tt(const VectorXd& q, double t) const {
  return derivative({q, nullptr, t, 1}, 2);
}

VectorXd Phi::quadratic(const VectorXd& q, const VectorXd& qdot, double t) const {
  return derivative({q, &qdot, t, 0}, 2);
}

// The second derivative along (q', 1) is (Phi_q q')_q q' + 2 Phi_qt q' + Phi_tt.
VectorXd Phi::mixed(const VectorXd& q, const VectorXd& qdot, double t) const {
  return derivative({q, &qdot, t, 1}, 2) - quadratic(q, qdot, t) - partial_tt(q, t);
}

DriverRates Phi::driver_rates(const VectorXd& q, double t) const {
  DriverRates rates{MatrixXd::Zero(size(), driver_size_), MatrixXd::Zero(size(), driver_size_)};
  const std::vector<Jet> at(q.begin(), q.end());
  std::vector<Jet> rows(static_cast<std::size_t>(size()));
  Index first = size() - driver_size_;
  for (Index a = 0; a < driver_size_; ++a) {
    const Constraint& driver = *moving_drivers_[static_cast<std::size_t>(a)];
    driver.evaluate(At<Jet>{at, Jet(t)}, rows.data());
    for (const RowLabel& label : driver.labels) {
      const Jet& row = rows[static_cast<std::size_t>(&label - driver.labels.data())];
      rates.first(first, a) = row.d;
      rates.second(first, a) = row.dd;
      ++first;
    }
  }
  return rates;
}

VectorXd Phi::velocity_rhs(const VectorXd& q, double t) const { return -partial_t(q, t); }

VectorXd Phi::second_derivative(const VectorXd& q, const VectorXd& qdot, double t,
                                double tdot) const {
  return derivative({q, &qdot, t, tdot}, 2);
}

VectorXd Phi::acceleration_rhs(const VectorXd& q, const VectorXd& qdot, double t) const {
  return -second_derivative(q, qdot, t, 1);
}

/// A few columns at a time, and only the coordinates that a constraint reads.
void Phi::add_jacobian(const VectorXd& q, double t, MatrixXd& to) const {
  require_size(q, dimension());
  std::vector<Gradient> point(q.begin(), q.end());
  std::vector<Gradient> rows;
  Index first = 0;
  for (const auto& constraint : constraints_) {
    rows.resize(constraint->labels.size());
    const auto& on = constraint->depends_on;
    for (std::size_t begin = 0; begin < on.size(); begin += Gradient::kDirections) {
      const std::size_t count = std::min(Gradient::kDirections, on.size() - begin);
      for (std::size_t k = 0; k < count; ++k) point[on[begin + k]].d[k] = 1;
      constraint->evaluate(At<Gradient>{point, Gradient(t)}, rows.data());
      for (std::size_t k = 0; k < count; ++k) {
        point[on[begin + k]].d[k] = 0;
        for (std::size_t i = 0; i < rows.size(); ++i) {
          to(first + static_cast<Index>(i), static_cast<Index>(on[begin + k])) += rows[i].d[k];
        }
      }
    }
    first += static_cast<Index>(rows.size());
  }
}

MatrixXd Phi::jacobian(const VectorXd& q, double t) const {
  MatrixXd result = MatrixXd::Zero(size(), dimension());
  add_jacobian(q, t, result);
  return result;
}

MatrixXd Phi::extended_jacobian(const VectorXd& q, double t) const {
  MatrixXd result = MatrixXd::Zero(size(), dimension() + 1);
  add_jacobian(q, t, result);
  result.col(dimension()) = partial_t(q, t);
  return result;
}

VectorXd Phi::own_units() const {
  VectorXd units = VectorXd::Ones(dimension());
  for (Index k = 0; k < dimension(); ++k) {
    if (is_length(coordinates_[static_cast<std::size_t>(k)])) units[k] = mean_length_;
  }
  return units;
}

VectorXd Phi::own_row_units() const {
  VectorXd units(size());
  for (Index i = 0; i < size(); ++i) {
    units[i] = std::pow(mean_length_, row_powers_[static_cast<std::size_t>(i)]);
  }
  return units;
}

std::vector<Magnitude> Phi::magnitudes(const VectorXd& q, double t) const {
  require_size(q, dimension());
  const std::vector<Magnitude> point(q.begin(), q.end());
  std::vector<Magnitude> rows(row_names_.size());
  Magnitude* row = rows.data();
  for (const auto& constraint : constraints_) {
    constraint->evaluate(At<Magnitude>{point, Magnitude(t)}, row);
    row += constraint->labels.size();
  }
  return rows;
}

VectorXd Phi::term_magnitudes(const VectorXd& q, double t) const {
  const std::vector<Magnitude> rows = magnitudes(q, t);
  VectorXd result(size());
  for (Index i = 0; i < size(); ++i) result[i] = rows[static_cast<std::size_t>(i)].sum;
  return result;
}

VectorXd Phi::canonical(const VectorXd& q) const {
  constexpr double kTurn = 2 * std::numbers::pi;
  require_size(q, dimension());
  VectorXd result = q;
  for (Index k = 0; k < dimension(); ++k) {
    const Coordinate& coordinate = coordinates_[static_cast<std::size_t>(k)];
    if (coordinate.is_periodic) {
      result[k] -= kTurn * std::ceil((result[k] - std::numbers::pi) / kTurn);
    } else if (coordinate.kind == CoordinateKind::rotation_vector) {
      const double length = result.segment<3>(k).norm();
      if (length > std::numbers::pi) {
        result.segment<3>(k) *= 1 - kTurn * std::round(length / kTurn) / length;
      }
      k += 2;
    }
  }
  return result;
}

bool Phi::has_long_rotation(const VectorXd& q) const {
  constexpr double kLongest = 1.25 * std::numbers::pi;
  require_size(q, dimension());
  for (Index k = 0; k < dimension(); ++k) {
    if (coordinates_[static_cast<std::size_t>(k)].kind != CoordinateKind::rotation_vector) continue;
    if (q.segment<3>(k).norm() > kLongest) return true;
    k += 2;
  }
  return false;
}

void require_place(const Phi& phi, const VectorXd& q, double t) {
  require_size(q, phi.dimension());
  if (!q.allFinite()) throw InvalidInput("q has a number that is not finite");
  if (!std::isfinite(t)) throw InvalidInput("the time must be finite");
}

bool is_length(const Phi& phi, Index k) {
  return is_length(phi.coordinates()[static_cast<std::size_t>(k)]);
}

double size_of(const Phi& phi, const VectorXd& q) {
  double size = phi.length();
  for (Index k = 0; k < q.size(); ++k) {
    if (is_length(phi, k)) size = std::max(size, std::abs(q[k]));
  }
  return size;
}

VectorXd sizes_of(const Phi& phi, const VectorXd& q) { return sizes_by(phi, size_of(phi, q)); }

VectorXd own_sizes(const Phi& phi) { return sizes_by(phi, phi.length()); }

double scaled_residual(const Phi& phi, const VectorXd& q, double t) {
  double worst = 0;
  for (const Magnitude& row : phi.magnitudes(q, t)) {
    if (std::isnan(row.f)) return row.f;
    if (row.f != 0) worst = std::max(worst, std::abs(row.f) / row.sum);
  }
  return worst;
}

VectorXd row_sizes(const Phi& phi, const VectorXd& q, double t) {
  return phi.term_magnitudes(q, t) + phi.jacobian(q, t).cwiseAbs() * sizes_of(phi, q);
}

double residual_by_size(const Phi& phi, const VectorXd& q, double t) {
  constexpr double kRounding = 1e-13;
  const double plain = scaled_residual(phi, q, t);
  if (plain <= kRounding || std::isnan(plain)) return plain;
  const VectorXd value = phi.value(q, t);
  const VectorXd size = row_sizes(phi, q, t);
  double worst = 0;
  for (Index i = 0; i < phi.size(); ++i) {
    if (value[i] != 0) worst = std::max(worst, std::abs(value[i]) / size[i]);
  }
  return worst;
}

VectorXd misfit_units(const Phi& phi, const MatrixXd& jacobian) {
  VectorXd units = rates_by_displacement(phi, jacobian);
  for (double& unit : units) {
    if (unit == 0) unit = 1 / phi.length();
  }
  return units;
}

VectorXd row_misfits(const Phi& phi, const VectorXd& q, double t) {
  return phi.value(q, t).cwiseAbs().cwiseQuotient(misfit_units(phi, phi.jacobian(q, t)));
}

double misfit(const Phi& phi, const VectorXd& q, double t) {
  double worst = 0;
  for (const double miss : row_misfits(phi, q, t)) {
    if (std::isnan(miss)) return miss;
    worst = std::max(worst, miss);
  }
  return worst;
}

}  // namespace moivre
