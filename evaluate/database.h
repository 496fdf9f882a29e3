// SQLite databases. Whatever fails throws InputError with the file and SQLite's reason: a full
// disk, a file that is no database, another program that holds it too long.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

struct sqlite3;  // of SQLite
struct sqlite3_stmt;

namespace headland {

struct CloseDatabase {
  void operator()(sqlite3* database) const;
};
using Database = std::unique_ptr<sqlite3, CloseDatabase>;

enum class DatabaseMode {
  kRead,  // nothing on disk changes, also not by what is executed
  kWrite  // made when it is not there
};

// Waits for other programs up to kBusy_s, here and in everything below.
Database open_database(const std::filesystem::path& file, DatabaseMode mode);
inline constexpr int kBusy_s = 60;

// One or several statements without results.
void execute(const Database& database, const std::string& sql);

struct FinalizeStatement {
  void operator()(sqlite3_stmt* statement) const;
};
using Statement = std::unique_ptr<sqlite3_stmt, FinalizeStatement>;

// One statement; places of values, from 1, are question marks.
Statement prepare(const Database& database, std::string_view sql);
void bind_value(const Statement& statement, int place, std::string_view text);
void bind_value(const Statement& statement, int place, std::int64_t number);
void bind_value(const Statement& statement, int place, double number);  // NaN: NULL

// Whether there is a row (or another one).
bool step(const Statement& statement);
// Makes it ready to be stepped through from its begin.
void reset(const Statement& statement);

// Of the row, columns from 0.
bool is_null(const Statement& statement, int column);
bool is_number(const Statement& statement, int column);
double number_at(const Statement& statement, int column);  // NULL: NaN
std::int64_t whole_number_at(const Statement& statement, int column);
std::string_view text_at(const Statement& statement, int column);  // until the next step

// Of a statement with one row of one number, such as a pragma.
std::int64_t whole_number_of(const Database& database, std::string_view sql);

// Writes between its begin and `commit` become visible together or not at all.
class Transaction {
 public:
  explicit Transaction(const Database& database);
  ~Transaction();
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  void commit();

 private:
  const Database& database_;
  bool open_ = true;
};

}  // namespace headland
