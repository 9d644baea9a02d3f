// SPDX-License-Identifier: MIT
// Sub-chains solved one after another, their closures and roots put together.
#include "closure_product.h"

#include <algorithm>
#include <map>

#include "closure_poses.h"
#include "closure_roots.h"
#include "closure_sentences.h"
#include "moivre/closures/stages.h"
#include "moivre/closures/sub_chains.h"
#include "moivre/numeric/saturating.h"

namespace moivre {
namespace {

/// One index a sub-chain.
using Choice = std::vector<std::size_t>;

std::uint64_t all_of(const std::vector<std::size_t>& sizes) {
  std::uint64_t all = 1;
  for (const std::size_t size : sizes) all = saturating_product(all, size);
  return all;
}

/// All choices, the last index fastest, up to kMostListed; of more: the first of each, and for each
/// other index the first of the others;
/// last the one that was drawn.
std::vector<Choice> listed_choices(const std::vector<std::size_t>& sizes,
                                   const std::optional<Choice>& drawn) {
  std::vector<Choice> choices;
  const std::uint64_t all = all_of(sizes);
  if (all == 0) return choices;
  choices.emplace_back(sizes.size(), 0);
  if (all <= kMostListed) {
    while (choices.size() < all) {
      Choice next = choices.back();
      std::size_t k = sizes.size() - 1;
      for (; ++next[k] == sizes[k]; --k) next[k] = 0;
      choices.push_back(std::move(next));
    }
    return choices;
  }
  for (std::size_t k = 0; k < sizes.size(); ++k) {
    for (std::size_t i = 1; i < sizes[k]; ++i) {
      choices.push_back(choices.front());
      choices.back()[k] = i;
    }
  }
  const bool is_new = drawn && std::find(choices.begin(), choices.end(), *drawn) == choices.end();
  if (is_new) choices.push_back(*drawn);
  return choices;
}

/// The closure of each sub-chain that was drawn; nullopt where one has none.
std::optional<Choice> drawn_choice(const std::vector<ClosureResult>& parts) {
  Choice choice;
  for (const ClosureResult& part : parts) {
    const auto& all = part.closures;
    const auto drawn =
        std::find_if(all.begin(), all.end(), [](const Closure& one) { return one.is_drawn; });
    if (drawn == all.end()) return std::nullopt;
    choice.push_back(static_cast<std::size_t>(drawn - all.begin()));
  }
  return choice;
}

bool is_plain(const ClosureResult& part) {
  return part.complete && !part.moves && part.counts.complex > 0 && part.counts.fitted == 0 &&
         !part.least_misfit;
}

/// For each variable of the whole the sub-chain that has it, and its place there; empty where one
/// is in none.
std::vector<std::pair<std::size_t, std::size_t>> places_of_variables(
    const System& whole, const std::vector<ClosureResult>& parts) {
  std::map<std::string, std::pair<std::size_t, std::size_t>> known;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const auto& names = parts[k].system.variables;
    for (std::size_t v = 0; v < names.size(); ++v) known.try_emplace(names[v], k, v);
  }
  std::vector<std::pair<std::size_t, std::size_t>> places;
  for (const std::string& name : whole.variables) {
    const auto found = known.find(name);
    if (found == known.end()) return {};
    places.push_back(found->second);
  }
  return places;
}

/// The number of a path among all choices of one path of each sub-chain.
template <class PathOf>
std::uint64_t path_number(const std::vector<ClosureResult>& parts, const PathOf& path_of) {
  std::uint64_t number = 0;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const auto& stages = parts[k].stages;
    const std::uint64_t paths = stages.empty() ? 1 : stages.back().paths.tracked;
    number = saturating_product(number, std::max<std::uint64_t>(paths, 1)) + path_of(k);
  }
  return number;
}

/// Of the whole, where it is so of each part and known of each.
std::optional<bool> both(const std::optional<bool>& a, const std::optional<bool>& b) {
  return a && b ? std::optional(*a && *b) : std::nullopt;
}

/// That of the part of which least is known.
std::optional<RootCompleteness> least_complete(const std::vector<ClosureResult>& parts) {
  std::optional<RootCompleteness> least = RootCompleteness::proved;
  for (const ClosureResult& part : parts) {
    if (!part.completeness) return std::nullopt;
    least = std::max(*least, *part.completeness);
  }
  return least;
}

Solution solution_of(const std::vector<ClosureResult>& parts, const Choice& choice,
                     const std::vector<std::pair<std::size_t, std::size_t>>& places) {
  const auto part = [&](std::size_t k) -> const Solution& { return parts[k].solutions[choice[k]]; };
  Solution whole;
  for (const auto& [k, v] : places) whole.x.push_back(part(k).x[v]);
  whole.real = true;
  whole.certified = true;
  whole.path = path_number(parts, [&](std::size_t k) { return part(k).path; });
  for (std::size_t k = 0; k < parts.size(); ++k) {
    whole.real = whole.real && part(k).real;
    whole.certified = both(whole.certified, part(k).certified);
    whole.singular = whole.singular || part(k).singular;
    whole.cluster = whole.cluster || part(k).cluster;
    whole.multiplicity = saturating_product(whole.multiplicity, part(k).multiplicity);
    whole.residual = std::max(whole.residual, part(k).residual);
    whole.accuracy = std::max(whole.accuracy, part(k).accuracy);
    whole.condition = std::max(whole.condition, part(k).condition);
  }
  whole.winding = {static_cast<int>(whole.multiplicity)};
  return whole;
}

