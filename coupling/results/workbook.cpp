#include "coupling/results/workbook.hpp"

#include <fcntl.h>
#include <unistd.h>
#include <xlsxwriter.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "config/errors/input_error.hpp"
#include "config/text/joined.hpp"
#include "coupling/inputs/own_files/own_rows.hpp"
#include "coupling/inputs/own_files/system_calls.hpp"
#include "coupling/results/disk/out_file.hpp"
#include "coupling/results/geopackage/column_types.hpp"
#include "coupling/results/geopackage/plain_number.hpp"

namespace coupling {
namespace {

using config::joined;

namespace fs = std::filesystem;

constexpr std::size_t longest_sheet_name = 31;
constexpr std::size_t longest_cell = 32'767;  // characters that a cell takes; bytes are no fewer
/// 1 January 2000, noon UTC: a date of the day would change the bytes.
constexpr std::time_t fixed_date = 946'728'000;

/// The library prints some errors itself, beside the message of this program: not while this object lives.
class NoLinesOfTheLibrary {
public:
    NoLinesOfTheLibrary() : kept_{::dup(STDERR_FILENO)} {
        const int nowhere = repeated([] { return ::open("/dev/null", O_WRONLY | O_CLOEXEC); });
        if (kept_ >= 0 && nowhere >= 0) {
            std::fflush(stderr);
            ::dup2(nowhere, STDERR_FILENO);
        }
        ::close(nowhere);
    }
    ~NoLinesOfTheLibrary() {
        if (kept_ >= 0) {
            std::fflush(stderr);
            ::dup2(kept_, STDERR_FILENO);
            ::close(kept_);
        }
    }
    NoLinesOfTheLibrary(const NoLinesOfTheLibrary&) = delete;
    NoLinesOfTheLibrary& operator=(const NoLinesOfTheLibrary&) = delete;

private:
    int kept_;
};

/// A workbook of the library, closed once. Its temporary files lie in a folder of their own: one that the
/// library cannot delete must not come to the results.
class Workbook {
public:
    explicit Workbook(const fs::path& file)
        : file_{file.string()}, scratch_{(file.parent_path() / ".workbook").string()} {
        make_folder(scratch_);
        lxw_workbook_options options{};
        options.constant_memory = LXW_TRUE;  // row by row: tables may have a million
        options.tmpdir = scratch_.data();
        book_ = workbook_new_opt(file_.c_str(), &options);
        if (book_ == nullptr) {
            fail("cannot be written");
        }
        lxw_doc_properties properties{};
        properties.created = fixed_date;
        workbook_set_properties(book_, &properties);
        bold_ = workbook_add_format(book_);
        format_set_bold(bold_);
    }
    ~Workbook() {
        if (book_ != nullptr) {
            const NoLinesOfTheLibrary quiet;
            workbook_close(book_);
        }
    }
    Workbook(const Workbook&) = delete;
    Workbook& operator=(const Workbook&) = delete;

