// SPDX-License-Identifier: MIT
// Where does a run keep what it has observed, so that it survives its process? In one file, an
// SQLite database.
//
//   identity      what makes the run this one: names and values, compared when it goes on
//   observation   outcomes of jobs, as many in a row as came in since the last commit; checksums
//                 tell bits that have flipped
//   progress      how far the run is, and for how long it has worked, all its processes together
//   answer        what the finished run wrote, piece by piece, under a fingerprint of what it was
//                 asked
//
// Commits are by time, not by job: a second apart, and nearer while the run is young, so that a run
// loses an eighth of itself at most.
// They are made by a thread of their own. One process writes at a time; others may read. `PRAGMA
// user_version` is the format's number.
//
// Edges: a disk that is full, or a file that cannot be written, is told by failure() and
// on_failure: what was committed stays, nothing more is kept, and the run is to end. Not supported:
// network file systems, which SQLite's write-ahead log cannot use.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "moivre/numeric/observations.h"

namespace moivre {

/// Names and values, in an order of the caller's.
using RunIdentity = std::vector<std::pair<std::string, std::string>>;

class RunLedger : public Observations {
 public:
  /// Opens the ledger, or makes it where there is none or an empty file. on_failure is called once,
  /// by any thread. Throws std::invalid_argument, and changes nothing, where the file is none of
  /// these, is damaged, of another format or run, cannot be written, or is being written by another
  /// process.
  RunLedger(const std::string& path, const RunIdentity& identity,
            std::function<void()> on_failure = {});
  /// Keeps what is pending.
  ~RunLedger() override;
  RunLedger(const RunLedger&) = delete;
  RunLedger& operator=(const RunLedger&) = delete;

  std::map<std::uint64_t, std::string> recall(const Fingerprint& list) override;
  using Observations::keep;
  void keep(const Fingerprint& list, std::span<const JobOutcome> outcomes) override;

  /// How far the run is; kept with the next commit.
  void tell(std::uint64_t done, std::uint64_t total, std::uint64_t roots);

  /// Commits what is pending. Nothing more is observed afterwards.
  void close_observations();

  /// The exit code of a run that was asked this and has ended; -1: there is none.
  int exit_code_of(const Fingerprint& question);
  bool has_answer(const Fingerprint& question, const std::string& slot);
  /// Hands on what was written, piece by piece.
  void read_answer(const Fingerprint& question, const std::string& slot,
                   const std::function<void(std::string_view)>& sink);

  /// After close_observations(): pieces of answers, each after the one before in its slot; kept
  /// together by end_answer().
  void add_to_answer(const Fingerprint& question, const std::string& slot, std::string_view piece);
  void end_answer(const Fingerprint& question, int exit_code);

  /// Why nothing more is kept, as a sentence; empty where all is well.
  std::string failure() const;

 private:
  class Books;
  std::unique_ptr<Books> books_;
};

}  // namespace moivre