/// nullopt where Newton-Raphson on the whole does not confirm it.
std::optional<Closure> closure_of(const ClosureSearch& search,
                                  const std::vector<IndependentChain>& chains,
                                  const std::vector<ClosureResult>& parts, const Choice& choice) {
  Eigen::VectorXd q(search.phi.dimension());
  for (std::size_t k = 0; k < parts.size(); ++k) {
    q(chains[k].coordinates) = parts[k].closures[choice[k]].q;
  }
  const NewtonResult polished = newton(search.phi, q, search.options.time);
  if (polished.status != NewtonStatus::converged) return std::nullopt;
  Closure whole = closure_at(search, polished);
  whole.path = path_number(parts, [&](std::size_t k) { return parts[k].closures[choice[k]].path; });
  whole.certified = whole.is_drawn = true;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const Closure& part = parts[k].closures[choice[k]];
    whole.certified = both(whole.certified, part.certified);
    whole.newton_iterations = std::max(whole.newton_iterations, part.newton_iterations);
    whole.multiplicity = saturating_product(whole.multiplicity, part.multiplicity);
    whole.singular = whole.singular || part.singular;
    whole.is_drawn = whole.is_drawn && part.is_drawn;
    whole.cluster = whole.cluster || part.cluster;
    if (part.play) whole.play = std::max(whole.play.value_or(0), *part.play);
    whole.of.push_back(part.id);
    whole.id += (k == 0 ? "" : ".") + part.id;
  }
  return whole;
}

void add_account(const ClosureResult& part, ClosureResult& whole) {
  whole.paths += part.paths;
  if (part.start.source != StartFacts().source) whole.start.source = part.start.source;
  whole.start.paths += part.paths.tracked;
  whole.work += part.work;
  whole.stages.insert(whole.stages.end(), part.stages.begin(), part.stages.end());
  add_left_out(part.left_out, whole.left_out);
  append(part.reduced, whole.reduced);
  whole.time_s.threads = std::max(whole.time_s.threads, part.time_s.threads);
  add_solving(part.time_s, whole.time_s);
}

void tell_listed(ClosureResult& whole) {
  whole.all_listed = whole.counts.complex <= kMostListed;
  if (whole.all_listed) return;
  whole.left_out.push_back(combined_closures_left_out(kMostListed));
}

}  // namespace

void add_left_out(const std::vector<LeftOut>& part, std::vector<LeftOut>& whole) {
  for (const LeftOut& left : part) {
    const auto is_same = [&](const LeftOut& other) {
      return other.what == left.what && other.why == left.why;
    };
    if (std::none_of(whole.begin(), whole.end(), is_same)) whole.push_back(left);
  }
}

ClosureCounts product_of(const std::vector<ClosureCounts>& parts) {
  ClosureCounts whole;
  whole.complex = whole.real = 1;
  std::uint64_t within_limits = 1;
  std::uint64_t usable = 1;
  for (const ClosureCounts& part : parts) {
    whole.complex = saturating_product(whole.complex, part.complex);
    whole.real = saturating_product(whole.real, part.real);
    within_limits = saturating_product(within_limits, part.real - part.filtered);
    usable = saturating_product(usable, part.real - part.filtered + part.fitted);
    whole.rejected += part.rejected;
  }
  whole.filtered = whole.real - within_limits;
  whole.fitted = usable - within_limits;
  return whole;
}

bool solve_apart(ClosureSearch& search) {
  const std::vector<IndependentChain> chains = independent_chains(search.mechanism);
  if (chains.empty() || !search.formulation.contradictions.empty()) return false;
  std::vector<ClosureResult> parts;
  for (const IndependentChain& chain : chains) {
    parts.push_back(find_closures(chain.mechanism, search.tracker, search.options, search.stop));
    if (!is_plain(parts.back())) return false;
  }
  const auto places = places_of_variables(search.formulation.system, parts);
  if (places.empty()) return false;
  std::vector<std::size_t> closures;
  std::vector<std::size_t> solutions;
  std::vector<ClosureCounts> counts;
  for (const ClosureResult& part : parts) {
    counts.push_back(part.counts);
    closures.push_back(part.closures.size());
    solutions.push_back(part.solutions.size());
  }
  std::vector<Closure> found;
  for (const Choice& choice : listed_choices(closures, drawn_choice(parts))) {
    std::optional<Closure> closure = closure_of(search, chains, parts, choice);
    if (!closure) return false;
    found.push_back(std::move(*closure));
  }
  ClosureResult& whole = search.result;
  whole.closures = std::move(found);
  if (all_of(closures) <= kMostListed) letter(whole.closures, search.phi);
  for (const Choice& choice : listed_choices(solutions, std::nullopt)) {
    whole.solutions.push_back(solution_of(parts, choice, places));
  }
  whole.counts = product_of(counts);
  whole.completeness = least_complete(parts);
  for (std::size_t k = 0; k < parts.size(); ++k) {
    add_account(parts[k], whole);
    whole.sub_chains.push_back(
        {chains[k], parts[k].counts, parts[k].paths, std::move(parts[k].closures)});
  }
  whole.reduced.total_degree = total_degree(whole.reduced.degrees);
  tell_listed(whole);
  return true;
}

}  // namespace moivre
