// SPDX-License-Identifier: MIT
// Tables in SQL, and every byte that is read compared with its checksum.
#include "format.h"

#include <cstring>
#include <vector>

#include "moivre/numeric/bytes.h"

namespace moivre {
namespace {

// "Moiv".
constexpr std::int64_t kApplication = 0x4D6F6976;

constexpr const char* kTables =
    "CREATE TABLE identity(place INTEGER PRIMARY KEY, name TEXT, value TEXT);"
    "CREATE TABLE observation(id INTEGER PRIMARY KEY, list BLOB, jobs INTEGER, roots INTEGER,"
    " at_infinity INTEGER, failed INTEGER, outcomes BLOB, checksum INTEGER);"
    "CREATE TABLE progress(id INTEGER PRIMARY KEY CHECK (id = 1), done INTEGER, total INTEGER,"
    " roots INTEGER, seconds REAL);"
    "INSERT INTO progress VALUES(1, 0, 0, 0, 0);"
    "CREATE TABLE answer(id INTEGER PRIMARY KEY, question BLOB, exit_code INTEGER,"
    " checksum INTEGER);"
    "CREATE TABLE piece(question BLOB, slot TEXT, number INTEGER, bytes BLOB, checksum INTEGER,"
    " PRIMARY KEY(question, slot, number)) WITHOUT ROWID;";

Fingerprint fingerprint_in(std::string_view text) {
  Fingerprint fingerprint;
  std::memcpy(&fingerprint.first, text.data(), sizeof fingerprint.first);
  std::memcpy(&fingerprint.second, text.data() + sizeof fingerprint.first,
              sizeof fingerprint.second);
  return fingerprint;
}

/// What comes first says most: of another command nothing else is told.
std::string differences(const RunIdentity& kept, const RunIdentity& asked) {
  const std::map<std::string, std::string> before(kept.begin(), kept.end());
  const std::map<std::string, std::string> now(asked.begin(), asked.end());
  std::vector<std::string> names;
  for (const auto& [name, value] : asked) names.push_back(name);
  for (const auto& [name, value] : kept) {
    if (now.count(name) == 0) names.push_back(name);
  }
  const auto value_of = [](const auto& values, const std::string& name) {
    const auto found = values.find(name);
    return found == values.end() || found->second.empty() ? std::string("nothing") : found->second;
  };
  std::string text;
  for (const std::string& name : names) {
    const std::string was = value_of(before, name);
    const std::string is = value_of(now, name);
    if (was == is) continue;
    text += (text.empty() ? "" : "; ") + name + " was " + was + " and is " + is;
    if (!asked.empty() && name == asked.front().first) break;
  }
  return text;
}

constexpr const char* kOther = "an observation is not what was written";

/// A row of id, list, jobs, outcomes, checksum.
void require_whole(const Query& row, const std::string& path) {
  const bool is_whole = row.bytes(1).size() == 2 * sizeof(std::uint64_t) &&
                        checksum_of(row.bytes(1), row.number(2), row.bytes(3)) == row.number(4);
  if (!is_whole) refuse_damage(path, kOther);
}

bool is_new(Database& database) {
  return database.number("PRAGMA application_id") == 0 &&
         database.number("PRAGMA user_version") == 0 &&
         database.number("SELECT count(*) FROM sqlite_master") == 0;
}

void make_tables(Database& database, const RunIdentity& identity) {
  database.run("BEGIN IMMEDIATE");
  database.run(kTables);
  Query insert(database, "INSERT INTO identity(name, value) VALUES(?, ?)");
  for (const auto& [name, value] : identity) insert.with_text(name).with_text(value).finish();
  database.run("PRAGMA application_id = " + std::to_string(kApplication));
  database.run("PRAGMA user_version = " + std::to_string(kLedgerFormat));
  database.run("COMMIT");
}

}  // namespace

std::string text_of(const Fingerprint& fingerprint) {
  ByteWriter bytes;
  bytes.put(fingerprint.first);
  bytes.put(fingerprint.second);
  return bytes.bytes();
}

std::int64_t checksum_of(std::string_view place, std::int64_t number, std::string_view bytes) {
  FingerprintMaker maker;
  maker.add(place);
  maker.add(static_cast<std::uint64_t>(number));
  maker.add(bytes);
  return static_cast<std::int64_t>(maker.fingerprint().first);
}

void require_format(Database& database, const std::string& path) {
  if (database.number("PRAGMA application_id") != kApplication) {
    throw std::invalid_argument(path + " is no ledger of a run");
  }
  const std::int64_t format = database.number("PRAGMA user_version");
  if (format == kLedgerFormat) return;
  throw std::invalid_argument(path + " is a ledger of format " + std::to_string(format) +
                              "; this version reads and writes " + std::to_string(kLedgerFormat));
}

RunIdentity identity_of(Database& database) {
  RunIdentity identity;
  Query rows(database, "SELECT name, value FROM identity ORDER BY place");
  while (rows.step()) {
    std::string name(rows.bytes(0));
    identity.emplace_back(std::move(name), std::string(rows.bytes(1)));
  }
  return identity;
}

RowsOfLists checked_rows(Database& database, const std::string& path) {
  const std::string verdict = database.text("PRAGMA quick_check(1)");
  if (verdict != "ok") refuse_damage(path, verdict);
  RowsOfLists lists;
  Query rows(database, "SELECT id, list, jobs, outcomes, checksum FROM observation");
  while (rows.step()) {
    require_whole(rows, path);
    lists[fingerprint_in(rows.bytes(1))].push_back(rows.number(0));
  }
  return lists;
}

void require_same_run(const std::string& path, const RunIdentity& kept, const RunIdentity& asked) {
  const std::string other = differences(kept, asked);
  if (other.empty()) return;
  throw std::invalid_argument(path + " is the ledger of another run: " + other);
}

RowsOfLists open_for_writing(Database& database, const std::string& path,
                             const RunIdentity& identity) {
  const bool is_fresh = is_new(database);
  RowsOfLists rows;
  if (!is_fresh) {
    require_format(database, path);
    rows = checked_rows(database, path);
    require_same_run(path, identity_of(database), identity);
  }
  // Rows are long: with SQLite's own 4096 bytes there are eight times as many writes.
  if (is_fresh) database.run("PRAGMA page_size = 32768");
  // A commit writes each page once.
  database.run("PRAGMA cache_size = -256");
  database.run("PRAGMA journal_mode = WAL");
  database.run("PRAGMA synchronous = FULL");
  if (is_fresh) make_tables(database, identity);
  return rows;
}

std::map<std::uint64_t, std::string> outcomes_in(Database& database, const std::string& path,
                                                 const std::vector<std::int64_t>& rows) {
  std::map<std::uint64_t, std::string> outcomes;
  Query row(database, "SELECT id, list, jobs, outcomes, checksum FROM observation WHERE id = ?");
  for (const std::int64_t id : rows) {
    if (!row.with(id).step()) refuse_damage(path, kOther);
    require_whole(row, path);
    ByteReader bytes(row.bytes(3));
    while (!bytes.is_at_end()) {
      const auto job = bytes.get<std::uint64_t>();
      outcomes[job] = bytes.get_text();
    }
    row.finish();
  }
  return outcomes;
}

std::int64_t answer_checksum(Database& database, std::string_view question,
                             std::int64_t exit_code) {
  Query slots(database,
              "SELECT slot, count(*) FROM piece WHERE question = ? GROUP BY slot ORDER BY slot");
  slots.with_bytes(question);
  FingerprintMaker maker;
  maker.add(question);
  maker.add(static_cast<std::uint64_t>(exit_code));
  while (slots.step()) {
    maker.add(slots.bytes(0));
    maker.add(static_cast<std::uint64_t>(slots.number(1)));
  }
  return static_cast<std::int64_t>(maker.fingerprint().first);
}

int checked_exit_code(Database& database, const std::string& path, std::string_view question) {
  Query row(database, "SELECT exit_code, checksum FROM answer WHERE question = ?");
  if (!row.with_bytes(question).step()) return -1;
  if (answer_checksum(database, question, row.number(0)) != row.number(1)) {
    refuse_damage(path, "an answer is not what was written");
  }
  return static_cast<int>(row.number(0));
}

void read_pieces(Database& database, const std::string& path, std::string_view question,
                 const std::string& slot, const std::function<void(std::string_view)>& sink) {
  Query rows(database,
             "SELECT number, bytes, checksum FROM piece WHERE question = ? AND slot = ? "
             "ORDER BY number");
  rows.with_bytes(question).with_text(slot);
  for (std::int64_t next = 0; rows.step(); ++next) {
    const bool is_whole = rows.number(0) == next &&
                          checksum_of(slot, rows.number(0), rows.bytes(1)) == rows.number(2);
    if (!is_whole) refuse_damage(path, "an answer is not what was written");
    sink(rows.bytes(1));
  }
}

void refuse_damage(const std::string& path, const std::string& why) {
  throw std::invalid_argument("the ledger " + path + " is damaged: " + why);
}

}  // namespace moivre
