// SPDX-License-Identifier: MIT
// What does a ledger look like in its file? Its tables, its number, and what is refused.
//
// Private to the module.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "database.h"
#include "moivre/run_ledger/run_ledger.h"

namespace moivre {

/// Of the tables; another one is refused.
inline constexpr int kLedgerFormat = 1;

/// As bytes in the file.
std::string text_of(const Fingerprint& fingerprint);
std::int64_t checksum_of(std::string_view place, std::int64_t number, std::string_view bytes);

/// Of a row's list, jobs, roots, at_infinity, failed, outcomes and checksum.
inline constexpr const char* kInsertObservation =
    "INSERT INTO observation(list, jobs, roots, at_infinity, failed, outcomes, checksum) "
    "VALUES(?, ?, ?, ?, ?, ?, ?)";

/// Throws std::invalid_argument where the file is no ledger of this format. `path` is its name in
/// the message.
void require_format(Database& database, const std::string& path);
RunIdentity identity_of(Database& database);

/// The rows of each list.
using RowsOfLists = std::map<Fingerprint, std::vector<std::int64_t>>;
/// Reads all of the file. Throws std::invalid_argument where something in it is not what was
/// written.
RowsOfLists checked_rows(Database& database, const std::string& path);

/// Throws std::invalid_argument, with what differs, where they are of two runs.
void require_same_run(const std::string& path, const RunIdentity& kept, const RunIdentity& asked);

/// Makes the tables of a new ledger, or reads all of one. Throws std::invalid_argument where it is
/// none of this run.
RowsOfLists open_for_writing(Database& database, const std::string& path,
                             const RunIdentity& identity);

/// The outcomes in these rows. Throws std::invalid_argument.
std::map<std::uint64_t, std::string> outcomes_in(Database& database, const std::string& path,
                                                 const std::vector<std::int64_t>& rows);

/// Of a finished run: its exit code, and how many pieces each slot has.
std::int64_t answer_checksum(Database& database, std::string_view question, std::int64_t exit_code);
/// -1: there is no answer. Throws std::invalid_argument where it is not what was written.
int checked_exit_code(Database& database, const std::string& path, std::string_view question);
/// Throws std::invalid_argument where a piece is not what was written.
void read_pieces(Database& database, const std::string& path, std::string_view question,
                 const std::string& slot, const std::function<void(std::string_view)>& sink);

[[noreturn]] void refuse_damage(const std::string& path, const std::string& why);

/// Calls f; what SQLite refuses is thrown as std::invalid_argument about the file.
template <class F>
auto told_of(const std::string& path, const F& f) {
  try {
    return f();
  } catch (const DatabaseError& error) {
    if (error.is_damage) refuse_damage(path, error.what());
    throw std::invalid_argument("cannot use the ledger " + path + ": " + error.what());
  }
}

}  // namespace moivre
