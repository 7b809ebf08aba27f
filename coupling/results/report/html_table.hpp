#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "coupling/results/templates/page_template.hpp"

namespace coupling::report {

/// An HTML table in the making. All texts are HTML already.
class HtmlTable {
public:
    explicit HtmlTable(std::string_view caption, const std::vector<std::string>& head);

    /// `style` is a class of the row, empty for none.
    void row(const std::vector<std::string>& cells, std::string_view style = "");
    /// A heading over the rows that follow.
    void group(std::string_view name);
    /// Columns (counted from 0) that hold text and stand to the left; the first one always does.
    void text_columns(std::initializer_list<std::size_t> columns) { text_columns_ = columns; }
    [[nodiscard]] std::string html() const;

private:
    [[nodiscard]] bool is_text(std::size_t column) const;
    [[nodiscard]] std::vector<PageFields> fields_of(const std::vector<std::string>& cells) const;

    std::string caption_;
    std::vector<std::string> head_;
    std::vector<PageFields> rows_;
    std::vector<std::size_t> text_columns_;
};

}  // namespace coupling::report
