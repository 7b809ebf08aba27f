#include "coupling/results/tables/text_layout.hpp"

#include <algorithm>
#include <sstream>

#include "config/text/joined.hpp"

namespace coupling {

using config::joined;

std::size_t width_of(const std::string& text) {
    return static_cast<std::size_t>(std::count_if(
        text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

std::vector<std::string> wrapped(const std::string& text, std::size_t width) {
    std::istringstream words{text};
    std::vector<std::string> lines;
    for (std::string word; words >> word;) {
        if (!lines.empty() && width_of(lines.back()) + 1 + width_of(word) <= width) {
            lines.back() += joined(" ", word);
        } else {
            lines.push_back(word);
        }
    }
    return lines;
}

void print_wrapped(std::ostream& out, const std::string& indent, const std::string& text) {
    for (const std::string& line : wrapped(text, screen_columns - indent.size())) {
        out << indent << line << '\n';
    }
}

void AlignedTable::add(std::vector<std::string> row) {
    widths_.resize(std::max(widths_.size(), row.size()));
    for (std::size_t i = 0; i < row.size(); ++i) {
        widths_[i] = std::max(widths_[i], width_of(row[i]));
    }
    rows_.push_back(std::move(row));
}

void AlignedTable::print(std::ostream& out) const {
    for (const std::vector<std::string>& row : rows_) {
        std::string line;
        for (std::size_t i = 0; i < row.size(); ++i) {
            const std::string blanks(widths_[i] - width_of(row[i]), ' ');
            line += left_.contains(i) ? joined("  ", row[i], blanks) : joined("  ", blanks, row[i]);
        }
        line.erase(line.find_last_not_of(' ') + 1);
        out << line << '\n';
    }
}

}  // namespace coupling
