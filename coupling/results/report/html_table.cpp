#include "coupling/results/report/html_table.hpp"

#include <algorithm>

#include "config/text/joined.hpp"

namespace coupling::report {

using config::joined;

HtmlTable::HtmlTable(std::string_view caption, const std::vector<std::string>& head)
    : caption_{caption}, head_{head} {}

bool HtmlTable::is_text(std::size_t column) const {
    return std::find(text_columns_.begin(), text_columns_.end(), column) != text_columns_.end();
}

void HtmlTable::row(const std::vector<std::string>& cells, std::string_view style) {
    rows_ += style.empty() ? "<tr>" : std::string{"<tr class=\""}.append(style).append("\">");
    for (std::size_t column = 0; column < cells.size(); ++column) {
        rows_ += joined((is_text(column) ? "<td class=\"text\">" : "<td>"), cells[column], "</td>");
    }
    rows_ += "</tr>\n";
}

void HtmlTable::group(std::string_view name) {
    rows_ += joined("<tr class=\"group\"><th colspan=\"", std::to_string(head_.size()), "\">");
    rows_.append(name).append("</th></tr>\n");
}

std::string HtmlTable::html() const {
    std::string html = "<div class=\"wide\"><table>";
    if (!caption_.empty()) {
        html += joined("<caption>", caption_, "</caption>");
    }
    html += "\n<thead><tr>";
    for (std::size_t column = 0; column < head_.size(); ++column) {
        html += joined((is_text(column) ? "<th class=\"text\" scope=\"col\">" : "<th scope=\"col\">"),
                       head_[column], "</th>");
    }
    return joined(html, "</tr></thead>\n<tbody>\n", rows_, "</tbody></table></div>\n");
}

}  // namespace coupling::report
