// SPDX-License-Identifier: MIT
// Unknowns, angle classes and products of powers of t, as bodies and typed equations both need them.
#include "isotropic_frame.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace moivre {

IsotropicFrame::IsotropicFrame(std::vector<std::string> names)
    : names_(std::move(names)), classes_(names_.size() + 1) {}

void IsotropicFrame::hold_angle(std::size_t i, std::size_t j, const Coefficient& factor,
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
    if (angle.root != node) t_[node] = angle.factor * t_[angle.root];
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
                              const Coefficient& value) {
  std::map<std::size_t, int> of_class;
  Coefficient rest = value;
  for (const auto& [node, exponent] : powers) {
    const SharedAngle angle = classes_.find(node);
    const Coefficient step = exponent < 0 ? angle.factor : conjugate(angle.factor);
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
  Polynomial right = constant(rest);
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

}  // namespace moivre
