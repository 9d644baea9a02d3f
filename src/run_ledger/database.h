// SPDX-License-Identifier: MIT
// How is SQLite called? A connection and a query that close themselves, and errors that are thrown.
//
// Private to the module.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

namespace moivre {

/// SQLite's own words.
class DatabaseError : public std::runtime_error {
 public:
  DatabaseError(const std::string& what, bool damaged)
      : std::runtime_error(what), is_damage(damaged) {}
  bool is_damage;  ///< the file is not what SQLite has written
};

class Database {
 public:
  enum class Access { read, read_and_write };
  Database(const std::string& path, Access access);
  ~Database();
  Database(const Database&) = delete;
  Database& operator=(const Database&) = delete;

  void run(const std::string& sql);
  /// The first number of the first row; 0 where there is none.
  std::int64_t number(const std::string& sql);
  std::string text(const std::string& sql);

  sqlite3* handle() const { return handle_; }

 private:
  sqlite3* handle_ = nullptr;
};

class Query {
 public:
  Query(Database& database, std::string_view sql);
  ~Query();
  Query(const Query&) = delete;
  Query& operator=(const Query&) = delete;

  // The next parameter. Bytes are not copied: they have to stay until the last step.
  Query& with(std::int64_t value);
  Query& with(double value);
  Query& with_text(std::string_view value);
  Query& with_bytes(std::string_view value);

  /// The next row; false at the end.
  bool step();
  /// To the end, and ready for other parameters.
  void finish();

  std::int64_t number(int column) const;
  double real(int column) const;
  std::string_view bytes(int column) const;  ///< until the next step

 private:
  Database& database_;
  sqlite3_stmt* statement_ = nullptr;
  int bound_ = 0;
};

}  // namespace moivre
