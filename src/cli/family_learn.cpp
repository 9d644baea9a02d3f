// SPDX-License-Identifier: MIT
// moivre family learn FILE --parameters a,b -o F.family: solves a random complex member and keeps
// its roots.
#include "family_learn.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <stdexcept>

#include "interruption.h"
#include "kept_run.h"
#include "learn_mechanism.h"
#include "moivre/expression/counted.h"
#include "moivre/expression/words.h"
#include "moivre/family/learn.h"
#include "moivre/numeric/threads.h"
#include "moivre/polynomial/read.h"
#include "moivre/report/family_report.h"
#include "output.h"
#include "progress_line.h"
#include "tracker_choice.h"

namespace moivre {
namespace {

struct LearnCommand {
  std::string file;
  std::string parameters;
  std::string family;
  bool nonzero = false;
  bool monodromy = false;
  bool trace_test = false;
  StartChoice start;
  TrackerChoice tracker;
  int threads = 0;
  bool no_certify = false;
  bool quiet = false;
  std::string json;
  std::optional<double> time_limit;
  LedgerChoice ledger;
};

/// "a,b=100": names, and typical sizes where they are not near 1.
std::vector<NamedParameter> parameters_of(const std::string& text) {
  std::vector<NamedParameter> parameters;
  std::string_view rest = trimmed(text);
  while (!rest.empty()) {
    const std::size_t comma = rest.find(',');
    const std::string_view part = trimmed(rest.substr(0, comma));
    rest = comma == std::string_view::npos ? std::string_view() : rest.substr(comma + 1);
    const std::size_t equals = part.find('=');
    NamedParameter parameter{std::string(trimmed(part.substr(0, equals)))};
    if (equals != std::string_view::npos) {
      const auto size = to_number(trimmed(part.substr(equals + 1)));
      if (!size) {
        throw std::invalid_argument("--parameters " + std::string(part) +
                                    ": the size of a parameter is a number");
      }
      parameter.size = std::abs(*size);
    }
    parameters.push_back(std::move(parameter));
  }
  return parameters;
}

/// What the file declares, and what the option names; a constant's value is its typical size where
/// none is given.
Family read_family_of(const LearnCommand& command) {
  std::vector<NamedParameter> parameters = parameters_of(command.parameters);
  std::vector<std::string> names;
  for (const NamedParameter& parameter : parameters) names.push_back(parameter.name);
  const ParametricSystem read = read_parametric(read_source(command.file), names);
  for (NamedParameter& parameter : parameters) {
    const auto value = read.constants.find(parameter.name);
    if (value == read.constants.end() || parameter.size != 1) continue;
    const double size = std::abs(to_complex(value->second));
    if (size > 0) parameter.size = size;
  }
  for (const std::string& name : read.declared) {
    if (std::find(names.begin(), names.end(), name) == names.end()) parameters.push_back({name});
  }
  if (parameters.empty()) {
    throw std::invalid_argument(command.file +
                                ": no parameter is declared in the file; name them with "
                                "--parameters a,b");
  }
  Family family = unlearned_family(read.system, parameters);
  family.nonzero = command.nonzero;
  return family;
}

SolveOptions options_of(const LearnCommand& command, const Tracker* fallback) {
  SolveOptions options;
  options.seed = command.start.seed;
  options.start = kind_of(command.start);
  options.threads = command.threads;
  options.certify = !command.no_certify;
  options.fallback = fallback;
  return options;
}

/// Where it cannot be written to its place it is kept elsewhere: what was learned took its time.
/// Why, or empty.
std::string written(Output& out, const std::string& text) {
  try {
    out.write(text);
    return "";
  } catch (const std::invalid_argument& failure) {
    if (out.is_stdout() || is_writing_interrupted()) return failure.what();
    const std::string elsewhere = (std::filesystem::temp_directory_path() /
                                   ("moivre-" + std::to_string(::getpid()) + ".family"))
                                      .string();
    try {
      Output(elsewhere).write(text);
    } catch (const std::invalid_argument&) {
      return failure.what();
    }
    return std::string(failure.what()) + "; what was learned is in " + elsewhere;
  }
}

/// `standing`: why more may be to be learned; empty where nothing is.
int deliver_learned(const LearnCommand& command, const FamilyFile& file,
                    const std::string& standing, Output& json, Output& out, KeptRun& kept) {
  const std::string text = family_text(file);
  const std::string failure = written(out, text);
  kept.keep_beside(1, text);
  const int code = kept.deliver(
      {{&json, [&] { return family_report_json(file, command.family, "family learn"); }}},
      command.quiet || out.is_stdout(), [&] { return family_report_text(file, command.family); },
      standing, standing.empty() ? kDecided : kUndecided);
  if (!failure.empty()) throw std::invalid_argument(failure);
  return code;
}

/// A file of its own kind: every number is a parameter, and none is named.
int run_mechanism(const LearnCommand& command, const Tracker& tracker) {
  if (!command.parameters.empty()) {
    throw std::invalid_argument(
        "--parameters is for polynomial files; in a mechanism every dimension and driver is a "
        "parameter");
  }
  Output out(command.family);
  Output json(command.json);
  KeptRun kept(command.ledger, {command.file});
  if (const auto code = kept.deliver_again({&json, &out}, command.quiet)) return *code;
  const std::unique_ptr<Tracker> fallback = make_fallback(command.tracker);
  SolveOptions options = options_of(command, fallback.get());
  options.observations = kept.observations();
  const Interruption interruption(command.time_limit);
  const FamilyFile file = learn_mechanism(command.file, tracker, options, interruption.stop());
  const std::string standing =
      interruption.stop() ? "interrupted: families of other parts may be missing" : "";
  return deliver_learned(command, file, standing, json, out, kept);
}

Family learn_by_loops(const LearnCommand& command, Family family, const Tracker& tracker,
                      ProgressLine& line, KeptRun& kept, const std::atomic<bool>& stop) {
  const std::optional<KnownPair> pair = random_pair(family, command.start.seed);
  if (!pair) {
    throw std::invalid_argument(
        "--monodromy found no regular root of any member: Newton's method in unknowns and "
        "parameters comes to none");
  }
  MonodromyOptions options;
  options.seed = command.start.seed;
  options.threads = thread_count(command.threads);
  options.certify = !command.no_certify;
  options.observations = kept.observations();
  if (command.trace_test) options.most_tested = options.most_roots;
  if (line.is_active() || kept.is_kept()) {
    options.progress = [&](const LoopProgress& progress) {
      line.show(std::to_string(progress.loops) + " loops, " + counted(progress.roots, "root"));
      Progress so_far;
      so_far.done = static_cast<std::uint64_t>(progress.loops);
      so_far.finite = progress.roots;
      kept.tell(so_far);
    };
  }
  return learn_by_monodromy(std::move(family), *pair, tracker, options, stop);
}

FamilyFile learn_interruptibly(const LearnCommand& command, Family family, const Tracker& tracker,
                               KeptRun& kept, const std::atomic<bool>& stop) {
  const std::unique_ptr<Tracker> fallback = make_fallback(command.tracker);
  SolveOptions options = options_of(command, fallback.get());
  ProgressLine line(!command.quiet);
  options.observations = kept.observations();
  if (line.is_active() || kept.is_kept()) {
    options.progress = [&](const Progress& progress) {
      line.show(progress);
      kept.tell(progress);
    };
  }
  FamilyFile file;
  file.source = command.file;
  file.families.push_back(
      command.monodromy ? learn_by_loops(command, std::move(family), tracker, line, kept, stop)
                        : learn(std::move(family), tracker, options, stop));
  return file;
}

int run(const LearnCommand& command) {
  std::unique_ptr<Tracker> tracker;
  require_all(
      {[&] { require_known(command.start); }, [&] { require_threads(command.threads); },
       [&] { parameters_of(command.parameters); },
       [&] {
         require_distinct({command.family, command.json, command.ledger.path}, command.file);
       },
       [&] { tracker = make_tracker(command.tracker); }});
  if (command.file.ends_with(".toml")) return run_mechanism(command, *tracker);
  Family family = read_family_of(command);
  Output out(command.family);
  Output json(command.json);
  KeptRun kept(command.ledger, {command.file});
  if (const auto code = kept.deliver_again({&json, &out}, command.quiet)) return *code;
  const Interruption interruption(command.time_limit);
  const FamilyFile file =
      learn_interruptibly(command, std::move(family), *tracker, kept, interruption.stop());
  const Learning& learning = file.families.front().learning;
  if (file.families.front().roots.empty() && interruption.stop()) {
    throw std::invalid_argument("interrupted: nothing was learned, and " + command.family +
                                " is unchanged");
  }
  return deliver_learned(command, file, learning.complete ? "" : learning.standing, json, out,
                         kept);
}

}  // namespace

void add_family_learn(CLI::App& family, Chosen& chosen) {
  const auto command = std::make_shared<LearnCommand>();
  CLI::App& app =
      *family.add_subcommand("learn", "Solve a random complex member and keep its roots in a file");
  app.add_option(
         "FILE", command->file,
         "polynomial system: equations, or another program's text form; or a mechanism (.toml)")
      ->required();
  app.add_option("--parameters", command->parameters,
                 "names in the file that are parameters, with a typical size if that is not near "
                 "1: a,b=100; Bertini's `parameter` are parameters anyway")
      ->type_name("NAMES");
  app.add_option("-o,--output", command->family, "write the family here")
      ->required()
      ->type_name("PATH");
  app.add_flag("--nonzero", command->nonzero, "leave out roots with a coordinate 0");
  app.add_flag("--monodromy", command->monodromy,
               "find the roots from one root, along loops of members; needs no start system");
  app.add_flag("--trace-test", command->trace_test,
               "with --monodromy: make the trace test with more than 2000 roots too; takes minutes "
               "to hours")
      ->needs("--monodromy");
  add_start_options(app, command->start);
  add_threads_option(app, command->threads);
  add_time_limit_option(app, command->time_limit);
  add_ledger_option(app, command->ledger);
  app.add_flag("--no-certify", command->no_certify, "leave out certificates");
  add_quiet_flag(app, command->quiet);
  add_json_option(app, command->json);
  add_tracker_options(app, command->tracker);
  add_examples(app, {"moivre family learn conics.phc --parameters a,b,c -o conics.family",
                     "moivre family learn arm.bertini --parameters L1=300,L2 -o arm.family",
                     "moivre family learn linkage.toml -o linkage.family",
                     "moivre family learn problems/families/nine-point.bertini --monodromy -o "
                     "nine-point.family"});
  app.callback([command, &chosen] { chosen = [command] { return run(*command); }; });
}

}  // namespace moivre
