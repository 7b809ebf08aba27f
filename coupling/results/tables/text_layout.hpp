#pragma once

#include <cstddef>
#include <ostream>
#include <set>
#include <string>
#include <vector>

namespace coupling {

/// Width of the screen that tables are laid out for.
inline constexpr std::size_t screen_columns = 110;

/// Characters of a UTF-8 text.
std::size_t width_of(const std::string& text);

/// Words in lines of at most a width; a word that is wider has a line of its own.
std::vector<std::string> wrapped(const std::string& text, std::size_t width);

/// A paragraph in lines of the screen's width, each after the indent.
void print_wrapped(std::ostream& out, const std::string& indent, const std::string& text);

/// Rows whose fields stand below each other, two blanks before each: those of `left` columns begin together,
/// the others end together.
class AlignedTable {
public:
    explicit AlignedTable(std::set<std::size_t> left) : left_{std::move(left)} {}
    void add(std::vector<std::string> row);
    void print(std::ostream& out) const;

private:
    std::set<std::size_t> left_;
    std::vector<std::vector<std::string>> rows_;
    std::vector<std::size_t> widths_;
};

}  // namespace coupling
