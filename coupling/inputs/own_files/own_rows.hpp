#pragma once

#include <cstdint>
#include <deque>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "config/errors/input_error.hpp"
#include "coupling/inputs/own_files/file_reader.hpp"
#include "coupling/inputs/own_files/table_count.hpp"

namespace coupling {

/// The rows of a table that this program wrote (CsvRow, write_table), one after the other: the only reader
/// of such tables.
///
/// Fields in quotes hold commas, line breaks and doubled quotes. Whatever this program cannot have written
/// is refused by config::InputError naming file and line: a row with another number of fields than the
/// header, a quote that does not close or something behind one, a last row without its line end, another
/// count of bytes or rows than the writer's. A read error throws too (FileReader): nothing but the end of
/// the table ends the rows.
class OwnRows {
public:
    /// @param end      as the writer counted, where that is known
    /// @param damaged  exit code for a table that this program cannot have written
    explicit OwnRows(const std::filesystem::path& file, std::optional<TableEnd> end = std::nullopt,
                     config::ExitCode damaged = config::ExitCode::file);
    /// Of a text in memory, which has to live as long as this object.
    OwnRows(std::string_view text, std::string name);

    [[nodiscard]] const std::vector<std::string>& columns() const { return columns_; }
    /// Place of a column. Throws config::InputError if there is none of this name.
    [[nodiscard]] std::size_t column(std::string_view name) const;
    /// ',' or, in tables that were written for Excel, ';'.
    [[nodiscard]] char separator() const { return separator_; }
    /// Goes on to the next row; false at the end.
    bool next();
    /// Fields of the row, until the next one.
    [[nodiscard]] const std::vector<std::string_view>& fields() const { return fields_; }
    /// The line on which the row begins, counted from 1.
    [[nodiscard]] std::uint64_t line() const { return line_; }
    /// Share of the table that was gone through [0, 1].
    [[nodiscard]] double share() const;
    /// Throws config::InputError: the row is none that this program wrote.
    [[noreturn]] void refuse(const std::string& found) const;

private:
    enum class Read { whole, cut_off };

    void read_header();
    bool read_row();
    Read parse_row();
    std::optional<std::string_view> parse_quoted(std::size_t& at);
    bool fill();
    void check_end() const;

    std::string name_;
    config::ExitCode damaged_;
    std::optional<TableEnd> end_;
    std::unique_ptr<FileReader> reader_;  ///< none for a text in memory
    std::vector<char> block_;             ///< of the file
    std::string_view text_;               ///< the text in memory, or what is filled of the block
    std::size_t at_ = 0;                  ///< in the text: where the next row begins
    std::uint64_t before_ = 0;            ///< bytes of the table before the text
    std::uint64_t bytes_ = 0;             ///< of the whole table
    std::uint64_t rows_ = 0;
    std::uint64_t line_ = 0;
    std::uint64_t next_line_ = 1;
    char separator_ = ',';
    std::vector<std::string> columns_;
    std::vector<std::string_view> fields_;
    std::deque<std::string> unquoted_;  ///< fields that had doubled quotes
};

}  // namespace coupling
