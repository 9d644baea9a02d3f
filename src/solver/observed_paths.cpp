// SPDX-License-Identifier: MIT
// What the ends of a list depend on, their bytes, and the list without those that are known.
#include "observed_paths.h"

#include <utility>

#include "moivre/homotopy/frame_bytes.h"
#include "moivre/numeric/bytes.h"
#include "moivre/tracker/followed.h"
#include "shared_paths.h"

namespace moivre {
namespace {

void put_count(ByteWriter& bytes, const StepCount& count) {
  for (const std::uint64_t number :
       {count.accepted, count.rejected, count.work.values, count.work.fine_values,
        count.work.linearizations, count.work.factorizations}) {
    bytes.put(number);
  }
}

StepCount get_count(ByteReader& bytes) {
  StepCount count;
  for (std::uint64_t* number :
       {&count.accepted, &count.rejected, &count.work.values, &count.work.fine_values,
        &count.work.linearizations, &count.work.factorizations}) {
    *number = bytes.get<std::uint64_t>();
  }
  return count;
}

void put_endgame_start(ByteWriter& bytes, const EndgameStart& endgame_start) {
  bytes.put(endgame_start.x);
  bytes.put(endgame_start.radius);
  put_frame(bytes, endgame_start.frame);
}

EndgameStart get_endgame_start(ByteReader& bytes) {
  EndgameStart endgame_start;
  endgame_start.x = bytes.get_vector<Complex>();
  endgame_start.radius = bytes.get<double>();
  endgame_start.frame = get_frame(bytes);
  return endgame_start;
}

void add_endgame(FingerprintMaker& maker, const EndgameOptions& options) {
  const EndParameters& ends = options.ends;
  for (const bool is_set :
       {options.goes_straight, options.only_regular, options.may_wait, options.goes_back}) {
    maker.add(std::uint64_t{is_set});
  }
  for (const double number :
       {ends.watch_radius, ends.creeping_radius, ends.first_radius, ends.least_radius, ends.shrink,
        ends.rounding, ends.sample_error, ends.agreement, ends.regular_condition,
        ends.singular_condition, ends.zero_sum, ends.beyond, ends.known_size, ends.valuation_error,
        ends.face_threshold, ends.face_progress, ends.fine_rounding}) {
    maker.add(number);
  }
  for (const int number : {options.creeping_steps, ends.samples, ends.maximum_winding}) {
    maker.add(static_cast<double>(number));
  }
  maker.add(ends.maximum_steps);
}

/// may_wait: a path that has not reached its end goes on later, with the others.
OutcomeKind kind_of(const PathEnd& end, bool may_wait) {
  if (may_wait && end.endgame_start) return OutcomeKind::other;
  switch (end.status) {
    case PathStatus::finite:
      return OutcomeKind::root;
    case PathStatus::at_infinity:
      return OutcomeKind::at_infinity;
    case PathStatus::failed:
      return OutcomeKind::failed;
  }
  return OutcomeKind::other;
}

}  // namespace

/// Where paths begin follows from the plan's homotopies and its numbers; two of the points tell
/// plans of given points apart.
Fingerprint list_of(const PathProblem& problem, const PathList& paths, int tolerance_level) {
  FingerprintMaker maker;
  maker.add(to_string(problem.plan.source));
  for (const Homotopy& stage : problem.plan.stages) add_to(maker, stage);
  add_to(maker, problem.tracker);
  add_endgame(maker, problem.endgame);
  maker.add(static_cast<double>(tolerance_level));
  for (std::uint64_t k = 0; k < paths.count; ++k) {
    const std::uint64_t path = paths.path_of(k);
    maker.add(path);
    if (paths.endgame_starts) {
      const EndgameStart& endgame_start = paths.endgame_starts->at(path);
      maker.add(endgame_start.x);
      maker.add(endgame_start.radius);
      add_to(maker, endgame_start.frame);
    } else if (k == 0 || k + 1 == paths.count) {
      const StartPoint start = problem.plan.points->at(path);
      maker.add(start.x);
      add_to(maker, start.frame);
    }
  }
  return maker.fingerprint();
}

std::string bytes_of(const PathEnd& end) {
  ByteWriter bytes;
  bytes.put(end.status);
  bytes.put(end.failure.has_value());
  if (end.failure) bytes.put(*end.failure);
  bytes.put(end.x);
  bytes.put(end.is_as_rounded);
  bytes.put(end.singular);
  bytes.put(end.winding.value_or(-1));
  for (const double number : {end.accuracy, end.size, end.condition, end.t.real(), end.t.imag()}) {
    bytes.put(number);
  }
  bytes.put(static_cast<std::uint64_t>(end.stage));
  bytes.put(end.sheet);
  put_count(bytes, end.count);
  bytes.put(end.endgame_start.has_value());
  if (end.endgame_start) put_endgame_start(bytes, *end.endgame_start);
  bytes.put(end.is_taken_up);
  return bytes.bytes();
}

PathEnd end_of(std::string_view text) {
  ByteReader bytes(text);
  PathEnd end;
  end.status = bytes.get<PathStatus>();
  if (bytes.get<bool>()) end.failure = bytes.get<Failure>();
  end.x = bytes.get_vector<Complex>();
  end.is_as_rounded = bytes.get<bool>();
  end.singular = bytes.get<bool>();
  const int winding = bytes.get<int>();
  if (winding >= 0) end.winding = winding;
  end.accuracy = bytes.get<double>();
  end.size = bytes.get<double>();
  end.condition = bytes.get<double>();
  end.t.real(bytes.get<double>());
  end.t.imag(bytes.get<double>());
  end.stage = static_cast<std::size_t>(bytes.get<std::uint64_t>());
  end.sheet = bytes.get_vector<Complex>();
  end.count = get_count(bytes);
  if (bytes.get<bool>()) end.endgame_start = get_endgame_start(bytes);
  end.is_taken_up = bytes.get<bool>();
  bytes.require_end();
  return end;
}

KeptEnds::KeptEnds(const PathProblem& problem, Observations& observations, const Fingerprint& list)
    : observations_(observations), list_(list), may_wait_(problem.endgame.only_regular) {}

void KeptEnds::take(std::uint64_t path, const PathEnd& end, EndPart part) {
  if (end.failure == Failure::cancelled) return;
  ++ended_;
  JobOutcome outcome{path, bytes_of(end), kind_of(end, may_wait_)};
  if (part == EndPart::of_others_too) {
    of_circles_.push_back(std::move(outcome));
  } else {
    observations_.keep(list_, outcome);
  }
}

void KeptEnds::keep_circles() { observations_.keep(list_, of_circles_); }

bool observe_paths(const PathProblem& problem, const PathList& paths, int tolerance_level,
                   int threads, const EndSink& sink, const std::atomic<bool>& stop,
                   Observations* observations) {
  if (observations == nullptr)
    return track_paths(problem, paths, tolerance_level, threads, sink, stop);
  const Fingerprint list = list_of(problem, paths, tolerance_level);
  if (!are_few(paths.count, tolerance_level)) {
    if (const auto shares = observations->share(list, paths.count)) {
      return SharedPaths(problem, paths, tolerance_level, threads, sink, stop, *observations, list)
          .follow(*shares);
    }
  }
  KeptEnds kept(problem, *observations, list);
  const auto known = observations->recall(list);
  std::vector<std::uint64_t> others;
  for (std::uint64_t k = 0; k < paths.count; ++k) {
    const std::uint64_t path = paths.path_of(k);
    const auto found = known.find(path);
    if (found == known.end()) {
      others.push_back(path);
    } else {
      sink(path, end_of(found->second));
    }
  }
  if (others.empty()) return true;
  const PathList rest{others.size(), [&](std::uint64_t k) { return others[k]; },
                      paths.endgame_starts, paths.count - others.size()};
  EndPart part = EndPart::of_itself;
  const bool has_memory = track_paths(
      problem, rest, tolerance_level, threads,
      [&](std::uint64_t path, PathEnd&& end) {
        kept.take(path, end, part);
        sink(path, std::move(end));
      },
      stop, [&part] { part = EndPart::of_others_too; });
  if (has_memory && !stop && kept.ended() == others.size()) kept.keep_circles();
  return has_memory;
}

}  // namespace moivre
