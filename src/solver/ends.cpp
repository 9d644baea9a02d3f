// SPDX-License-Identifier: MIT
// From the verdict on a path to its entry in the table, through the refinement of finite ends.
#include "ends.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "certificates.h"
#include "coincidence.h"
#include "dimension.h"
#include "fine_restore.h"
#include "moivre/certify/certifier.h"

namespace moivre {
namespace {

// A simple root is known this much better than ends of different paths are apart.
constexpr double kSimpleRounding = 1e-13;
// A singular end is not known better than this; ends nearer than that are one root.
constexpr double kSingularTolerance = 1e-7;
// A singular end known worse than this is not known at all.
constexpr double kWorstAccuracy = 1e-3;
// Of what an error changes F by to first order, beside its terms: a degree, times the sixteen that
// Refiner::keep() allows for cancellation.
constexpr double kMostOfFirstOrder = 100;
// Of F at a point of doubles.
constexpr double kRoundingOfF = 2e-15;
// Of a root that is not simple.
constexpr int kLeastMultiplicity = 2;

// Beside the terms of F, at a root of which double holds every coordinate to some digits: F is
// rounding there. Where it is not, a coordinate has none: 7e-211 beside an error of 1e-20.
constexpr double kDigitsResidual = 0x1p-26;

// A thread is worth waking for so many ends to refine.
constexpr std::size_t kEndsOfAThread = 16;

/// What refines and proves ends; one a thread, and one for ends of more digits.
struct Tools {
  Tools(const Setting& setting, int most_bits)
      : refiner(setting.refiner_program),
        prover(setting.certify_program, kFarthestRoot, most_bits),
        restorer(setting, most_bits) {}

