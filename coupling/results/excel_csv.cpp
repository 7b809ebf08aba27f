#include "coupling/results/excel_csv.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "config/errors/input_error.hpp"
#include "coupling/inputs/own_files/own_rows.hpp"
#include "coupling/results/disk/out_file.hpp"
#include "coupling/results/geopackage/column_types.hpp"
#include "coupling/results/geopackage/plain_number.hpp"

namespace coupling {
namespace {

namespace fs = std::filesystem;

constexpr const char* byte_order_mark = "\xEF\xBB\xBF";

/// With quotes where the form needs them.
std::string excel_field(std::string_view field) {
    if (field.find_first_of(";\"\n\r") == std::string_view::npos) {
        return std::string{field};
    }
    std::string text{"\""};
    for (const char c : field) {
        text += c;
        if (c == '"') {
            text += c;
        }
    }
    return text += '"';
}

}  // namespace

void write_excel_csv(std::ostream& out, OwnRows& rows, char decimal_sign) {
    std::vector<bool> is_key;
    out << byte_order_mark;
    for (const std::string& column : rows.columns()) {
        out << (is_key.empty() ? "" : ";") << excel_field(column);
        is_key.push_back(geopackage::is_key(column));
    }
    out << '\n';
    while (rows.next()) {
        const std::vector<std::string_view>& fields = rows.fields();
        for (std::size_t i = 0; i < fields.size(); ++i) {
            std::string text = excel_field(fields[i]);
            if (decimal_sign != '.' && !is_key[i] && geopackage::plain_number(fields[i])) {
                std::replace(text.begin(), text.end(), '.', decimal_sign);
            }
            out << (i == 0 ? "" : ";") << text;
        }
        out << '\n';
    }
}

void turn_into_excel_csv(const fs::path& folder, char decimal_sign) {
    std::error_code error;
    std::vector<fs::path> files;
    for (fs::directory_iterator entry{folder, error}, end; !error && entry != end; entry.increment(error)) {
        if (entry->path().extension() == ".csv") {
            files.push_back(entry->path());
        }
    }
    std::sort(files.begin(), files.end());
    for (const fs::path& file : files) {
        OwnRows rows{file};
        const fs::path fresh = fs::path{file}.replace_extension(".excel");
        OutFile out{fresh};
        write_excel_csv(out.stream(), rows, decimal_sign);
        out.close();
        fs::rename(fresh, file, error);
        if (error) {
            config::fail(config::ExitCode::file, {.file = file.string()},
                         "cannot be replaced: " + error.message());
        }
    }
}

}  // namespace coupling
