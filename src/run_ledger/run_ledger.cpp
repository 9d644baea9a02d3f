// SPDX-License-Identifier: MIT
// A ledger that is open: what is pending, the thread that commits it, and the lock that keeps other
// writers out.
#include "moivre/run_ledger/run_ledger.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <new>
#include <optional>
#include <system_error>
#include <thread>

#include "file_lock.h"
#include "format.h"
#include "moivre/numeric/stopwatch.h"
#include "pending.h"

namespace moivre {
namespace {

// Between commits: a share of the run's age.
constexpr double kShortest = 0.1, kLongest = 1, kShare = 0.125;
// Pending bytes that are committed at once, and those that no thread may add to.
constexpr std::size_t kMany = std::size_t{16} << 20, kTooMany = std::size_t{128} << 20;
// Pieces that the allocator takes from what it has: fresh pages cost more than writing them.
constexpr std::size_t kPiece = std::size_t{64} << 10;

}  // namespace

class RunLedger::Books {
 public:
  Books(const std::string& path, const RunIdentity& identity, std::function<void()> on_failure)
      : path_(path), lock_(path), on_failure_(std::move(on_failure)) {
    told_of(path, [&] { open(identity); });
    try {
      writer_ = std::thread([this] { write_now_and_then(); });
    } catch (const std::system_error&) {
      throw std::invalid_argument("cannot use the ledger " + path + ": there is no thread for it");
    }
  }
  ~Books() { close(); }

  std::map<std::uint64_t, std::string> recall(const Fingerprint& list) {
    const auto rows = rows_.find(list);
    if (rows == rows_.end()) return {};
    const std::lock_guard lock(database_mutex_);
    return told_of(path_, [&] { return outcomes_in(*database_, path_, rows->second); });
  }

  void keep(const Fingerprint& list, std::span<const JobOutcome> outcomes) {
    std::unique_lock lock(mutex_);
    room_.wait(lock, [this] { return pending_.bytes < kTooMany || has_failed_; });
    if (has_failed_) return;
    Chunk& chunk = pending_.chunks[list];
    for (const JobOutcome& outcome : outcomes) {
      chunk.add(outcome);
      pending_.bytes += outcome.bytes.size() + 2 * sizeof(std::uint64_t);
    }
    if (pending_.bytes >= kMany) wake_.notify_one();
  }

  void tell(const Told& told) {
    const std::lock_guard lock(mutex_);
    pending_.told = told;
  }

  /// What is pending is committed, and the thread has ended.
  void close() {
    {
      const std::lock_guard lock(mutex_);
      is_over_ = true;
    }
    wake_.notify_one();
    if (writer_.joinable()) writer_.join();
  }

  /// f of the database; where that fails, nothing more is kept.
  template <class F>
  void write(const F& f) {
    if (has_failed_) return;
    try {
      const std::lock_guard lock(database_mutex_);
      if (!lock_.is_in_place()) throw DatabaseError("it is no longer in its place", false);
      f(*database_);
    } catch (const DatabaseError& error) {
      fail(error.what());
    } catch (const std::bad_alloc&) {
      fail("there is not enough memory");
    }
  }

  template <class F>
  auto read(const F& f) {
    const std::lock_guard lock(database_mutex_);
    return told_of(path_, [&] { return f(*database_); });
  }

  /// Whole pieces go to the database; the rest waits for more.
  void add_to_answer(const Fingerprint& question, const std::string& slot, std::string_view piece) {
    begin_answer(question);
    Slot& of = slots_[slot];
    while (!piece.empty()) {
      const std::string_view part = piece.substr(0, kPiece - of.rest.size());
      of.rest += part;
      piece.remove_prefix(part.size());
      if (of.rest.size() == kPiece) insert(question, slot, of);
    }
  }

  void end_answer(const Fingerprint& question, int exit_code) {
    begin_answer(question);
    for (auto& [slot, of] : slots_) {
      if (of.next == 0 || !of.rest.empty()) insert(question, slot, of);
    }
    write([&](Database& database) {
      const std::string name = text_of(question);
      Query(database, "INSERT INTO answer(question, exit_code, checksum) VALUES(?, ?, ?)")
          .with_bytes(name)
          .with(std::int64_t{exit_code})
          .with(answer_checksum(database, name, exit_code))
          .finish();
      database.run("COMMIT");
    });
    slots_.clear();
    is_answering_ = false;
  }

  const std::string& path() const { return path_; }
  std::string failure() const {
    const std::lock_guard lock(mutex_);
    return failure_;
  }

 private:
  void open(const RunIdentity& identity) {
    database_.emplace(path_, Database::Access::read_and_write);
    rows_ = open_for_writing(*database_, path_, identity);
  }

  void begin_answer(const Fingerprint& question) {
    if (is_answering_) return;
    is_answering_ = true;
    write([&](Database& database) {
      database.run("BEGIN IMMEDIATE");
      for (const char* sql :
           {"DELETE FROM piece WHERE question = ?", "DELETE FROM answer WHERE question = ?"}) {
        Query(database, sql).with_bytes(text_of(question)).finish();
      }
    });
  }

