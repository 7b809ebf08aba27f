#pragma once

#include <random>
#include <set>
#include <string>
#include <vector>

#include "config/table/table.hpp"
#include "coupling/assessments/compare/runs/run_tables.hpp"
#include "tests/runs/program.hpp"

namespace coupling {

using Names = std::set<std::string>;

/// Names with all that separates fields, rows, comments and settings elsewhere.
class NameMaker {
public:
    explicit NameMaker(unsigned seed) : draws_{seed} {}

    std::string next() {
        static const std::vector<std::string> pieces{
            "a", "B", "7",  "\"", "\"\"", ",", ";", "\n",   " ",  "  ", "=",   "#", "'",   "\t",
            "ä", "é", "漢", "😀",  "<b>",  "&", "-", "unit", "%s", "\\", "1,5", "|", "[x]", "\r\n"};
        std::string name;
        do {
            name = std::string(std::uniform_int_distribution<std::size_t>{0, 1}(draws_), ' ');
            for (int i = std::uniform_int_distribution{1, 6}(draws_); i > 0; --i) {
                name += pieces[std::uniform_int_distribution<std::size_t>{0, pieces.size() - 1}(draws_)];
            }
            name += "x";  // a name of blanks alone is none
        } while (!used_.insert(name).second);
        return name;
    }

private:
    std::mt19937 draws_;
    Names used_;
};

inline std::string in_csv(const std::string& name) {
    std::string text = "\"";
    for (const char c : name) {
        text += c == '"' ? std::string{"\"\""} : std::string(1, c);
    }
    return text + '"';
}

/// What a column of a table of the results holds.
inline Names column_of(const SampleProject& project, const std::string& folder, const std::string& name,
                       const std::string& column) {
    const config::Table table = compare::read_table(project.file(folder), name, {column});
    Names names;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        names.insert(table.text(row, column));
    }
    return names;
}

}  // namespace coupling