  Refiner refiner;
  Prover prover;
  FineRestorer restorer;
};

/// Proved, and no farther from x than the end's accuracy allows.
std::shared_ptr<const Certificate> if_within_reach(
    Refiner& refiner, const Point& x, double accuracy,
    const std::shared_ptr<const Certificate>& certificate) {
  const bool is_it = certificate && refiner.is_within_reach(x, accuracy, certificate->midpoint);
  return is_it ? certificate : nullptr;
}

struct JudgedEnd {
  Root root;
  std::shared_ptr<const Certificate> beside;  ///< PathTable::enter_root()
};

/// A proved root near the end is what the path ends at; without a proof it is no simple root. Of an
/// end that may still wait for more effort, and in a run that is to stop, double tells enough: near
/// a multiple root a proof is sought in vain, for long.
bool prove(const Run& run, Tools& tools, const PathEnd& end, const Point& x, double accuracy,
           JudgedEnd& judged) {
  auto& [refiner, prover, restorer] = tools;
  const bool is_brief = run.effort == Effort::regular_ends || run.setting.stop;
  const auto nearest = is_brief ? prover.prove_in_double(x) : prover.prove(x);
  auto certificate = if_within_reach(refiner, x, accuracy, nearest);
  if (!certificate && !is_brief) certificate = restorer.proved(prover, end.x);
  if (!certificate) {
    judged.beside = nearest;
    return false;
  }
  Root& root = judged.root;
  root = proved_root(refiner, std::move(certificate));
  for (int bits = kMostProofBits; bits <= kMostArbBits; bits *= 2) {
    if (root.point.residual <= kDigitsResidual) break;
    auto sharper = prover.sharpened(*root.certificate, bits);
    if (sharper) root = proved_root(refiner, std::move(sharper));
  }
  return true;
}

/// Whether F at the end is larger than an error of that accuracy makes it, wherever the root is and
/// whatever its multiplicity: what circles have told is then no root. With sheets, Refiner::keep()
/// made |F|^(1/sheets) an accuracy.
bool is_contradicted(const Refined& end, int sheets, double accuracy) {
  return std::pow(end.accuracy, sheets) > kMostOfFirstOrder * (accuracy + kRoundingOfF);
}

JudgedEnd judged_end(const Run& run, Tools& tools, const PathEnd& end) {
  const Setting& setting = run.setting;
  Refiner& refiner = tools.refiner;
  const Point x = to_original(setting.prepared, end.x);
  // A relative error of z_0 is one of z / z_0, larger by the size of the affine point.
  const double accuracy = end.accuracy * std::max(1.0, end.size);
  JudgedEnd judged;
  Root& root = judged.root;
  const bool many_sheets = end.winding.value_or(1) > 1;
  const bool is_proved = !many_sheets && prove(run, tools, end, x, accuracy, judged);
  root.winding = end.winding;
  if (is_proved) return judged;
  const int sheets = many_sheets ? *end.winding : kLeastMultiplicity;
  root.point = refiner.keep(x, accuracy, sheets);
  // A proof that nobody had the time for says nothing against a simple root.
  const bool is_unjudged = !many_sheets && setting.stop;
  if (is_unjudged || is_contradicted(root.point, sheets, accuracy)) root.point.accuracy = 1;
  root.tolerance = std::max(kSingularTolerance, 10 * root.point.accuracy);
  const bool is_beside =
      judged.beside && relative_distance(root.point.x, judged.beside->midpoint) <= root.tolerance;
  if (!is_beside) judged.beside.reset();
  return judged;
}

std::vector<JudgedEnd> judged_ends(const Run& run) {
  std::vector<JudgedEnd> judged(run.ends.size());
  const auto threads = static_cast<std::size_t>(run.setting.threads);
  const std::size_t chunks = std::min(threads, 1 + judged.size() / kEndsOfAThread);
  for_each_parallel(chunks, run.setting.threads, [&](std::size_t chunk) {
    Tools tools(run.setting, kMostProofBits);
    std::optional<Tools> fine_tools;  // made when they are first needed
    for (std::size_t k = chunk; k < judged.size(); k += chunks) {
      const auto& [path, end] = run.ends[k];
      const bool is_fine = run.table.precision(path) == PathPrecision::multiprecision;
      if (is_fine && !fine_tools) fine_tools.emplace(run.setting, kMostArbBits);
      judged[k] = judged_end(run, is_fine ? *fine_tools : tools, end);
    }
  });
  return judged;
}

bool is_known_singular(const Root& root) {
  return root.winding && root.point.accuracy <= kWorstAccuracy;
}

/// More effort may find its end.
bool has_to_wait(const Run& run, const PathEnd& end) {
  if (end.failure != Failure::precision || run.effort == Effort::all_steps) return false;
  return run.effort == Effort::regular_ends || end.endgame_start;
}

/// Of a path that failed on the last stage; empty elsewhere.
Point last_point(const Run& run, const PathEnd& end) {
  const Prepared& prepared = run.setting.prepared;
  if (end.x.empty() || end.stage + 1 != prepared.plan->stages.size()) return {};
  return to_original(prepared, end.x);
}

bool is_where_it_was(const Run& run, std::uint64_t path, const Root& end) {
  const auto known = run.table.roots().find(path);
  return known != run.table.roots().end() &&
         relative_distance(known->second.point.x, end.point.x) <= kMeanIsKnownTo;
}

void keep_sheet(Run& run, std::uint64_t path, const PathEnd& end) {
  if (end.sheet.empty()) {
    run.sheets.forget(path);
  } else {
    run.sheets.set(path, hash_of(end.sheet));
  }
}

}  // namespace

Root proved_root(Refiner& refiner, std::shared_ptr<const Certificate> proof) {
  Root root;
  root.point = refiner.take(*proof);
  root.tolerance = 4 * root.point.accuracy + kSimpleRounding;
  if (auto same = about(*proof, root.point.x)) {
    proof = std::make_shared<const Certificate>(*std::move(same));
    root.point.x = SharedPoint(std::shared_ptr<const Point>(proof, &proof->midpoint));
  }
  root.certificate = std::move(proof);
  return root;
}

Point where_it_waits(const Run& run, const EndgameStart& endgame_start) {
  const auto& [x, radius, frame] = endgame_start;
  return x.empty() ? Point() : to_original(run.setting.prepared, outside(frame, x));
}

void count_following(Run& run, std::uint64_t path, const PathEnd& end) {
  run.work += end.count;
  run.table.count_following(path, end.count, end.stage, end.is_taken_up);
}

void take_end(Run& run, std::uint64_t path, PathEnd&& end) {
  count_following(run, path, end);
  const bool is_mixed = end.status != PathStatus::at_infinity && end.count.work.fine_values > 0;
  run.table.set_precision(path, run.setting.is_fine() ? PathPrecision::double_double
                                : is_mixed            ? PathPrecision::mixed
                                                      : PathPrecision::double_precision);
  switch (end.status) {
    case PathStatus::finite:
      run.ends.emplace_back(path, std::move(end));
      return;
    case PathStatus::at_infinity:
      keep_sheet(run, path, end);
      run.table.enter_infinity(path, end.is_as_rounded);
      return;
    case PathStatus::failed:
      keep_sheet(run, path, end);
      if (has_to_wait(run, end)) {
        run.waiting[path] = end.endgame_start ? std::move(*end.endgame_start) : EndgameStart{};
      } else {
        run.table.enter_failure({path, *end.failure, end.t, end.stage}, last_point(run, end));
      }
      return;
  }
}

void judge_ends(Run& run, Unproved unproved) {
  std::sort(run.ends.begin(), run.ends.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<JudgedEnd> judged = judged_ends(run);
  for (std::size_t k = 0; k < judged.size(); ++k) {
    const auto& [path, end] = run.ends[k];
    auto& [root, beside] = judged[k];
    const bool hides_terms = run.setting.hides_terms(run.table.precision(path));
    const bool is_root = root.point.simple || (!hides_terms && is_known_singular(root));
    if (!is_root && unproved == Unproved::agrees && is_where_it_was(run, path, root)) continue;
    keep_sheet(run, path, end);
    if (is_root) {
      run.table.enter_root(path, std::move(root), std::move(beside));
    } else if (unproved == Unproved::waits) {
      run.waiting[path] = {};
    } else {
      run.table.enter_failure({path, Failure::precision, end.t, end.stage}, root.point.x);
    }
  }
  run.ends.clear();
}

}  // namespace moivre
