// SPDX-License-Identifier: MIT
// Rows of one ledger copied into another, once each.
#include "moivre/run_ledger/merge.h"

#include <filesystem>
#include <set>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "file_lock.h"
#include "format.h"
#include "ledger_reading.h"

namespace moivre {
namespace {

RunIdentity identity_in(const std::string& path) {
  return told_of(path, [&] {
    const LedgerReading reading(path);
    if (reading.is_running) throw std::invalid_argument(path + " is being written by a run");
    Database database(path, Database::Access::read);
    require_format(database, path);
    return identity_of(database);
  });
}

/// Their lists and checksums.
using KnownRows = std::set<std::pair<std::string, std::int64_t>>;

KnownRows rows_of(Database& ledger) {
  KnownRows known;
  Query rows(ledger, "SELECT list, checksum FROM observation");
  while (rows.step()) known.emplace(rows.bytes(0), rows.number(1));
  return known;
}

/// Of the same outcomes one row is enough.
void copy_rows(Database& part, Database& ledger) {
  KnownRows known = rows_of(ledger);
  Query rows(part,
             "SELECT list, jobs, roots, at_infinity, failed, outcomes, checksum FROM observation "
             "ORDER BY id");
  Query insert(ledger, kInsertObservation);
  while (rows.step()) {
    if (!known.emplace(rows.bytes(0), rows.number(6)).second) continue;
    insert.with_bytes(rows.bytes(0))
        .with(rows.number(1))
        .with(rows.number(2))
        .with(rows.number(3))
        .with(rows.number(4))
        .with_bytes(rows.bytes(5))
        .with(rows.number(6))
        .finish();
  }
}

void add_progress(Database& part, Database& ledger) {
  Query progress(part, "SELECT done, total, roots, seconds FROM progress");
  if (!progress.step()) return;
  Query(ledger,
        "UPDATE progress SET done = max(done, ?), total = max(total, ?), roots = max(roots, ?), "
        "seconds = seconds + ?")
      .with(progress.number(0))
      .with(progress.number(1))
      .with(progress.number(2))
      .with(progress.real(3))
      .finish();
}

void take(const std::string& path, const std::string& into, Database& ledger) {
  told_of(path, [&] {
    const LedgerReading reading(path);
    Database part(path, Database::Access::read);
    require_format(part, path);
    checked_rows(part, path);
    told_of(into, [&] {
      ledger.run("BEGIN IMMEDIATE");
      copy_rows(part, ledger);
      add_progress(part, ledger);
      ledger.run("COMMIT");
    });
  });
}

}  // namespace

void merge_ledgers(const std::string& ledger, const std::vector<std::string>& parts) {
  for (const std::string& part : parts) {
    std::error_code ignored;
    if (!std::filesystem::equivalent(ledger, part, ignored)) continue;
    throw std::invalid_argument(part + " is the ledger that the parts are to go into");
  }
  const RunIdentity identity = identity_in(parts.front());
  for (const std::string& part : parts) require_same_run(part, identity_in(part), identity);
  const FileLock lock(ledger);
  told_of(ledger, [&] {
    Database database(ledger, Database::Access::read_and_write);
    open_for_writing(database, ledger, identity);
    for (const std::string& part : parts) take(part, ledger, database);
  });
}

}  // namespace moivre
