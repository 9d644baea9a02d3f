// SPDX-License-Identifier: MIT
// Bipartite matching by augmenting paths, then strongly connected components by Tarjan.
#include "moivre/formulation/block_structure.h"

#include <algorithm>
#include <optional>

namespace moivre {
namespace {

using Incidence = std::vector<std::vector<std::size_t>>;  // variables of each equation

Incidence incidence(const System& f) {
  Incidence variables;
  for (const Polynomial& p : f.polynomials) {
    std::vector<std::size_t> of_p;
    for (const Term& term : p.terms) {
      for (const Power& power : term.monomial) of_p.push_back(power.variable);
    }
    std::sort(of_p.begin(), of_p.end());
    of_p.erase(std::unique(of_p.begin(), of_p.end()), of_p.end());
    variables.push_back(std::move(of_p));
  }
  return variables;
}

class Matching {
 public:
  Matching(const Incidence& variables, std::size_t size)
      : variables_(variables), equation_of_(size), variable_of_(variables.size()) {
    for (std::size_t e = 0; e < variables.size(); ++e) {
      visited_.assign(size, false);
      augment(e);
    }
  }

  const std::vector<std::optional<std::size_t>>& equation_of() const { return equation_of_; }
  const std::vector<std::optional<std::size_t>>& variable_of() const { return variable_of_; }

 private:
  bool augment(std::size_t e) {
    for (const std::size_t v : variables_[e]) {
      if (visited_[v]) continue;
      visited_[v] = true;
      if (equation_of_[v] && !augment(*equation_of_[v])) continue;
      equation_of_[v] = e;
      variable_of_[e] = v;
      return true;
    }
    return false;
  }

  const Incidence& variables_;
  std::vector<std::optional<std::size_t>> equation_of_;
  std::vector<std::optional<std::size_t>> variable_of_;
  std::vector<bool> visited_;
};

/// Tarjan's algorithm on equations: e needs the equation that is matched with each of its other variables.
class Components {
 public:
  Components(const Incidence& variables, const Matching& matching)
      : variables_(variables),
        matching_(matching),
        order_(variables.size(), 0),
        low_(variables.size(), 0),
        on_stack_(variables.size(), false) {
    for (std::size_t e = 0; e < variables.size(); ++e) {
      if (matching.variable_of()[e] && order_[e] == 0) visit(e);
    }
  }

  std::vector<Block> take() && { return std::move(blocks_); }

 private:
  void visit(std::size_t e) {
    order_[e] = low_[e] = ++count_;
    stack_.push_back(e);
    on_stack_[e] = true;
    for (const std::size_t v : variables_[e]) {
      const auto needed = matching_.equation_of()[v];
      if (!needed) continue;
      if (order_[*needed] == 0) {
        visit(*needed);
        low_[e] = std::min(low_[e], low_[*needed]);
      } else if (on_stack_[*needed]) {
        low_[e] = std::min(low_[e], order_[*needed]);
      }
    }
    if (low_[e] == order_[e]) close(e);
  }

  void close(std::size_t root) {
    Block block;
    std::size_t e = root;
    do {
      e = stack_.back();
      stack_.pop_back();
      on_stack_[e] = false;
      block.equations.push_back(e);
      block.variables.push_back(*matching_.variable_of()[e]);
    } while (e != root);
    std::sort(block.equations.begin(), block.equations.end());
    std::sort(block.variables.begin(), block.variables.end());
    blocks_.push_back(std::move(block));
  }

  const Incidence& variables_;
  const Matching& matching_;
  std::vector<std::size_t> order_;  // 0: not visited
  std::vector<std::size_t> low_;
  std::vector<bool> on_stack_;
  std::vector<std::size_t> stack_;
  std::size_t count_ = 0;
  std::vector<Block> blocks_;
};

/// Which unknowns are free, or tied to a free one by the equation that is matched with them?
std::vector<bool> reached_from_free(const Incidence& variables, const Matching& matching) {
  std::vector<bool> reached(matching.equation_of().size());
  for (std::size_t v = 0; v < reached.size(); ++v) reached[v] = !matching.equation_of()[v];
  for (bool has_grown = true; has_grown;) {
    has_grown = false;
    for (std::size_t e = 0; e < variables.size(); ++e) {
      const auto matched = matching.variable_of()[e];
      if (!matched || reached[*matched]) continue;
      reached[*matched] = std::any_of(variables[e].begin(), variables[e].end(),
                                      [&](std::size_t v) { return reached[v]; });
      has_grown |= reached[*matched];
    }
  }
  return reached;
}

}  // namespace

BlockStructure block_structure(const System& f) {
  const Incidence variables = incidence(f);
  const Matching matching(variables, f.variables.size());
  BlockStructure structure;
  structure.blocks = Components(variables, matching).take();
  const std::vector<bool> reached = reached_from_free(variables, matching);
  for (Block& block : structure.blocks) {
    block.is_determined = std::none_of(block.variables.begin(), block.variables.end(),
                                       [&](std::size_t v) { return reached[v]; });
  }
  for (std::size_t v = 0; v < f.variables.size(); ++v) {
    if (!matching.equation_of()[v]) structure.free_variables.push_back(v);
  }
  for (std::size_t e = 0; e < f.polynomials.size(); ++e) {
    if (!matching.variable_of()[e]) structure.spare_equations.push_back(e);
  }
  return structure;
}

}  // namespace moivre
