#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

struct sqlite3;
struct sqlite3_stmt;

namespace coupling::geopackage {

class Statement;

/// An SQLite file: open as long as this object lives.
///
/// Whatever SQLite cannot do (no such folder, no permission, disk full) throws config::InputError (file)
/// naming the file and SQLite's own reason.
class Database {
public:
    enum class Open { empty, to_read, in_memory };
    /// empty: an empty file, without journal and without waiting for the disk. It is no results file until it
    /// is closed. in_memory: nothing on the disk; `file` is where its queries come from, for messages.
    Database(std::filesystem::path file, Open open);
    ~Database();
    Database(const Database&) = delete;
    Database& operator=(const Database&) = delete;

    /// One or several statements without results.
    void execute(const std::string& sql);
    [[nodiscard]] Statement prepare(const std::string& sql);
    /// All is on its way to the disk, or it throws. Requires that no statement is left.
    void close();
    /// What would stand in its file. Requires one in memory.
    [[nodiscard]] std::string bytes();

private:
    friend class Statement;
    [[noreturn]] void fail(int code) const;

    std::filesystem::path file_;
    Open open_;
    sqlite3* handle_ = nullptr;
};

/// A prepared statement. Parameters and columns count from 1 and 0, as in SQLite.
class Statement {
public:
    Statement(Database& database, const std::string& sql);
    ~Statement();
    Statement(const Statement&) = delete;
    Statement& operator=(const Statement&) = delete;

    Statement& bind(int parameter, std::int64_t value);
    Statement& bind(int parameter, double value);
    /// The text has to live until the statement was stepped.
    Statement& bind(int parameter, std::string_view text);
    Statement& bind(int parameter, const std::string& text) {
        return bind(parameter, std::string_view{text});
    }
    Statement& bind(int parameter, const char* text) { return bind(parameter, std::string_view{text}); }
    /// The bytes have to live until the statement was stepped.
    Statement& bind_bytes(int parameter, std::span<const std::uint8_t> bytes);
    Statement& bind_null(int parameter);
    /// Names of the parameters as the statement has them, such as ":site", the first one first.
    [[nodiscard]] std::vector<std::string> parameters() const;

    /// Runs to the next row; false: there is none, and the statement can be bound and run again.
    bool step();
    /// Runs a statement without rows.
    void run() { (void)step(); }

    [[nodiscard]] int columns() const;
    [[nodiscard]] std::string name(int column) const;
    [[nodiscard]] bool is_null(int column) const;
    /// Whether it is a number with decimals.
    [[nodiscard]] bool is_number(int column) const;
    [[nodiscard]] std::int64_t whole(int column) const;
    [[nodiscard]] double number(int column) const;
    [[nodiscard]] std::string text(int column) const;
    /// They live until the statement is stepped.
    [[nodiscard]] std::span<const std::uint8_t> bytes(int column) const;

private:
    void check(int code) const;

    Database& database_;
    sqlite3_stmt* handle_ = nullptr;
};

/// A name as SQL wants it: in double quotes.
std::string sql_name(std::string_view name);

}  // namespace coupling::geopackage
