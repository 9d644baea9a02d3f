// SPDX-License-Identifier: MIT
// The study of a mechanism: closures as the subject of a study, and a table of its motion.
#include "moivre/closure_study/closure_study.h"

#include "moivre/closure_study/motion_table.h"
#include "moivre/closures/closures.h"
#include "moivre/formulation/formulation.h"
#include "moivre/motion/motion.h"

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
                            const Tracker& reference_tracker, const Tracker* witness,
                            const StudyOptions& options, const std::atomic<bool>& stop) {
  Eigen::VectorXd first;
  const auto find = [&](const Tracker& tracker, const SolveOptions& solve_options,
                        const std::atomic<bool>& halt) {
    ClosureOptions closure_options;
    closure_options.solve = solve_options;
    closure_options.certify = false;
    ClosureResult closures = find_closures(mechanism, tracker, closure_options, halt);
    if (first.size() == 0 && !closures.closures.empty()) first = closures.closures.front().q;
    return as_solve_result(std::move(closures));
  };
  const StudySubject subject{formulate(mechanism, 0).system, false, find};
  StudyResult result = study_subject(subject, settings, reference_tracker, witness, options, stop);
  if (stop.load()) return result;
  if (first.size() == 0) {
    result.remarks.push_back(
        "no closure is real: the mechanism cannot be assembled, and has no motion");
    return result;
  }
  const double duration = natural_duration(mechanism, 0);
  StudyTable motion = motion_table(mechanism, first, duration, reference_tracker, stop);
  if (motion.rows.empty()) {
    result.remarks.push_back(
        "the first closure stands or cannot be followed: no motion is compared");
  } else {
    result.tables.push_back(std::move(motion));
  }
  return result;
}

}  // namespace moivre
