// SPDX-License-Identifier: MIT
// The counts of all starts, the model of their costs, and the plan of the cheapest.
#include "moivre/start/choose_start.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "moivre/numeric/invalid_input.h"
#include "moivre/start/infinity.h"
#include "moivre/start/multihomogeneous_plan.h"
#include "moivre/start/polyhedral.h"

namespace moivre {
namespace {

// In units of one path of one stage to a finite root.
constexpr double kInfinityCost = 3;
constexpr double kPolyhedralCost = 1.2;
// Multiply-adds of one path: steps, each an elimination and some products a term.
constexpr double kStepsOfAPath = 80;
constexpr double kProductsOfATerm = 20;
// Multiply-adds of one step of the search for cells, a term and an unknown.
constexpr double kSearchStepCost = 10;
// So many multiply-adds, a few milliseconds, a search may take before anything else is counted.
constexpr double kQuickSearchCost = 5e6;
// Partitions of so few unknowns are all tried in less.
constexpr std::size_t kFewUnknowns = 6;
// A search asked for by name, or by moivre info, may take so many steps: a minute or so.
constexpr std::uint64_t kLongSearch = 100'000'000;
// And so many multiply-adds, less than a minute.
constexpr double kLongSearchCost = 5e10;
// Degrees and supports are tables, a column an unknown: of more entries than this they take
// gigabytes.
constexpr double kMostExponents = 1e8;

const char* const kNotAsked = "not needed for the start that was asked for";

double search_step_cost(const System& f) {
  return kSearchStepCost * static_cast<double>(f.variables.size()) *
         static_cast<double>(term_count(f));
}

double path_cost(const System& f) {
  const auto n = static_cast<double>(f.variables.size() + 1);
  return kStepsOfAPath * (n * n * n + kProductsOfATerm * static_cast<double>(term_count(f)));
}

class Chooser {
 public:
  Chooser(const System& f, const StartChoiceOptions& options) : f_(f), options_(options) {
    const auto paths = total_degree(degrees(f));
    chosen_.counts.total_degree = {paths, paths ? "" : "beyond 64 bits"};
    chosen_.counts.multihomogeneous.missing = kNotAsked;
    chosen_.counts.mixed_volume.missing = kNotAsked;
  }

  ChosenStart choose() {
    switch (options_.kind) {
      case StartKind::total_degree:
        take_total_degree("asked for");
        break;
      case StartKind::multihomogeneous:
        count_multihomogeneous();
        take_multihomogeneous("asked for");
        break;
      case StartKind::polyhedral:
        count_cells(std::numeric_limits<std::uint64_t>::max());
        take_polyhedral("asked for");
        break;
      case StartKind::automatic:
        choose_automatically();
        break;
    }
    return std::move(chosen_);
  }

  StartCounts count() {
    const auto n = static_cast<double>(f_.variables.size());
    if (n * static_cast<double>(term_count(f_)) > kMostExponents) {
      for (StartCount* count : {&chosen_.counts.multihomogeneous, &chosen_.counts.mixed_volume}) {
        count->missing = "the table of degrees would take gigabytes";
      }
      return chosen_.counts;
    }
    count_multihomogeneous();
    const double steps = kLongSearchCost / search_step_cost(f_);
    if (!is_dense()) {
      count_cells(static_cast<std::uint64_t>(std::min(static_cast<double>(kLongSearch), steps)));
    }
    return chosen_.counts;
  }

 private:
  /// No root at infinity: the degrees' product is the mixed volume.
  bool is_dense() {
    if (!chosen_.counts.total_degree.paths) return false;
    const auto meets = meets_infinity(start_supports(f_));
    if (!meets || *meets) return false;
    chosen_.counts.mixed_volume = chosen_.counts.total_degree;
    return true;
  }

  void count_multihomogeneous(std::uint64_t most_work = kMostSearchWork) {
    search_ = find_partition(f_, most_work);
    chosen_.counts.multihomogeneous = {search_.paths, search_.paths ? "" : "beyond 64 bits"};
    // A number that more work may make much less would tell a reader little.
    if (search_.is_cut && search_.paths != chosen_.counts.mixed_volume.paths) {
      chosen_.counts.multihomogeneous = {std::nullopt,
                                         "the search cost more than such a start could save"};
    }
  }

  void count_cells(std::uint64_t most_steps) {
    CellSearchOptions search;
    search.stop = options_.stop;
    search.progress = options_.progress;
    search.most_steps = most_steps;
    CellSearch found = start_cells(f_, options_.seed, search);
    StartCount& count = chosen_.counts.mixed_volume;
    count.missing = found.subdivision ? "" : description(found.end);
    was_interrupted_ = found.end == CellSearchEnd::interrupted;
    if (!found.subdivision) return;
    cells_ = std::move(*found.subdivision);
    count.paths = cells_->mixed_volume;
  }

