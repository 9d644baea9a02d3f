// SPDX-License-Identifier: MIT
// The only code that knows SQLite.
#include "database.h"

#include <sqlite3.h>

namespace moivre {
namespace {

// Others read the file at times, and hold it for an instant.
constexpr int kPatience = 10'000;

[[noreturn]] void refuse(sqlite3* handle, int code) {
  const int kind = code & 0xff;
  const bool is_damage = kind == SQLITE_CORRUPT || kind == SQLITE_NOTADB || kind == SQLITE_MISMATCH;
  throw DatabaseError(handle != nullptr ? sqlite3_errmsg(handle) : sqlite3_errstr(code), is_damage);
}

/// No name is special to SQLite.
std::string plain(const std::string& path) { return path.starts_with('/') ? path : "./" + path; }

}  // namespace

Database::Database(const std::string& path, Access access) {
  const int flags = access == Access::read ? SQLITE_OPEN_READONLY : SQLITE_OPEN_READWRITE;
  const int code =
      sqlite3_open_v2(plain(path).c_str(), &handle_, flags | SQLITE_OPEN_FULLMUTEX, nullptr);
  if (code != SQLITE_OK) {
    const std::string why = handle_ != nullptr ? sqlite3_errmsg(handle_) : sqlite3_errstr(code);
    sqlite3_close(handle_);
    throw DatabaseError(why, false);
  }
  sqlite3_busy_timeout(handle_, kPatience);
}

Database::~Database() { sqlite3_close(handle_); }

void Database::run(const std::string& sql) {
  const int code = sqlite3_exec(handle_, sql.c_str(), nullptr, nullptr, nullptr);
  if (code != SQLITE_OK) refuse(handle_, code);
}

std::int64_t Database::number(const std::string& sql) {
  Query statement(*this, sql);
  return statement.step() ? statement.number(0) : 0;
}

std::string Database::text(const std::string& sql) {
  Query statement(*this, sql);
  return statement.step() ? std::string(statement.bytes(0)) : "";
}

Query::Query(Database& database, std::string_view sql) : database_(database) {
  const int code = sqlite3_prepare_v2(database.handle(), sql.data(), static_cast<int>(sql.size()),
                                      &statement_, nullptr);
  if (code != SQLITE_OK) refuse(database.handle(), code);
}

Query::~Query() { sqlite3_finalize(statement_); }

Query& Query::with(std::int64_t value) {
  sqlite3_bind_int64(statement_, ++bound_, value);
  return *this;
}

Query& Query::with(double value) {
  sqlite3_bind_double(statement_, ++bound_, value);
  return *this;
}

// NOLINTBEGIN(performance-no-int-to-ptr, cppcoreguidelines-pro-type-cstyle-cast): SQLite's own
// constant
Query& Query::with_text(std::string_view value) {
  sqlite3_bind_text64(statement_, ++bound_, value.data(), value.size(), SQLITE_TRANSIENT,
                      SQLITE_UTF8);
  return *this;
}

Query& Query::with_bytes(std::string_view value) {
  // A null pointer would be no bytes at all.
  const char* data = value.empty() ? "" : value.data();
  const int code = sqlite3_bind_blob64(statement_, ++bound_, data, value.size(), SQLITE_STATIC);
  if (code != SQLITE_OK) refuse(database_.handle(), code);
  return *this;
}
// NOLINTEND(performance-no-int-to-ptr, cppcoreguidelines-pro-type-cstyle-cast)

bool Query::step() {
  const int code = sqlite3_step(statement_);
  if (code == SQLITE_ROW) return true;
  if (code == SQLITE_DONE) return false;
  refuse(database_.handle(), code);
}

void Query::finish() {
  while (step()) {
  }
  sqlite3_reset(statement_);
  bound_ = 0;
}

std::int64_t Query::number(int column) const { return sqlite3_column_int64(statement_, column); }

double Query::real(int column) const { return sqlite3_column_double(statement_, column); }

std::string_view Query::bytes(int column) const {
  const auto* data = static_cast<const char*>(sqlite3_column_blob(statement_, column));
  const int size = sqlite3_column_bytes(statement_, column);
  return data == nullptr ? std::string_view()
                         : std::string_view(data, static_cast<std::size_t>(size));
}

}  // namespace moivre
