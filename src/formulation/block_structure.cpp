// SPDX-License-Identifier: MIT
// Bipartite matching by augmenting paths, then strongly connected components.
#include "moivre/formulation/block_structure.h"

#include <algorithm>
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/strong_components.hpp>
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

/// Strongly connected equations that are matched, where one needs those that are matched with its
/// other variables; needed ones first.
std::vector<Block> blocks_of(const Incidence& variables, const Matching& matching) {
  using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS>;
  Graph needs(variables.size());
  for (std::size_t e = 0; e < variables.size(); ++e) {
    if (!matching.variable_of()[e]) continue;
    for (const std::size_t v : variables[e]) {
      if (const auto needed = matching.equation_of()[v]) boost::add_edge(e, *needed, needs);
    }
  }
  std::vector<std::size_t> component(variables.size());
  const std::size_t count = boost::strong_components(
      needs,
      boost::make_iterator_property_map(component.begin(), boost::get(boost::vertex_index, needs)));
  std::vector<Block> blocks(count);
  for (std::size_t e = 0; e < variables.size(); ++e) {
    const auto v = matching.variable_of()[e];
    if (!v) continue;
    blocks[component[e]].equations.push_back(e);
    blocks[component[e]].variables.push_back(*v);
  }
  std::erase_if(blocks, [](const Block& block) { return block.equations.empty(); });
  for (Block& block : blocks) std::sort(block.variables.begin(), block.variables.end());
  return blocks;
}

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
  structure.blocks = blocks_of(variables, matching);
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
