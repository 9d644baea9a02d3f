// SPDX-License-Identifier: MIT
// Unknowns, angle classes and products of powers of t, as bodies and typed equations both need
// them.
#include "isotropic_frame.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace moivre {

IsotropicFrame::IsotropicFrame(std::vector<std::string> names, bool has_factors)
    : names_(std::move(names)), classes_(names_.size() + 1), has_factors_(has_factors) {}

Polynomial IsotropicFrame::enclosed(const Polynomial& p, double error) {
  if (!has_factors_ || error == 0) return p;
  factor_errors_.push_back(error);
  return p * unknown(kFirstFactor + static_cast<std::uint32_t>(factor_errors_.size() - 1));
}

Mirrored IsotropicFrame::enclosed(const Mirrored& z, double error) {
  return {enclosed(z.z, error), enclosed(z.conjugate, error)};
}

Polynomial IsotropicFrame::number(const EnclosedNumber& number) {
  const Polynomial value = constant({number.value, 0});
  if (!has_factors_ || number.error == 0) return value;
  return value + (enclosed(constant({1, 0}), number.error) - constant({1, 0}));
}

void IsotropicFrame::hold_angle(std::size_t i, std::size_t j, const EnclosedUnit& factor,
                                const std::string& name) {
  switch (classes_.join(i, j, factor)) {
    case AngleClasses::Verdict::joined:
      return;
    case AngleClasses::Verdict::repeated:
      result().left_out.emplace_back(name, "its angle is already held at the same value");
      return;
    case AngleClasses::Verdict::contradiction:
      contradict(name);
      return;
  }
}

void IsotropicFrame::contradict(const std::string& name) {
  result().contradictions.push_back(name + " holds an angle that is already held at another value");
}

void IsotropicFrame::add_angles() {
  t_.assign(names_.size() + 1, {constant({1, 0}), constant({1, 0})});
  for (std::size_t node = 1; node <= names_.size(); ++node) {
    if (classes_.find(node).root != node) continue;
    std::vector<std::string> owners;
    for (std::size_t member = 1; member <= names_.size(); ++member) {
      if (classes_.find(member).root == node) owners.push_back(names_[member - 1]);
    }
    const std::string& name = names_[node - 1];
    t_[node] = add_pair({"t_" + name, "u_" + name}, true, owners);
    add_equation("unit " + name, t_[node].z * t_[node].conjugate - constant({1, 0}));
  }
  for (std::size_t node = 1; node <= names_.size(); ++node) {
    const SharedAngle angle = classes_.find(node);
    if (angle.root == node) continue;
    t_[node] = enclosed(angle.factor.value * t_[angle.root], angle.factor.error);
  }
}

Mirrored IsotropicFrame::add_pair(const std::array<std::string, 2>& names, bool is_direction,
                                  const std::vector<std::string>& owners) {
  const std::uint32_t z = add_variable(names[0], is_direction, owners);
  const std::uint32_t image = add_variable(names[1], is_direction, owners);
  std::swap(result().mirror[z], result().mirror[image]);
  return {unknown(z), unknown(image)};
}

void IsotropicFrame::add_equation(const std::string& name, Polynomial p) {
  if (p.terms.empty()) {
    result().left_out.emplace_back(name, "with the angles that are held it is 0 = 0");
    return;
  }
  enter(name, std::move(p));
}

void IsotropicFrame::add_equations(const std::string& name, const Mirrored& z) {
  add_equation(name, z.z);
  add_equation(name + ", conjugate", z.conjugate);
}

void IsotropicFrame::add_turn(const std::string& name,
                              const std::vector<std::pair<std::size_t, int>>& powers,
                              const EnclosedUnit& value) {
  std::map<std::size_t, int> of_class;
  EnclosedUnit rest = value;
  for (const auto& [node, exponent] : powers) {
    const SharedAngle angle = classes_.find(node);
    const EnclosedUnit step = exponent < 0 ? angle.factor : conjugate(angle.factor);
    for (int k = 0; k < std::abs(exponent); ++k) rest = rest * step;
    if (angle.root != 0) of_class[angle.root] += exponent;
  }
  std::vector<std::pair<int, std::size_t>> by_size;
  for (const auto& [root, exponent] : of_class) {
    if (exponent != 0) by_size.emplace_back(exponent, root);
  }
  if (by_size.empty()) {
    hold_angle(0, 0, rest, name);
    return;
  }
  std::sort(by_size.begin(), by_size.end(),
            [](const auto& a, const auto& b) { return std::abs(a.first) > std::abs(b.first); });
  Polynomial left = constant({1, 0});
  Polynomial right = enclosed(constant(rest.value), rest.error);
  int left_degree = 0;
  int right_degree = 0;
  for (const auto& [exponent, root] : by_size) {
    const bool to_left = left_degree <= right_degree;
    // t^e on the left is u^e on the right, and u = 1/t.
    const Polynomial& base = (exponent > 0) == to_left ? t_[root].z : t_[root].conjugate;
    const Polynomial factor = power(base, std::abs(exponent));
    (to_left ? left : right) = (to_left ? left : right) * factor;
    (to_left ? left_degree : right_degree) += std::abs(exponent);
  }
  add_equation(name, left - right);
}

Polynomial power(const Polynomial& p, int exponent) {
  Polynomial result = constant({1, 0});
  for (int k = 0; k < exponent; ++k) result = result * p;
  return result;
}

EnclosedPolynomials with_factors(const Formulation& formulation, const IsotropicFrame& frame) {
  const Formulation& with = frame.result();
  const auto unknowns = static_cast<std::uint32_t>(formulation.system.variables.size());
  const auto is_there = [](const Polynomial& p, const Monomial& m) {
    return std::any_of(p.terms.begin(), p.terms.end(),
                       [&](const Term& term) { return term.monomial == m; });
  };
  EnclosedPolynomials result{{}, frame.factor_errors(), true};
  std::size_t next = 0;
  for (std::size_t k = 0; k < formulation.equation_names.size(); ++k) {
    // What says 0 = 0 without factors is left out there.
    while (with.equation_names.at(next) != formulation.equation_names[k]) ++next;
    Polynomial p = with.system.polynomials[next++];
    for (Term& term : p.terms) {
      const auto factors =
          std::find_if(term.monomial.begin(), term.monomial.end(),
                       [](const Power& power) { return power.variable >= kFirstFactor; });
      const Monomial of_unknowns(term.monomial.begin(), factors);
      if (!is_there(formulation.system.polynomials[k], of_unknowns)) result.has_same_terms = false;
      std::for_each(factors, term.monomial.end(), [&](Power& power) {
        power.variable = power.variable - kFirstFactor + unknowns;
      });
    }
    result.polynomials.push_back(std::move(p));
  }
  return result;
}

}  // namespace moivre
