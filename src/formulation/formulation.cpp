// SPDX-License-Identifier: MIT
// Which formulation does a mechanism get, and what does a root of it say?
#include "moivre/formulation/formulation.h"

#include <cmath>

#include "isotropic_frame.h"
#include "moivre/mechanism/phi.h"
#include "moivre/numeric/near_points.h"
#include "moivre/polynomial/value.h"
#include "spatial_bodies.h"

namespace moivre {
Formulation formulate(const Mechanism& mechanism, double t) {
  require_drivers(mechanism, t);
  if (is_typed(mechanism)) return isotropic_equations(mechanism, t);
  Formulation formulation = mechanism.space == Space::spatial ? spatial_bodies(mechanism, t)
                                                              : isotropic_bodies(mechanism, t);
  formulation.length = largest_length(mechanism);
  return formulation;
}

ResidualOfRoots::ResidualOfRoots(const Formulation& formulation) : formulation_(formulation) {
  for (const Polynomial& p : formulation.system.polynomials) {
    equations_.push_back({&p, rounded_coefficients(p)});
  }
}

ResidualOfRoots::ResidualOfRoots(const Formulation& formulation,
                                 const std::vector<std::size_t>& equations)
    : formulation_(formulation) {
  for (const std::size_t e : equations) {
    const Polynomial& p = formulation.system.polynomials[e];
    equations_.push_back({&p, rounded_coefficients(p)});
  }
}

double ResidualOfRoots::operator()(const Point& root) const {
  double length = formulation_.length;
  for (std::size_t v = 0; v < root.size(); ++v) {
    if (!formulation_.is_direction[v]) length = std::max(length, std::abs(root[v]));
  }
  if (length == 0) length = 1;
  Point sizes;
  for (std::size_t v = 0; v < root.size(); ++v) {
    sizes.push_back(std::max(std::abs(root[v]), formulation_.is_direction[v] ? 1 : length));
  }
  double largest = 0;
  for (const auto& [p, coefficients] : equations_) {
    const double size = term_size(*p, coefficients, sizes);
    if (size > 0) largest = std::max(largest, std::abs(value_at(*p, coefficients, root)) / size);
  }
  return largest;
}

double residual_of_root(const Formulation& formulation, const Point& root) {
  return ResidualOfRoots(formulation)(root);
}

Eigen::VectorXd coordinates_of_root(const Formulation& formulation, const Point& root) {
  if (!formulation.poses.bodies.empty()) return coordinates_of_root(formulation.poses, root);
  using Part = Formulation::Reading::Part;
  Eigen::VectorXd q(static_cast<Eigen::Index>(formulation.coordinates.size()));
  for (Eigen::Index k = 0; k < q.size(); ++k) {
    const auto& reading = formulation.coordinates[static_cast<std::size_t>(k)];
    Complex z = value_at(reading.of, root);
    if (reading.f) z += reading.arm * reading.f(root);
    q[k] = reading.part == Part::re ? z.real() : reading.part == Part::im ? z.imag() : std::arg(z);
  }
  return q;
}

Point mirrored(const Formulation& formulation, const Point& root) {
  Point image(root.size());
  for (std::size_t v = 0; v < root.size(); ++v) image[v] = std::conj(root[formulation.mirror[v]]);
  return image;
}

double distance_from_real(const Formulation& formulation, const Point& root) {
  double direction = 1;
  double length = formulation.length;
  for (std::size_t v = 0; v < root.size(); ++v) {
    double& size = formulation.is_direction[v] ? direction : length;
    size = std::max(size, std::abs(root[v]));
  }
  if (length == 0) length = 1;
  const Point image = mirrored(formulation, root);
  double largest = 0;
  for (std::size_t v = 0; v < root.size(); ++v) {
    const double size = formulation.is_direction[v] ? direction : length;
    largest = std::max(largest, std::abs(root[v] - image[v]) / size);
  }
  return largest;
}

std::optional<double> share_left(const Formulation::Exclusion& exclusion,
                                 const std::vector<std::optional<Complex>>& values) {
  for (const Term& term : exclusion.of.terms) {
    for (const Power& power : term.monomial) {
      if (!values[power.variable]) return std::nullopt;
    }
  }
  Point root;
  for (const auto& value : values) root.push_back(value.value_or(0));
  const double terms = term_size(exclusion.of, root);
  return terms > 0 ? std::abs(value_at(exclusion.of, root)) / terms : 0;
}

}  // namespace moivre
