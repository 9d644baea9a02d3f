// SPDX-License-Identifier: MIT
// How is a solve reported? As text for people, as JSON and CSV for programs, as PHCpack's solution
// list.
//
//   text   counts, real roots with the digits that their accuracy justifies, what was left out,
//          failures with reasons (all digits, where more than double's were asked for; CSV
//          likewise)
//   JSON   everything; docs/json.md shows it; unknown numbers are null, never NaN
//   CSV    one root per line, shortest digits that read back as the same double; unknown numbers
//          are empty
//   paths  CSV too, one path a line: the stage of the start plan on which it ended, its verdict
//          (to_string(PathVerdict), or "on a set" of positive dimension), its solution's place in
//          the list from 0, why it failed, the precision that it needed, how often it was followed,
//          whether the other tracker had to, and the steps of all that
//   PHC    the system, then THE SOLUTIONS: err is our accuracy, rco 1/condition, res our residual,
//          m the multiplicity
//
// All are the same bytes for every number of threads, but for the run times (`time_s`, and the
// text's line of time).
// Edges: a run that was interrupted is reported like any other, and says so.
// `file` is the name the user gave to the problem.
#pragma once

#include <string>

#include "moivre/polynomial/system.h"
#include "moivre/report/text_sink.h"
#include "moivre/solver/solve.h"

namespace moivre {

enum class ListedRoots { real, all };

/// Piece by piece: a root is held at a time.
void write_solve_text(const TextSink& sink, const SolveResult& result, const std::string& file,
                      ListedRoots listed = ListedRoots::real);
void write_solve_json(const TextSink& sink, const SolveResult& result, const std::string& file);
void write_solve_csv(const TextSink& sink, const SolveResult& result);
void write_paths_csv(const TextSink& sink, const SolveResult& result);
/// `f`: the system that was solved.
void write_solve_phc(const TextSink& sink, const SolveResult& result, const System& f);

/// The same as one text.
std::string solve_text(const SolveResult& result, const std::string& file,
                       ListedRoots listed = ListedRoots::real);
std::string solve_json(const SolveResult& result, const std::string& file);
std::string solve_csv(const SolveResult& result);
std::string paths_csv(const SolveResult& result);
std::string solve_phc(const SolveResult& result, const System& f);

}  // namespace moivre