    lxw_worksheet* sheet(const std::string& name) {
        const NoLinesOfTheLibrary quiet;
        lxw_worksheet* added = workbook_add_worksheet(book_, name.c_str());
        if (added == nullptr) {
            fail("cannot be written: no sheet can be added");
        }
        return added;
    }
    [[nodiscard]] lxw_format* bold() const { return bold_; }
    void close() {
        const lxw_error error = close_quietly();
        if (error != LXW_NO_ERROR) {
            fail(joined("cannot be written: ", lxw_strerror(error)));
        }
        delete_entry(scratch_);
    }

private:
    lxw_error close_quietly() {
        const NoLinesOfTheLibrary quiet;
        return workbook_close(std::exchange(book_, nullptr));
    }
    [[noreturn]] void fail(const std::string& what) const {
        config::fail(config::ExitCode::file, {.file = file_}, what,
                     "a folder with room for a workbook; or output.xlsx = no");
    }
    std::string file_;
    std::string scratch_;
    lxw_workbook* book_ = nullptr;
    lxw_format* bold_ = nullptr;
};

/// A name that is no other's, as far as Excel distinguishes them.
std::string sheet_name(const fs::path& table, std::set<std::string>& taken) {
    std::string name = table.stem().string().substr(0, longest_sheet_name);
    for (int number = 2; !taken.insert(name).second; ++number) {
        const std::string end = joined("~", std::to_string(number));
        name = joined(table.stem().string().substr(0, longest_sheet_name - end.size()), end);
    }
    return name;
}

void write_text(lxw_worksheet* sheet, std::size_t row, std::size_t column, std::string_view text,
                lxw_format* format) {
    const std::string cell =
        text.size() > longest_cell ? "(longer than a cell takes; see the table)" : std::string{text};
    worksheet_write_string(sheet, static_cast<lxw_row_t>(row), static_cast<lxw_col_t>(column), cell.c_str(),
                           format);
}

void write_header(lxw_worksheet* sheet, const std::vector<std::string>& columns, lxw_format* bold) {
    constexpr double least_width = 9.0;
    constexpr double most_width = 32.0;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const double width =
            std::clamp(static_cast<double>(columns[i].size()) + 2.0, least_width, most_width);
        const auto column = static_cast<lxw_col_t>(i);
        worksheet_set_column(sheet, column, column, width, nullptr);
        write_text(sheet, 0, i, columns[i], bold);
    }
    worksheet_freeze_panes(sheet, 1, 0);
}

/// A table that is read twice: to count its rows, then for what stands in them.
struct Table {
    std::string sheet;
    const WrittenFile& file;
    fs::path place;
    std::vector<geopackage::Column> columns;
    std::uint64_t rows = 0;
};

void look_at(Table& table, const std::vector<TableLayout>& layouts) {
    OwnRows rows{table.place, table.file.end};
    table.columns = geopackage::declared_columns(rows.columns(), layouts, table.file.path);
    while (rows.next()) {
        ++table.rows;
    }
}

void write_rows(lxw_worksheet* sheet, const Table& table, lxw_format* bold) {
    OwnRows rows{table.place, table.file.end};
    write_header(sheet, rows.columns(), bold);
    for (std::size_t row = 1; rows.next(); ++row) {
        for (std::size_t i = 0; i < rows.fields().size(); ++i) {
            const std::string_view field = rows.fields()[i];
            if (field.empty()) {
                continue;
            }
            const auto number = table.columns[i].type == geopackage::ColumnType::text
                                    ? std::nullopt
                                    : geopackage::plain_number(field);
            if (number) {
                worksheet_write_number(sheet, static_cast<lxw_row_t>(row), static_cast<lxw_col_t>(i), *number,
                                       nullptr);
            } else {
                write_text(sheet, row, i, field, nullptr);
            }
        }
    }
}

}  // namespace

void write_workbook(const fs::path& file, std::span<const std::pair<WrittenFile, fs::path>> tables,
                    const std::vector<TableLayout>& layouts, const WriteWatch& watch, std::size_t most_rows) {
    std::set<std::string> taken{"contents"};
    std::vector<Table> found;
    for (const auto& [written, place] : tables) {
        found.push_back({sheet_name(written.path, taken), written, place, {}, 0});
        look_at(found.back(), layouts);
    }
    Workbook book{file};
    lxw_worksheet* const contents = book.sheet("contents");
    write_header(contents, {"sheet", "rows", "holds"}, book.bold());
    worksheet_set_column(contents, 0, 0, 32.0, nullptr);
    worksheet_set_column(contents, 2, 2, 100.0, nullptr);
    std::size_t line = 0;
    for (const Table& table : found) {
        const bool fits = table.rows + 1 <= most_rows;
        ++line;
        write_text(contents, line, 0, table.sheet, nullptr);
        worksheet_write_number(contents, static_cast<lxw_row_t>(line), 1, static_cast<double>(table.rows),
                               nullptr);
        write_text(contents, line, 2,
                   fits ? table.file.sentence
                        : joined("not in this workbook: more rows than a sheet takes; see ", table.file.path),
                   nullptr);
    }
    for (const Table& table : found) {
        if (table.rows + 1 <= most_rows) {
            watch(joined("results.xlsx, ", table.sheet));
            write_rows(book.sheet(table.sheet), table, book.bold());
        }
    }
    book.close();
}

}  // namespace coupling
