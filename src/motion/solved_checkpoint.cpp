// SPDX-License-Identifier: MIT
// Closures solved at checkpoints and between them, and the tracks that are there.
#include "solved_checkpoint.h"

#include <algorithm>

#include "moivre/closures/same_pose.h"

namespace moivre {
namespace {

// Rounding e parts a double root into two that are 2 sqrt(e) apart, at which the smallest singular
// value is sqrt(e) too.
constexpr double kParted = 4e-15;

/// Poses are told apart by their lengths: angles are known but for whole turns.
double number_of_lengths(const Phi& phi, const Eigen::VectorXd& q) {
  Point lengths;
  for (Eigen::Index k = 0; k < q.size(); ++k) {
    if (is_length(phi, k)) lengths.emplace_back(q[k]);
  }
  return number_of(lengths);
}

SolvedCheckpoint solve_checkpoint(const MotionRun& run, const Tracker& tracker, double time) {
  ClosureOptions options;
  options.time = time;
  options.solve = run.options.solve;
  options.certify = false;  // what is compared with branches needs no proof of its own
  return solved_checkpoint(run.phi, find_closures(run.mechanism, tracker, options, run.stop));
}

std::size_t count_distinct(const std::vector<Solution>& closures) {
  std::vector<double> numbers;
  for (const Solution& closure : closures) numbers.push_back(number_of(closure.x));
  const NearNumbers near(numbers);
  std::size_t distinct = 0;
  for (std::size_t k = 0; k < closures.size(); ++k) {
    const Point& x = closures[k].x;
    const double most = kParted * closures[k].condition * std::max(1.0, max_norm(x));
    bool is_first = true;
    near.visit_near(numbers[k], static_cast<double>(x.size()) * most, [&](std::size_t j) {
      is_first = is_first && (j >= k || max_distance(x, closures[j].x) > most);
    });
    distinct += is_first ? 1 : 0;
  }
  return distinct;
}

/// Calls visit(j, gap) for each closure that is the same pose as q.
template <class Visit>
void visit_same(const Phi& phi, const SolvedCheckpoint& solved, const Eigen::VectorXd& q,
                const Visit& visit) {
  // What is the same pose is hardly larger.
  const double reach = 2 * static_cast<double>(q.size()) * kSamePose * size_of(phi, q);
  solved.numbers.visit_near(number_of_lengths(phi, q), reach, [&](std::size_t j) {
    const double gap = distance(phi, q, solved.closures.closures[j].q);
    if (gap <= kSamePose) visit(j, gap);
  });
}

/// Whether a joint's limits hide a closure there.
bool hides_closures(const SolvedCheckpoint& solved) {
  const ClosureResult& all = solved.closures;
  return all.counts.real + all.counts.fitted + all.fitted_beyond_limits > all.closures.size();
}

bool is_crossing(const MotionRun& run, const SolvedCheckpoint& solved) {
  return std::any_of(run.tracks.begin(), run.tracks.end(), [&](const Track& track) {
    const auto events = track.events();
    return std::any_of(events.begin(), events.end(), [&](const BranchEvent* event) {
      return event->kind == EventKind::bifurcation && is_event_time(run, *event, solved.time);
    });
  });
}

}  // namespace

SolvedCheckpoint solved_checkpoint(const Phi& phi, ClosureResult closures) {
  std::vector<double> numbers;
  for (const Closure& closure : closures.closures) {
    numbers.push_back(number_of_lengths(phi, closure.q));
  }
  const double time = closures.time;
  const std::size_t count = numbers.size();
  const std::vector<Solution>& all = closures.solutions;
  const std::size_t distinct = count_distinct(all);
  const bool are_apart =
      distinct == all.size() &&
      std::none_of(all.begin(), all.end(), [](const Solution& one) { return one.singular; });
  return {time,
          std::move(closures),
          NearNumbers(numbers),
          std::vector<std::optional<std::size_t>>(count),
          distinct,
          are_apart};
}

std::optional<std::size_t> nearest_closure(const Phi& phi, const SolvedCheckpoint& solved,
                                           const Eigen::VectorXd& q) {
  std::optional<std::size_t> nearest;
  double least = kSamePose;
  visit_same(phi, solved, q, [&](std::size_t j, double gap) {
    if (gap > least) return;
    least = gap;
    nearest = j;
  });
  return nearest;
}

bool stands_alone(const Phi& phi, const SolvedCheckpoint& solved, std::size_t closure) {
  const Closure& it = solved.closures.closures[closure];
  bool is_alone = !it.singular;
  visit_same(phi, solved, it.q, [&](std::size_t j, double gap) {
    is_alone = is_alone && (j == closure || gap * it.smallest_singular_value > kParted);
  });
  return is_alone;
}

std::vector<SolvedCheckpoint> solve_checkpoints(const MotionRun& run, const Tracker& tracker) {
  std::vector<SolvedCheckpoint> checkpoints;
  const auto count = static_cast<double>(run.times.checkpoints.size());
  for (const double time : run.times.checkpoints) {
    if (run.stop) break;
    checkpoints.push_back(solve_checkpoint(run, tracker, time));
    run.show_progress(0.5 * static_cast<double>(checkpoints.size()) / count);
  }
  return checkpoints;
}

bool look_closer(MotionRun& run, const Tracker& tracker,
                 std::vector<SolvedCheckpoint>& checkpoints) {
  std::vector<double> times;
  for (std::size_t c = 1; c < checkpoints.size(); ++c) {
    const double from = checkpoints[c - 1].time;
    const double to = checkpoints[c].time;
    if (!hides_closures(checkpoints[c - 1]) && !hides_closures(checkpoints[c])) continue;
    for (int k = 1; k < kFiner; ++k) times.push_back(from + (to - from) * k / kFiner);
  }
  add_checkpoints(run, tracker, times, checkpoints);
  return !times.empty();
}

void add_checkpoints(MotionRun& run, const Tracker& tracker, const std::vector<double>& times,
                     std::vector<SolvedCheckpoint>& checkpoints) {
  for (const double time : times) {
    if (run.stop) return;
    run.add_time(time);
    checkpoints.push_back(solve_checkpoint(run, tracker, time));
  }
  std::sort(checkpoints.begin(), checkpoints.end(),
            [](const SolvedCheckpoint& a, const SolvedCheckpoint& b) { return a.time < b.time; });
}

std::vector<double> drop_crossings(const MotionRun& run,
                                   std::vector<SolvedCheckpoint>& checkpoints) {
  std::vector<double> times;
  std::erase_if(checkpoints, [&](const SolvedCheckpoint& solved) {
    const bool is_border = solved.time == run.options.from || solved.time == run.options.to;
    const bool is_clear = solved.closures.complete && solved.are_apart;
    if (is_clear || is_border || !is_crossing(run, solved)) return false;
    times.push_back(solved.time);
    return true;
  });
  return times;
}

std::optional<std::pair<std::size_t, std::size_t>> match(const MotionRun& run,
                                                         SolvedCheckpoint& solved) {
  std::optional<std::pair<std::size_t, std::size_t>> conflict;
  std::fill(solved.track_of.begin(), solved.track_of.end(), std::nullopt);
  for (std::size_t k = 0; k < run.tracks.size(); ++k) {
    const BranchSample* sample = run.tracks[k].at(solved.time);
    if (sample == nullptr) continue;
    const auto nearest = nearest_closure(run.phi, solved, sample->q);
    if (!nearest) continue;
    auto& owner = solved.track_of[*nearest];
    if (!owner) {
      owner = k;
    } else if (!conflict) {
      conflict = {*owner, k};
    }
  }
  return conflict;
}

}  // namespace moivre
