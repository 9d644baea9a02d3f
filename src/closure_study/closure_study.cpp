// SPDX-License-Identifier: MIT
// The study of a mechanism: closures as the subject of a study.
#include "moivre/closure_study/closure_study.h"

#include "moivre/closures/closures.h"

namespace moivre {
namespace {

SolveResult as_solve_result(ClosureResult&& closures) {
  SolveResult result;
  result.complete = closures.complete;
  result.message = std::move(closures.message);
  result.seed = closures.seed;
  result.system = std::move(closures.system);
  result.reduced = std::move(closures.reduced);
  result.start = std::move(closures.start);
  result.start.paths = closures.paths.tracked;
  result.paths = closures.paths;
  result.solutions = std::move(closures.solutions);
  result.failures = std::move(closures.failures);
  result.work = closures.work;
  return result;
}

}  // namespace

StudyResult study_mechanism(const Mechanism& mechanism, const std::vector<StudySetting>& settings,
                            const Tracker& referee, const Tracker* witness,
                            const StudyOptions& options, const std::atomic<bool>& stop) {
  const auto find = [&](const Tracker& tracker, const SolveOptions& solve_options,
                        const std::atomic<bool>& halt) {
    ClosureOptions closure_options;
    closure_options.solve = solve_options;
    return as_solve_result(find_closures(mechanism, tracker, closure_options, halt));
  };
  const StudySubject subject{isotropic_system(mechanism, 0).system, false, find};
  return study_subject(subject, settings, referee, witness, options, stop);
}

}  // namespace moivre
