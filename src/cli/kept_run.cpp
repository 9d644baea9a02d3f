// SPDX-License-Identifier: MIT
// The options of a call as the identity of its run and as a question, and results on their way
// through the ledger.
#include "kept_run.h"

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <set>

#include "command_line.h"
#include "interruption.h"
#include "moivre/expression/source.h"
#include "moivre/report/version.h"
#include "moivre/run_ledger/run_ledger.h"
#include "moivre/solver/solve.h"
#include "process_role.h"

#if MOIVRE_WITH_LANES
#include "moivre/tracker_lanes/lane_tracker.h"
#endif

namespace moivre {
namespace {

// Say nothing about what is answered.
const std::set<std::string> kOfTheProcess{
    "--help", "-h",    "--ledger", "--part",  "--threads", "--quiet",  "--time-limit", "--json",
    "--csv",  "--svg", "--html",   "--paths", "--phc",     "--family", "--output",     "-o"};
// Say what is told of the roots, and not what is followed.
const std::set<std::string> kOfTheAnswer{
    "FILE",      "--all", "--digits", "--cross-check", "--no-certify",  "--real",      "--positive",
    "--nonzero", "--box", "--where",  "--three-views", "--sensitivity", "--no-borders"};

constexpr const char* kText = "text";
constexpr const char* kUnfinished = "unfinished";

std::string name_of(const CLI::App& call) {
  const CLI::App* parent = call.get_parent();
  const bool is_command = parent == nullptr || parent->get_parent() == nullptr;
  return (is_command ? "" : name_of(*parent) + ' ') + call.get_name();
}

std::string value_of(const CLI::Option& option) {
  if (option.count() == 0) return option.get_default_str();
  std::string value;
  for (const std::string& word : option.results()) value += (value.empty() ? "" : " ") + word;
  return value;
}

/// Of every option that has a value and is none of `without`.
RunIdentity options_of(const CLI::App& call, const std::set<std::string>& without) {
  RunIdentity options;
  for (const CLI::Option* option : call.get_options()) {
    const std::string name = option->get_name();
    const std::string value = value_of(*option);
    if (!value.empty() && without.count(name) == 0) options.emplace_back(name, value);
  }
  return options;
}

std::string hexadecimal(const Fingerprint& fingerprint) {
  char text[40];
  std::snprintf(text, sizeof text, "%016llx%016llx",
                static_cast<unsigned long long>(fingerprint.first),
                static_cast<unsigned long long>(fingerprint.second));
  return text;
}

std::string lanes_here() {
#if MOIVRE_WITH_LANES
  return lane_target();
#else
  return "none";
#endif
}

RunIdentity identity_of(const LedgerChoice& choice, const std::vector<std::string>& inputs) {
  RunIdentity identity{{"command", name_of(*choice.call)},
                       {"version", std::string(version())},
                       {"instruction set", lanes_here()}};
  std::size_t number = 0;
  for (const std::string& input : inputs) {
    ++number;
    if (input.empty()) continue;
    if (input == "-") {
      throw std::invalid_argument(
          "--ledger needs a file that can be read again, not standard input");
    }
    const std::string which = number == 1 ? "" : " of input " + std::to_string(number);
    identity.emplace_back("fingerprint of the file" + which,
                          hexadecimal(fingerprint_of(read_source(input).text)));
  }
  std::set<std::string> without = kOfTheProcess;
  without.insert(kOfTheAnswer.begin(), kOfTheAnswer.end());
  for (auto& option : options_of(*choice.call, without)) identity.push_back(std::move(option));
  return identity;
}

Fingerprint question_of(const CLI::App& call) {
  FingerprintMaker maker;
  for (const auto& [name, value] : options_of(call, kOfTheProcess)) {
    maker.add(name);
    maker.add(value);
  }
  return maker.fingerprint();
}

/// "K/N" of whole numbers, 1 <= K <= N.
JobPart part_of(const std::string& text) {
  JobPart part;
  const char* const end = text.data() + text.size();
  const auto number = std::from_chars(text.data(), end, part.number);
  const bool has_slash = number.ec == std::errc() && number.ptr != end && *number.ptr == '/';
  const auto of = std::from_chars(has_slash ? number.ptr + 1 : end, end, part.of);
  const bool is_part = has_slash && of.ec == std::errc() && of.ptr == end && part.number >= 1 &&
                       part.number <= part.of;
  if (is_part) return part;
  throw CLI::ValidationError("--part", text + " is no part: 2/5 is the second of five");
}

void require_part_possible(const LedgerChoice& choice) {
  if (!choice.part) return;
  if (choice.path.empty()) {
    throw std::invalid_argument(
        "--part is kept in a ledger: give --ledger PATH, another one for each part");
  }
  if (process_role().shared != nullptr) {
    throw std::invalid_argument(
        "--part is for processes that hear nothing of one another: those of mpirun share the work "
        "by themselves");
  }
}

}  // namespace

void add_ledger_option(CLI::App& command, LedgerChoice& choice) {
  choice.call = &command;
  command
      .add_option("--ledger", choice.path,
                  "keep the run in this file as it goes: after a kill or a crash the same command "
                  "goes on, and a finished run is told again at once")
      ->type_name("PATH");
}

void add_part_option(CLI::App& command, LedgerChoice& choice) {
  command
      .add_option_function<std::string>(
          "--part", [&choice](const std::string& text) { choice.part = part_of(text); },
          "do the K-th of N parts of the work, and keep it in a ledger of its own: moivre ledger "
          "merge puts the parts together")
      ->type_name("K/N");
}

KeptRun::KeptRun(const LedgerChoice& choice, const std::vector<std::string>& inputs)
    : choice_(choice) {
  require_part_possible(choice);
  if (choice.path.empty() || !process_role().tells) return;
  question_ = question_of(*choice.call);
  ledger_ = std::make_unique<RunLedger>(choice.path, identity_of(choice, inputs), stop_run);
  if (choice.part) part_ = std::make_unique<PartOfLists>(*ledger_, *choice.part, stop_run);
}

KeptRun::~KeptRun() = default;

Observations* KeptRun::observations() {
  if (part_) return part_.get();
  SharedObservations* const shared = process_role().shared;
  return shared != nullptr ? shared->kept_in(ledger_.get()) : ledger_.get();
}

void KeptRun::tell(const Progress& progress) {
  if (ledger_ && !progress.search) ledger_->tell(progress.done, progress.total, progress.finite);
}

void KeptRun::tell(std::uint64_t done, std::uint64_t total) {
  if (ledger_) ledger_->tell(done, total, 0);
}

std::optional<int> KeptRun::deliver_again(const std::vector<Output*>& outputs, bool quiet) {
  if (!ledger_) return std::nullopt;
  const int exit_code = ledger_->exit_code_of(question_);
  if (exit_code < 0) return std::nullopt;
  const auto told = [this](const std::string& slot) {
    return [this, slot](const TextSink& sink) { ledger_->read_answer(question_, slot, sink); };
  };
  std::vector<Form> forms;
  for (std::size_t k = 0; k < outputs.size(); ++k) {
    const std::string slot = std::to_string(k);
    if (outputs[k]->is_wanted() && !ledger_->has_answer(question_, slot)) return std::nullopt;
    forms.emplace_back(outputs[k], told(slot));
  }
  std::string unfinished;
  told(kUnfinished)([&unfinished](std::string_view piece) { unfinished += piece; });
  moivre::deliver(forms, quiet, Content(told(kText)), unfinished);
  return exit_code;
}

void KeptRun::keep_beside(std::size_t place, std::string text) {
  if (ledger_) beside_[place] = std::move(text);
}

Content KeptRun::kept(const std::string& slot, const Content& content) {
  return [this, slot, content](const TextSink& sink) {
    ledger_->add_to_answer(question_, slot, "");
    content([&](std::string_view piece) {
      ledger_->add_to_answer(question_, slot, piece);
      sink(piece);
    });
  };
}

int KeptRun::deliver(const std::vector<Form>& forms, bool quiet, const Content& text,
                     const std::string& unfinished, int exit_code, int threads) {
  if (!ledger_) {
    moivre::deliver(forms, quiet, text, unfinished, threads);
    return exit_code;
  }
  ledger_->close_observations();
  if (part_ && part_->is_done()) return deliver_part(quiet);
  if (is_asked_to_stop()) {
    moivre::deliver(forms, quiet, text, unfinished);
  } else {
    std::vector<Form> kept_forms;
    for (const Form& form : forms) {
      const std::string slot = std::to_string(&form - forms.data());
      kept_forms.emplace_back(form.output, kept(slot, form.content));
    }
    for (const auto& [place, whole] : beside_) {
      ledger_->add_to_answer(question_, std::to_string(place), whole);
    }
    kept(kText, text)([](std::string_view) {});
    kept(kUnfinished, [&](const TextSink& sink) { sink(unfinished); })([](std::string_view) {});
    moivre::deliver(kept_forms, quiet, text, unfinished);
    if (!is_asked_to_stop()) ledger_->end_answer(question_, exit_code);
  }
  return unless_ledger_failed(exit_code);
}

int KeptRun::unless_ledger_failed(int exit_code) const {
  const std::string failure = ledger_->failure();
  if (failure.empty()) return exit_code;
  std::fprintf(stderr, "moivre: %s\n", failure.c_str());
  return kUndecided;
}

int KeptRun::deliver_part(bool quiet) {
  const std::string text = "part " + std::to_string(choice_.part->number) + " of " +
                           std::to_string(choice_.part->of) + " is kept in " + choice_.path +
                           "\nWhen all parts are there: moivre ledger merge RUN.db " +
                           choice_.path + " ..., and then the same command with --ledger RUN.db\n";
  if (!quiet) write_to_stdout(text);
  return unless_ledger_failed(kDecided);
}

int KeptRun::deliver(const std::vector<Form>& forms, bool quiet,
                     const std::function<std::string()>& text, const std::string& unfinished,
                     int exit_code) {
  return deliver(
      forms, quiet, [&text](const TextSink& sink) { sink(text()); }, unfinished, exit_code);
}

}  // namespace moivre
