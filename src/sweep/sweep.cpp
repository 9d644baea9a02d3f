// SPDX-License-Identifier: MIT
// Samples on a grid on several threads, and bisection between those that differ.
#include "moivre/sweep/sweep.h"

#include <atomic>
#include <cmath>
#include <exception>
#include <functional>
#include <map>
#include <mutex>
#include <stdexcept>

#include "moivre/mechanism/dimensions.h"
#include "moivre/numeric/invalid_input.h"
#include "moivre/numeric/stopwatch.h"
#include "moivre/numeric/threads.h"
#include "observed_samples.h"

namespace moivre {
namespace {

constexpr std::size_t kMostSamples = 1'000'000;
// Borders between two samples: more are not looked for.
constexpr std::size_t kMostBorders = 16;

/// What processes do together. The outcome of a job during which a family was learned is empty:
/// every process solves it, so that all come to the same families.
struct SweepJobs {
  Fingerprint list;
  std::size_t count = 0;
  std::function<bool(std::size_t k)> is_known;  ///< it needs no time
  std::function<std::string(std::size_t k)> solve;
  std::function<void(std::size_t k, std::string_view outcome)> take;
};

class Sweep {
 public:
  Sweep(const Mechanism& mechanism, const std::vector<Varied>& varied, const Tracker& tracker,
        FamilyBook& book, const SweepOptions& options, const std::atomic<bool>& stop)
      : mechanism_(mechanism),
        varied_(varied),
        tracker_(tracker),
        book_(book),
        options_(options),
        closures_(options.closures),
        observed_(varied, tracker, options),
        stop_(stop) {
    closures_.starts = &book;
    closures_.solve.threads = 1;
    closures_.certify = false;  // counts of many members
    closures_.solve.progress = nullptr;
    closures_.solve.observations = nullptr;  // whole samples are kept
  }

  const ObservedSamples& observed() const { return observed_; }
  std::size_t learned() const { return book_.learned(); }
  bool is_stopped() const { return stop_; }

  SweepSample sample(std::vector<double> at) const {
    if (auto known = observed_.recall(at)) return std::move(*known);
    const std::size_t learned = book_.learned();
    SweepSample sample = solved(std::move(at));
    if (book_.learned() == learned && !stop_) observed_.keep(sample);
    return sample;
  }

  SweepSample solved(std::vector<double> at) const {
    Mechanism mechanism = mechanism_;
    for (std::size_t j = 0; j < varied_.size(); ++j) {
      set_dimension(mechanism, varied_[j].name, at[j]);
    }
    const ClosureResult result = find_closures(mechanism, tracker_, closures_, stop_);
    SweepSample sample;
    sample.at = std::move(at);
    sample.complex = result.counts.complex;
    sample.found = {result.counts.real, result.counts.filtered, result.counts.fitted,
                    result.moves.has_value()};
    sample.complete = result.complete;
    if (options_.keep_closures) {
      for (const Closure& closure : result.closures) sample.closures.push_back(closure.q);
    }
    return sample;
  }

  /// All jobs of a list, on all threads and by all processes, told as progress. What a value makes
  /// the mechanism refuse is thrown, and what the callback throws.
  void do_all(const SweepJobs& jobs) {
    std::atomic<std::size_t> next{0};
    std::size_t done = 0;
    std::mutex mutex;
    std::exception_ptr refusal;
    const auto one = [&](const std::function<void()>& f) {
      std::exception_ptr thrown;
      try {
        f();
      } catch (...) {
        thrown = std::current_exception();
      }
      const std::lock_guard lock(mutex);
      if (refusal) return false;
      refusal = thrown;
      try {
        if (!refusal && options_.progress) options_.progress(++done, jobs.count);
      } catch (...) {
        refusal = std::current_exception();
      }
      return refusal == nullptr;
    };
    const auto require_none_refused = [&] {
      if (refusal) std::rethrow_exception(refusal);
    };
    Observations* const observations = observed_.observations();
    const auto shares = observations != nullptr && jobs.count > 1
                            ? observations->share(jobs.list, jobs.count)
                            : std::unique_ptr<JobShares>();
    const auto draw = [&]() -> std::optional<std::size_t> {
      if (shares) return shares->draw();
      const std::size_t k = next++;
      return k < jobs.count ? std::optional(k) : std::nullopt;
    };
    const auto do_one = [&](std::size_t k) {
      return one([&] {
        std::string outcome = jobs.solve(k);
        if (shares && !stop_) shares->tell(k, std::move(outcome));
      });
    };
    const auto do_mine = [&] {
      on_threads(thread_count(options_.closures.solve.threads), [&] {
        while (!stop_) {
          const auto k = draw();
          if (!k || !do_one(*k)) return;
        }
      });
      require_none_refused();
    };
    if (!shares) return do_mine();
    for (std::size_t k = 0; k < jobs.count; ++k) {
      if (jobs.is_known(k) && !do_one(k)) require_none_refused();
    }
    do_together(*shares, stop_, do_mine, [&](const ToldOutcome& told) {
      one([&] {
        if (told.bytes.empty()) {
          jobs.solve(told.job);
        } else {
          jobs.take(told.job, told.bytes);
        }
      });
      require_none_refused();
    });
    if (!stop_) observations->lists_are_done();
  }

