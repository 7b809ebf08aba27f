#include "coupling/results/report/html_table.hpp"

#include <algorithm>

namespace coupling::report {

HtmlTable::HtmlTable(std::string_view caption, const std::vector<std::string>& head)
    : caption_{caption}, head_{head} {}

bool HtmlTable::is_text(std::size_t column) const {
    return std::find(text_columns_.begin(), text_columns_.end(), column) != text_columns_.end();
}

std::vector<PageFields> HtmlTable::fields_of(const std::vector<std::string>& cells) const {
    std::vector<PageFields> fields;
    for (std::size_t column = 0; column < cells.size(); ++column) {
        fields.push_back({{"cell", cells[column]}, {"is_text", is_text(column)}});
    }
    return fields;
}

void HtmlTable::row(const std::vector<std::string>& cells, std::string_view style) {
    rows_.push_back({{"is_group", false},
                     {"has_style", !style.empty()},
                     {"style", std::string{style}},
                     {"cells", fields_of(cells)}});
}

void HtmlTable::group(std::string_view name) {
    rows_.push_back({{"is_group", true}, {"group", std::string{name}}});
}

std::string HtmlTable::html() const {
    return filled_template("html_table.html", {{"has_caption", !caption_.empty()},
                                               {"caption", caption_},
                                               {"columns", std::to_string(head_.size())},
                                               {"head", fields_of(head_)},
                                               {"rows", rows_}});
}

}  // namespace coupling::report