  std::uint64_t one_stage_paths() const {
    const auto& total = chosen_.counts.total_degree.paths;
    const auto& groups = chosen_.counts.multihomogeneous.paths;
    constexpr auto kNone = std::numeric_limits<std::uint64_t>::max();
    return std::min(total.value_or(kNone), groups.value_or(kNone));
  }

  static double one_stage_cost(std::uint64_t paths, std::uint64_t mixed_volume) {
    const auto roots = static_cast<double>(mixed_volume);
    return roots + kInfinityCost * (static_cast<double>(paths) - roots);
  }

  std::uint64_t quick_search_steps() const {
    if (f_.variables.size() <= kFewUnknowns) return 0;
    return static_cast<std::uint64_t>(kQuickSearchCost / search_step_cost(f_));
  }

  /// What a start of one stage may save beside the cells that are known: work of a search for its
  /// groups.
  std::uint64_t worth_of_one_stage() const {
    const auto paths = (kPolyhedralCost - 1) * static_cast<double>(cells_->mixed_volume);
    return static_cast<std::uint64_t>(std::min(paths * static_cast<double>(kSearchWorkPerPath),
                                               static_cast<double>(kMostSearchWork)));
  }

  void choose_automatically() {
    if (is_dense()) {
      chosen_.counts.multihomogeneous.missing = "not needed: the degrees tell the mixed volume";
      take_total_degree("no system of these monomials has fewer roots for generic coefficients");
      return;
    }
    count_cells(std::min(search_steps_for(f_, one_stage_paths()), quick_search_steps()));
    if (was_interrupted_) return;
    if (cells_) {
      count_multihomogeneous(worth_of_one_stage());
    } else {
      count_multihomogeneous();
      count_cells(search_steps_for(f_, one_stage_paths()));
    }
    if (was_interrupted_) return;
    if (!cells_) {
      take_one_stage("the search for mixed cells was given up: it had cost what these paths do");
      return;
    }
    const std::uint64_t volume = cells_->mixed_volume;
    const double other = one_stage_cost(one_stage_paths(), volume);
    if (kPolyhedralCost * static_cast<double>(volume) < other) {
      take_polyhedral("the fewest paths that the monomials allow, in two stages each");
    } else {
      take_one_stage("hardly more paths than the monomials allow, in one stage each");
    }
  }

  void take_one_stage(const std::string& why) {
    const auto& total = chosen_.counts.total_degree.paths;
    const auto& groups = chosen_.counts.multihomogeneous.paths;
    if (groups && (!total || *groups < *total)) {
      if (auto plan = multihomogeneous_plan(f_, search_.groups, options_.seed)) {
        chosen_.plan = std::move(plan);
        chosen_.why = why;
        return;
      }
      if (cells_) return take_polyhedral("the other starts have more paths or too many terms");
    }
    take_total_degree(why);
  }

  void take_total_degree(const std::string& why) {
    chosen_.plan = total_degree_plan(f_, options_.seed);
    chosen_.why = why;
  }

  void take_multihomogeneous(const std::string& why) {
    if (!search_.paths) {
      throw std::overflow_error("the multihomogeneous Bezout number does not fit into 64 bits");
    }
    if (search_.groups.size() == 1) {
      return take_total_degree("no partition has fewer paths than one group: the total degree");
    }
    chosen_.plan = multihomogeneous_plan(f_, search_.groups, options_.seed);
    chosen_.why = why;
    if (chosen_.plan) return;
    throw InvalidInput(
        "the multihomogeneous start system has too many terms to be multiplied out; try `start` "
        "polyhedral");
  }

  void take_polyhedral(const std::string& why) {
    if (was_interrupted_) return;
    if (!cells_) {
      throw std::overflow_error(std::string("there is no polyhedral start: ") +
                                chosen_.counts.mixed_volume.missing);
    }
    chosen_.plan = polyhedral_plan(f_, std::move(*cells_), options_.seed);
    chosen_.why = why;
  }

  const System& f_;
  const StartChoiceOptions& options_;
  PartitionSearch search_;
  std::optional<MixedSubdivision> cells_;
  bool was_interrupted_ = false;
  ChosenStart chosen_;
};

}  // namespace

double cost_of_paths(const System& f, std::uint64_t paths) {
  return kInfinityCost * static_cast<double>(paths) * path_cost(f);
}

std::uint64_t search_steps_for(const System& f, std::uint64_t paths) {
  return static_cast<std::uint64_t>(std::min(cost_of_paths(f, paths) / search_step_cost(f), 1e18));
}

ChosenStart choose_start(const System& f, const StartChoiceOptions& options) {
  return Chooser(f, options).choose();
}

StartCounts count_starts(const System& f, const StartChoiceOptions& options) {
  return Chooser(f, options).count();
}

}  // namespace moivre