  /// Between a and b, which differ in the number `along`, to `width`.
  void sharpen(const SweepSample& a, const SweepSample& b, std::size_t along, double width,
               std::vector<SweepBorder>& borders) const {
    if (a.found == b.found || !a.complete || !b.complete || stop_) return;
    if (borders.size() >= kMostBorders) return;
    const auto place = [&](double share) {
      std::vector<double> at = a.at;
      at[along] += share * (b.at[along] - a.at[along]);
      return at;
    };
    // On the border itself closures are double, and may not be decided.
    for (const double share : {0.5, 0.4472, 0.5528}) {
      const double there = place(share)[along];
      const bool is_between = there != a.at[along] && there != b.at[along];
      if (std::abs(b.at[along] - a.at[along]) <= width || !is_between) break;
      const SweepSample between = sample(place(share));
      if (!between.complete) continue;
      sharpen(a, between, along, width, borders);
      sharpen(between, b, along, width, borders);
      return;
    }
    if (!stop_) borders.push_back({place(0.5), a.found, b.found, along});
  }

 private:
  const Mechanism& mechanism_;
  const std::vector<Varied>& varied_;
  const Tracker& tracker_;
  const FamilyBook& book_;
  const SweepOptions& options_;
  ClosureOptions closures_;
  const ObservedSamples observed_;
  const std::atomic<bool>& stop_;
};

std::vector<SamplePair> edges_of(const std::vector<Varied>& varied) {
  std::vector<SamplePair> edges;
  if (varied.size() == 1) {
    for (std::size_t k = 0; k + 1 < varied[0].count; ++k) edges.push_back({k, k + 1, 0});
    return edges;
  }
  const std::size_t columns = varied[1].count;
  for (std::size_t i = 0; i < varied[0].count; ++i) {
    for (std::size_t j = 0; j < columns; ++j) {
      const std::size_t k = i * columns + j;
      if (j + 1 < columns) edges.push_back({k, k + 1, 1});
      if (i + 1 < varied[0].count) edges.push_back({k, k + columns, 0});
    }
  }
  return edges;
}

void sharpen_borders(Sweep& run, const SweepOptions& options, SweepResult& result) {
  if (!options.sharpen) return;
  std::vector<SamplePair> edges;
  for (const SamplePair& edge : edges_of(result.varied)) {
    if (result.samples[edge.first].found != result.samples[edge.second].found) {
      edges.push_back(edge);
    }
  }
  std::vector<std::vector<SweepBorder>> found(edges.size());
  const auto find = [&](std::size_t k) {
    const SweepSample& a = result.samples[edges[k].first];
    const SweepSample& b = result.samples[edges[k].second];
    const Varied& along = result.varied[edges[k].along];
    const double width = result.varied.size() == 1
                             ? kBorder * std::abs(along.to - along.from)
                             : kMapBorder * std::abs(b.at[edges[k].along] - a.at[edges[k].along]);
    run.sharpen(a, b, edges[k].along, width, found[k]);
  };
  const Fingerprint list = run.observed().list_of_borders(result.samples, edges);
  Observations* const observations = run.observed().observations();
  const auto known =
      observations != nullptr ? observations->recall(list) : std::map<std::uint64_t, std::string>();
  const auto take = [&](std::size_t k, std::string_view outcome) {
    found[k] = borders_of(outcome);
  };
  const auto keep = [&](std::size_t k, const std::string& outcome) {
    if (observations != nullptr)
      observations->keep(list, JobOutcome{k, outcome, OutcomeKind::other});
  };
  run.do_all({list, edges.size(), [&](std::size_t k) { return known.count(k) > 0; },
              [&](std::size_t k) {
                if (const auto outcome = known.find(k); outcome != known.end()) {
                  take(k, outcome->second);
                  return outcome->second;
                }
                const std::size_t learned = run.learned();
                find(k);
                std::string outcome = bytes_of(found[k]);
                if (run.learned() > learned || run.is_stopped()) return std::string();
                keep(k, outcome);
                return outcome;
              },
              [&](std::size_t k, std::string_view outcome) {
                take(k, outcome);
                keep(k, std::string(outcome));
              }});
  for (auto& borders : found) {
    result.borders.insert(result.borders.end(), borders.begin(), borders.end());
  }
}

std::vector<std::string> broken_rules(const Mechanism& mechanism,
                                      const std::vector<Varied>& varied) {
  std::vector<std::string> broken;
  if (varied.empty() || varied.size() > 2) broken.push_back("one or two numbers can be varied");
  std::size_t samples = 1;
  for (const Varied& number : varied) {
    Mechanism copy = mechanism;
    try {
      set_dimension(copy, number.name, number.from);
    } catch (const std::invalid_argument& error) {
      broken.push_back(error.what());
    }
    if (!std::isfinite(number.from) || !std::isfinite(number.to) || number.from == number.to) {
      broken.push_back(number.name + " has no range to be varied in");
    }
    if (number.count < 2 || number.count > kMostSamples / samples) {
      broken.push_back(number.name +
                       " takes 2 values or more, and there are a million samples at most");
    } else {
      samples *= number.count;
    }
  }
  if (varied.size() == 2 && varied[0].name == varied[1].name) {
    broken.push_back(varied[0].name + " is varied twice");
  }
  return broken;
}

}  // namespace

double Varied::at(std::size_t k) const {
  if (k + 1 == count) return to;
  return from + (to - from) * static_cast<double>(k) / static_cast<double>(count - 1);
}

SweepResult sweep(const Mechanism& mechanism, const std::vector<Varied>& varied,
                  const Tracker& tracker, FamilyBook& book, const SweepOptions& options,
                  const std::atomic<bool>& stop) {
  require_unbroken(broken_rules(mechanism, varied));
  const Stopwatch watch;
  SweepResult result;
  result.varied = varied;
  const std::size_t columns = varied.size() == 2 ? varied[1].count : 1;
  result.samples.resize(varied[0].count * columns);
  Sweep run(mechanism, varied, tracker, book, options, stop);
  result.threads = thread_count(options.closures.solve.threads);
  const auto at = [&](std::size_t k) {
    std::vector<double> values{varied[0].at(k / columns)};
    if (varied.size() == 2) values.push_back(varied[1].at(k % columns));
    return values;
  };
  for (std::size_t k = 0; k < result.samples.size(); ++k) result.samples[k].at = at(k);
  run.do_all({run.observed().list(), result.samples.size(),
              [&](std::size_t k) { return run.observed().recall(at(k)).has_value(); },
              [&](std::size_t k) {
                const std::size_t learned = run.learned();
                result.samples[k] = run.sample(at(k));
                return run.learned() == learned ? bytes_of(result.samples[k]) : std::string();
              },
              [&](std::size_t k, std::string_view outcome) {
                result.samples[k] = sample_of(outcome);
                run.observed().keep(result.samples[k]);
              }});
  sharpen_borders(run, options, result);
  result.complete = !stop;
  for (const SweepSample& sample : result.samples) result.complete &= sample.complete;
  result.families = book.families().size();
  result.seconds = watch.total();
  return result;
}

}  // namespace moivre
