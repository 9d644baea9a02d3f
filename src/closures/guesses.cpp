// SPDX-License-Identifier: MIT
// Closures and real roots as guesses; polynomials as formulas.
#include "moivre/closures/guesses.h"

#include "moivre/numeric/invalid_input.h"

namespace moivre {
namespace {

Formula number(double value) {
  Formula formula;
  formula.value = value;
  return formula;
}

Formula formula_of(const Power& power) {
  Formula base;
  base.kind = Formula::Kind::unknown;
  base.index = power.variable;
  if (power.exponent == 1) return base;
  Formula formula;
  formula.kind = Formula::Kind::power;
  formula.operands = {base, number(power.exponent)};
  return formula;
}

Formula formula_of(const Polynomial& p) {
  Formula sum;
  sum.kind = Formula::Kind::sum;
  for (const Term& term : p.terms) {
    Formula product;
    product.kind = Formula::Kind::product;
    product.operands.push_back(number(to_double(term.coefficient.re)));
    for (const Power& power : term.monomial) product.operands.push_back(formula_of(power));
    sum.operands.push_back(std::move(product));
  }
  return sum;
}

}  // namespace

InitialGuesses initial_guesses(const ClosureResult& result, const Mechanism& mechanism) {
  InitialGuesses all;
  for (const Coordinate& coordinate : coordinates(mechanism)) all.names.push_back(coordinate.name);
  for (const Closure& closure : result.closures) all.guesses.push_back({closure.id, closure.q});
  return all;
}

InitialGuesses initial_guesses(const SolveResult& result) {
  InitialGuesses all;
  all.names = result.system.variables;
  for (const Solution& solution : result.solutions) {
    if (!solution.real) continue;
    Eigen::VectorXd q(static_cast<Eigen::Index>(solution.x.size()));
    for (Eigen::Index k = 0; k < q.size(); ++k) {
      q[k] = solution.x[static_cast<std::size_t>(k)].real();
    }
    all.guesses.push_back({std::to_string(solution.path), q});
  }
  return all;
}

Mechanism typed_mechanism(const System& f) {
  if (!is_real(f)) {
    throw InvalidInput(
        "Newton-Raphson takes real coordinates, and the polynomials have "
        "coefficients that are not real");
  }
  Mechanism mechanism;
  for (const std::string& name : f.variables) mechanism.unknowns.push_back({name, false, {}});
  for (const Polynomial& p : f.polynomials) {
    Equation equation;
    equation.name = "equation " + std::to_string(mechanism.equations.size() + 1);
    equation.formula = formula_of(p);
    mechanism.equations.push_back(std::move(equation));
  }
  return mechanism;
}

}  // namespace moivre
