#include "evaluate/database.h"

#include <fmt/format.h>
#include <sqlite3.h>

#include <limits>
#include <system_error>

#include "terrains/input_error.h"

namespace headland {
namespace {

constexpr int kMillisecondsPerSecond = 1000;

std::string reason_of(sqlite3* database, int code) {
  const int primary = code & 0xff;
  if (primary == SQLITE_FULL) return "cannot be written: no space left on the disk";
  if (primary == SQLITE_NOTADB) return "not a store of runs: no SQLite database";
  if (primary == SQLITE_BUSY) {
    return fmt::format("another program has kept it locked for {} s", kBusy_s);
  }
  std::string reason = sqlite3_errmsg(database);
  const int system = sqlite3_system_errno(database);
  if ((primary == SQLITE_IOERR || primary == SQLITE_CANTOPEN) && system != 0) {
    reason += ": " + std::generic_category().message(system);
  }
  return reason;
}

[[noreturn]] void fail(sqlite3* database, int code) {
  const char* const name = sqlite3_db_filename(database, "main");
  throw InputError(name == nullptr ? "" : name, "", "", reason_of(database, code));
}

void require(sqlite3* database, int code) {
  if (code != SQLITE_OK) fail(database, code);
}

sqlite3* database_of(const Statement& statement) { return sqlite3_db_handle(statement.get()); }

// A file name as SQLite's URI, in which some letters mean something.
std::string uri_of(const std::filesystem::path& file, std::string_view option) {
  std::string uri = "file:";
  for (const char letter : std::filesystem::absolute(file).string()) {
    const bool special = letter == '%' || letter == '?' || letter == '#';
    uri += special ? fmt::format("%{:02x}", static_cast<unsigned char>(letter))
                   : std::string(1, letter);
  }
  return fmt::format("{}?{}", uri, option);
}

int try_open(const std::filesystem::path& file, std::string_view option, int flags,
             Database& database) {
  sqlite3* opened = nullptr;
  const int code = sqlite3_open_v2(uri_of(file, option).c_str(), &opened,
                                   flags | SQLITE_OPEN_URI | SQLITE_OPEN_EXRESCODE, nullptr);
  database.reset(opened);
  if (code != SQLITE_OK) return code;
  sqlite3_busy_timeout(opened, kBusy_s * kMillisecondsPerSecond);
  // Opening alone does not look into the file.
  return sqlite3_exec(opened, "PRAGMA schema_version", nullptr, nullptr, nullptr);
}

}  // namespace

void CloseDatabase::operator()(sqlite3* database) const { sqlite3_close_v2(database); }

void FinalizeStatement::operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }

Database open_database(const std::filesystem::path& file, DatabaseMode mode) {
  Database database;
  int code = SQLITE_OK;
  if (mode == DatabaseMode::kWrite) {
    code = try_open(file, "mode=rwc", SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE, database);
  } else {
    code = try_open(file, "mode=ro", SQLITE_OPEN_READONLY, database);
    // In a folder that cannot be written to, where no program has it open, it does not change.
    if ((code & 0xff) == SQLITE_CANTOPEN && std::filesystem::exists(file)) {
      code = try_open(file, "mode=ro&immutable=1", SQLITE_OPEN_READONLY, database);
    }
  }
  if (code == SQLITE_OK) return database;
  throw InputError(file.string(), "", "", reason_of(database.get(), code));
}

void execute(const Database& database, const std::string& sql) {
  require(database.get(), sqlite3_exec(database.get(), sql.c_str(), nullptr, nullptr, nullptr));
}

Statement prepare(const Database& database, std::string_view sql) {
  sqlite3_stmt* statement = nullptr;
  require(database.get(), sqlite3_prepare_v2(database.get(), sql.data(),
                                             static_cast<int>(sql.size()), &statement, nullptr));
  return Statement(statement);
}

void bind_value(const Statement& statement, int place, std::string_view text) {
  require(database_of(statement), sqlite3_bind_text64(statement.get(), place, text.data(),
                                                      text.size(), SQLITE_TRANSIENT, SQLITE_UTF8));
}

void bind_value(const Statement& statement, int place, std::int64_t number) {
  require(database_of(statement), sqlite3_bind_int64(statement.get(), place, number));
}

void bind_value(const Statement& statement, int place, double number) {
  require(database_of(statement), sqlite3_bind_double(statement.get(), place, number));
}

bool step(const Statement& statement) {
  const int code = sqlite3_step(statement.get());
  if (code == SQLITE_ROW) return true;
  if (code != SQLITE_DONE) fail(database_of(statement), code);
  return false;
}

void reset(const Statement& statement) { sqlite3_reset(statement.get()); }

bool is_null(const Statement& statement, int column) {
  return sqlite3_column_type(statement.get(), column) == SQLITE_NULL;
}

bool is_number(const Statement& statement, int column) {
  const int type = sqlite3_column_type(statement.get(), column);
  return type == SQLITE_FLOAT || type == SQLITE_INTEGER;
}

double number_at(const Statement& statement, int column) {
  if (is_null(statement, column)) return std::numeric_limits<double>::quiet_NaN();
  return sqlite3_column_double(statement.get(), column);
}

std::int64_t whole_number_at(const Statement& statement, int column) {
  return sqlite3_column_int64(statement.get(), column);
}

std::string_view text_at(const Statement& statement, int column) {
  const unsigned char* text = sqlite3_column_text(statement.get(), column);
  const int length = sqlite3_column_bytes(statement.get(), column);
  return {reinterpret_cast<const char*>(text), static_cast<std::size_t>(length)};
}

std::int64_t whole_number_of(const Database& database, std::string_view sql) {
  const Statement statement = prepare(database, sql);
  return step(statement) ? whole_number_at(statement, 0) : 0;
}

Transaction::Transaction(const Database& database) : database_(database) {
  execute(database_, "BEGIN IMMEDIATE");
}

Transaction::~Transaction() {
  if (open_) sqlite3_exec(database_.get(), "ROLLBACK", nullptr, nullptr, nullptr);
}

void Transaction::commit() {
  execute(database_, "COMMIT");
  open_ = false;
}

}  // namespace headland