  void insert(const Fingerprint& question, const std::string& slot, Slot& of) {
    write([&](Database& database) {
      Query(database,
            "INSERT INTO piece(question, slot, number, bytes, checksum) VALUES(?, ?, ?, ?, ?)")
          .with_bytes(text_of(question))
          .with_text(slot)
          .with(of.next)
          .with_bytes(of.rest)
          .with(checksum_of(slot, of.next, of.rest))
          .finish();
    });
    ++of.next;
    of.rest.clear();
  }

  void write_now_and_then() {
    std::unique_lock lock(mutex_);
    while (true) {
      const double pause = std::clamp(kShare * age_.total(), kShortest, kLongest);
      wake_.wait_for(lock, std::chrono::duration<double>(pause),
                     [this] { return is_over_ || pending_.bytes >= kMany; });
      const bool is_last = is_over_;
      const Pending pending = std::exchange(pending_, {});
      room_.notify_all();
      lock.unlock();
      if (!pending.chunks.empty() || pending.told) {
        write([&](Database& database) { commit(database, pending); });
      }
      if (is_last) return;
      lock.lock();
    }
  }

  void commit(Database& database, const Pending& pending) {
    database.run("BEGIN IMMEDIATE");
    Query insert(database, kInsertObservation);
    for (const auto& [list, chunk] : pending.chunks) {
      const std::string name = text_of(list);
      const std::string& outcomes = chunk.outcomes.bytes();
      insert.with_bytes(name)
          .with(chunk.jobs)
          .with(chunk.roots)
          .with(chunk.at_infinity)
          .with(chunk.failed)
          .with_bytes(outcomes)
          .with(checksum_of(name, chunk.jobs, outcomes))
          .finish();
    }
    Query progress(database, "UPDATE progress SET seconds = seconds + ?");
    progress.with(since_commit_.lap()).finish();
    if (pending.told) {
      Query told(database, "UPDATE progress SET done = ?, total = ?, roots = ?");
      told.with(static_cast<std::int64_t>(pending.told->done))
          .with(static_cast<std::int64_t>(pending.told->total))
          .with(static_cast<std::int64_t>(pending.told->roots))
          .finish();
    }
    database.run("COMMIT");
  }

  void fail(const std::string& why) {
    {
      const std::lock_guard lock(mutex_);
      if (has_failed_) return;
      has_failed_ = true;
      failure_ = "the ledger " + path_ + " cannot be written any more: " + why +
                 "; what was committed before stands";
    }
    room_.notify_all();
    try {
      const std::lock_guard lock(database_mutex_);
      database_->run("ROLLBACK");
    } catch (const DatabaseError&) {
      // There was no transaction, or SQLite has rolled it back.
    }
    if (on_failure_) on_failure_();
  }

  const std::string path_;
  FileLock lock_;
  std::function<void()> on_failure_;
  RowsOfLists rows_;  ///< of earlier processes
  Stopwatch age_, since_commit_;

  std::mutex database_mutex_;
  std::optional<Database> database_;
  bool is_answering_ = false;
  std::map<std::string, Slot> slots_;  ///< of the answer that is written

  mutable std::mutex mutex_;
  std::condition_variable wake_, room_;
  Pending pending_;
  bool is_over_ = false;
  std::atomic<bool> has_failed_{false};
  std::string failure_;
  std::thread writer_;
};

RunLedger::RunLedger(const std::string& path, const RunIdentity& identity,
                     std::function<void()> on_failure)
    : books_(std::make_unique<Books>(path, identity, std::move(on_failure))) {}

RunLedger::~RunLedger() = default;

std::map<std::uint64_t, std::string> RunLedger::recall(const Fingerprint& list) {
  return books_->recall(list);
}

void RunLedger::keep(const Fingerprint& list, std::span<const JobOutcome> outcomes) {
  if (!outcomes.empty()) books_->keep(list, outcomes);
}

void RunLedger::tell(std::uint64_t done, std::uint64_t total, std::uint64_t roots) {
  books_->tell({done, total, roots});
}

void RunLedger::close_observations() { books_->close(); }

int RunLedger::exit_code_of(const Fingerprint& question) {
  return books_->read([&](Database& database) {
    return checked_exit_code(database, books_->path(), text_of(question));
  });
}

bool RunLedger::has_answer(const Fingerprint& question, const std::string& slot) {
  return books_->read([&](Database& database) {
    Query row(database, "SELECT 1 FROM piece WHERE question = ? AND slot = ? LIMIT 1");
    return row.with_bytes(text_of(question)).with_text(slot).step();
  });
}

void RunLedger::read_answer(const Fingerprint& question, const std::string& slot,
                            const std::function<void(std::string_view)>& sink) {
  books_->read([&](Database& database) {
    read_pieces(database, books_->path(), text_of(question), slot, sink);
  });
}

void RunLedger::add_to_answer(const Fingerprint& question, const std::string& slot,
                              std::string_view piece) {
  books_->add_to_answer(question, slot, piece);
}

void RunLedger::end_answer(const Fingerprint& question, int exit_code) {
  books_->end_answer(question, exit_code);
}

std::string RunLedger::failure() const { return books_->failure(); }

}  // namespace moivre
