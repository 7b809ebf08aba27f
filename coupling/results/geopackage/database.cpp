#include "coupling/results/geopackage/database.hpp"

#include <sqlite3.h>

#include <utility>

#include "config/errors/input_error.hpp"
#include "config/text/joined.hpp"
#include "coupling/results/disk/out_file.hpp"

namespace coupling::geopackage {

using config::joined;

Database::Database(std::filesystem::path file, Open open) : file_{std::move(file)}, open_{open} {
    if (open == Open::empty) {
        delete_entry(file_);
    }
    const int flags =
        SQLITE_OPEN_NOMUTEX |
        (open == Open::to_read ? SQLITE_OPEN_READONLY : SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE);
    const int code =
        sqlite3_open_v2(open == Open::in_memory ? ":memory:" : file_.c_str(), &handle_, flags, nullptr);
    if (code != SQLITE_OK) {
        const std::string reason = sqlite3_errstr(code);
        sqlite3_close(std::exchange(handle_, nullptr));
        config::fail(config::ExitCode::file, {.file = file_.string()},
                     joined("cannot be opened as a database: ", reason));
    }
    if (open == Open::empty) {
        // One writer, and a file that is thrown away unless it becomes whole: nothing to roll back, nothing
        // to wait for.
        execute(
            "PRAGMA page_size = 4096; PRAGMA journal_mode = OFF; PRAGMA synchronous = OFF; PRAGMA "
            "locking_mode = EXCLUSIVE; "
            "PRAGMA temp_store = MEMORY; PRAGMA cache_size = -65536;");
    }
}

Database::~Database() {
    sqlite3_close_v2(handle_);
}

void Database::execute(const std::string& sql) {
    const int code = sqlite3_exec(handle_, sql.c_str(), nullptr, nullptr, nullptr);
    if (code != SQLITE_OK) {
        fail(code);
    }
}

Statement Database::prepare(const std::string& sql) {
    return Statement{*this, sql};
}

void Database::close() {
    const int code = sqlite3_close(handle_);
    if (code != SQLITE_OK) {
        fail(code);
    }
    handle_ = nullptr;
}

std::string Database::bytes() {
    sqlite3_int64 size = 0;
    unsigned char* const bytes = sqlite3_serialize(handle_, "main", &size, 0);
    if (bytes == nullptr) {
        fail(SQLITE_NOMEM);
    }
    std::string copy{reinterpret_cast<const char*>(bytes), static_cast<std::size_t>(size)};
    sqlite3_free(bytes);
    return copy;
}

void Database::fail(int code) const {
    // A full disk is reported by the system, not by SQLite's words alone.
    const std::string reason =
        (code & 0xFF) == SQLITE_FULL ? "No space left on the disk" : sqlite3_errmsg(handle_);
    if (open_ == Open::in_memory) {
        config::fail(config::ExitCode::data, {.file = file_.string()}, reason);
    }
    config::fail(config::ExitCode::file, {.file = file_.string()},
                 joined("cannot be written or read: ", reason));
}

Statement::Statement(Database& database, const std::string& sql) : database_{database} {
    check(sqlite3_prepare_v2(database.handle_, sql.c_str(), -1, &handle_, nullptr));
}

Statement::~Statement() {
    sqlite3_finalize(handle_);
}

Statement& Statement::bind(int parameter, std::int64_t value) {
    check(sqlite3_bind_int64(handle_, parameter, value));
    return *this;
}

Statement& Statement::bind(int parameter, double value) {
    check(sqlite3_bind_double(handle_, parameter, value));
    return *this;
}

Statement& Statement::bind(int parameter, std::string_view text) {
    check(sqlite3_bind_text64(handle_, parameter, text.data(), text.size(), nullptr, SQLITE_UTF8));
    return *this;
}

Statement& Statement::bind_bytes(int parameter, std::span<const std::uint8_t> bytes) {
    check(sqlite3_bind_blob64(handle_, parameter, bytes.data(), bytes.size(), nullptr));
    return *this;
}

Statement& Statement::bind_null(int parameter) {
    check(sqlite3_bind_null(handle_, parameter));
    return *this;
}

std::vector<std::string> Statement::parameters() const {
    std::vector<std::string> names;
    for (int i = 1; i <= sqlite3_bind_parameter_count(handle_); ++i) {
        const char* const name = sqlite3_bind_parameter_name(handle_, i);
        names.emplace_back(name == nullptr ? "?" : name);
    }
    return names;
}

bool Statement::step() {
    const int code = sqlite3_step(handle_);
    if (code == SQLITE_ROW) {
        return true;
    }
    if (code != SQLITE_DONE) {
        database_.fail(code);
    }
    check(sqlite3_reset(handle_));
    return false;
}

int Statement::columns() const {
    return sqlite3_column_count(handle_);
}

std::string Statement::name(int column) const {
    return sqlite3_column_name(handle_, column);
}

bool Statement::is_null(int column) const {
    return sqlite3_column_type(handle_, column) == SQLITE_NULL;
}

bool Statement::is_number(int column) const {
    return sqlite3_column_type(handle_, column) == SQLITE_FLOAT;
}

std::int64_t Statement::whole(int column) const {
    return sqlite3_column_int64(handle_, column);
}

double Statement::number(int column) const {
    return sqlite3_column_double(handle_, column);
}

std::string Statement::text(int column) const {
    const auto* bytes = static_cast<const char*>(sqlite3_column_blob(handle_, column));
    return bytes == nullptr
               ? std::string{}
               : std::string(bytes, static_cast<std::size_t>(sqlite3_column_bytes(handle_, column)));
}

std::span<const std::uint8_t> Statement::bytes(int column) const {
    const auto* bytes = static_cast<const std::uint8_t*>(sqlite3_column_blob(handle_, column));
    return {bytes, bytes == nullptr ? 0 : static_cast<std::size_t>(sqlite3_column_bytes(handle_, column))};
}

void Statement::check(int code) const {
    if (code != SQLITE_OK) {
        database_.fail(code);
    }
}

std::string sql_name(std::string_view name) {
    std::string text{"\""};
    for (const char c : name) {
        text += c;
        if (c == '"') {
            text += '"';
        }
    }
    return text += '"';
}

}  // namespace coupling::geopackage
