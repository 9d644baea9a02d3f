// SPDX-License-Identifier: MIT
// How does a command survive its process? What it observes is kept in a ledger, and so is what it
// writes at its end.
//
//   the first call      observes, keeps, and writes its results
//   after a kill        the same call takes what was observed and observes the rest
//   after the end       the same call writes what the finished run has written, without another
//                       look
//   a part of it        observes and keeps its share of the work, and writes no result
//                       (numeric/part_of_lists.h)
//
// One call is the same as another where all its options are, but for those that say where results
// go, how many threads there are, and how long it may take. One run is the same as another where
// its files' content and what its paths depend on are.
#pragma once

#include <CLI/CLI.hpp>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "moivre/numeric/part_of_lists.h"
#include "output.h"

namespace moivre {

class ProgressLine;
struct Progress;
class RunLedger;

struct LedgerChoice {
  std::string path;                ///< empty: the run is not kept
  std::optional<JobPart> part;     ///< nothing: all of it
  const CLI::App* call = nullptr;  ///< whose options make the run this one
};

/// "--ledger" of a command that may run long.
void add_ledger_option(CLI::App& command, LedgerChoice& choice);

/// "--part K/N", of a command whose work is one long list.
void add_part_option(CLI::App& command, LedgerChoice& choice);

class KeptRun {
 public:
  /// inputs: files whose content makes the run this one; empty names are none. Throws
  /// std::invalid_argument where the ledger cannot be used, with what differs where it is another
  /// run's.
  KeptRun(const LedgerChoice& choice, const std::vector<std::string>& inputs);
  ~KeptRun();
  KeptRun(const KeptRun&) = delete;
  KeptRun& operator=(const KeptRun&) = delete;

  bool is_kept() const { return ledger_ != nullptr; }
  /// Those of all processes of the run, where there are several.
  Observations* observations();
  void tell(const Progress& progress);
  void tell(std::uint64_t done, std::uint64_t total);

  /// Where this call has ended before: delivers what it wrote, to outputs in the order in which
  /// deliver() had them. The exit code then.
  std::optional<int> deliver_again(const std::vector<Output*>& outputs, bool quiet);

  /// A result that is written elsewhere, in its place among the outputs, for deliver() to keep.
  void keep_beside(std::size_t place, std::string text);

  /// deliver(), and keeps all of it where the run has come to its end; then on one thread. Returns
  /// the exit code, which tells of a ledger that could not be written too.
  int deliver(const std::vector<Form>& forms, bool quiet, const Content& text,
              const std::string& unfinished, int exit_code, int threads = 1);
  int deliver(const std::vector<Form>& forms, bool quiet, const std::function<std::string()>& text,
              const std::string& unfinished, int exit_code);

 private:
  Content kept(const std::string& slot, const Content& content);
  int deliver_part(bool quiet);
  /// The exit code, or that of a ledger that could not be written.
  int unless_ledger_failed(int exit_code) const;

  LedgerChoice choice_;
  std::unique_ptr<RunLedger> ledger_;
  std::unique_ptr<PartOfLists> part_;
  Fingerprint question_;
  std::map<std::size_t, std::string> beside_;
};

}  // namespace moivre
