#include "coupling/results/tables/table_layout.hpp"

#include <algorithm>
#include <stdexcept>

#include "config/text/joined.hpp"

namespace coupling {
namespace {

using config::joined;

constexpr std::string_view any_year = "YEAR";

bool is_file_of(const TableLayout& layout, std::string_view file) {
    const std::string_view pattern = layout.file;
    const std::size_t at = pattern.find(any_year);
    if (at == std::string_view::npos) {
        return file == pattern;
    }
    const std::string_view end = pattern.substr(at + any_year.size());
    if (file.size() <= at + end.size() || file.substr(0, at) != pattern.substr(0, at) ||
        !file.ends_with(end)) {
        return false;
    }
    const std::string_view year = file.substr(at, file.size() - at - end.size());
    return std::all_of(year.begin(), year.end(), [](char c) { return c >= '0' && c <= '9'; });
}

}  // namespace

const TableLayout* find_layout(const std::vector<TableLayout>& layouts, std::string_view file) {
    const auto found = std::find_if(layouts.begin(), layouts.end(),
                                    [&](const TableLayout& layout) { return is_file_of(layout, file); });
    return found == layouts.end() ? nullptr : &*found;
}

const TableLayout& layout_of(const std::vector<TableLayout>& layouts, std::string_view file) {
    const TableLayout* layout = find_layout(layouts, file);
    if (layout == nullptr) {
        throw std::logic_error{joined("the columns of ", file, " are not declared")};
    }
    return *layout;
}

void write_header(std::ostream& out, const TableLayout& layout) {
    const char* separator = "";
    for (const Column& column : layout.columns) {
        out << separator << column.name;
        separator = ",";
    }
    out << '\n';
}

}  // namespace coupling
