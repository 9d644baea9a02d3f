// SPDX-License-Identifier: MIT
// The figures of a ledger, read without writing.
#include "moivre/run_ledger/standing.h"

#include <algorithm>
#include <stdexcept>

#include "format.h"
#include "ledger_reading.h"

namespace moivre {
namespace {

void read_figures(Database& database, const std::string& path, RunStanding& standing) {
  Query progress(database, "SELECT done, total, roots, seconds FROM progress");
  if (progress.step()) {
    standing.done = static_cast<std::uint64_t>(progress.number(0));
    standing.total = static_cast<std::uint64_t>(progress.number(1));
    standing.roots = static_cast<std::uint64_t>(progress.number(2));
    standing.seconds = progress.real(3);
  }
  Query sums(database,
             "SELECT sum(jobs), sum(roots), sum(at_infinity), sum(failed) FROM observation");
  if (sums.step()) {
    standing.outcomes = static_cast<std::uint64_t>(sums.number(0));
    standing.to_roots = static_cast<std::uint64_t>(sums.number(1));
    standing.at_infinity = static_cast<std::uint64_t>(sums.number(2));
    standing.failed = static_cast<std::uint64_t>(sums.number(3));
  }
  Query answer(database, "SELECT question FROM answer ORDER BY id DESC LIMIT 1");
  standing.is_finished = answer.step();
  if (standing.is_finished) {
    standing.exit_code = checked_exit_code(database, path, std::string(answer.bytes(0)));
  }
}

}  // namespace

double RunStanding::seconds_left() const {
  const std::uint64_t passed = outcomes <= total ? std::max(done, outcomes) : done;
  if (passed == 0 || total < passed) return -1;
  return seconds * static_cast<double>(total - passed) / static_cast<double>(passed);
}

RunStanding read_standing(const std::string& path) {
  return told_of(path, [&] {
    const LedgerReading reading(path);
    Database database(path, Database::Access::read);
    require_format(database, path);
    RunStanding standing;
    standing.is_running = reading.is_running;
    standing.identity = identity_of(database);
    read_figures(database, path, standing);
    return standing;
  });
}

bool read_last_answer(const std::string& path, const std::string& slot,
                      const std::function<void(std::string_view)>& sink) {
  return told_of(path, [&] {
    const LedgerReading reading(path);
    Database database(path, Database::Access::read);
    require_format(database, path);
    Query last(database,
               "SELECT question FROM answer WHERE EXISTS (SELECT 1 FROM piece WHERE "
               "piece.question = answer.question AND slot = ?) ORDER BY id DESC LIMIT 1");
    if (!last.with_text(slot).step()) return false;
    const std::string question(last.bytes(0));
    checked_exit_code(database, path, question);
    read_pieces(database, path, question, slot, sink);
    return true;
  });
}

}  // namespace moivre
