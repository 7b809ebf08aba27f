#include "validation/engine/forest_cases/shared/unknown_columns.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "config/text/joined.hpp"

namespace coupling::validation::forest_cases {
namespace {

using config::joined;

constexpr std::array<std::string_view, 4> of_the_user{"note", "remark", "comment", "source"};

template <class List>
bool holds(const List& list, std::string_view name) {
    return std::find(list.begin(), list.end(), name) != list.end();
}

/// The nearest by spelling, or the only one that begins with the word, as `h` for `height_m`.
std::string meant_by(const std::string& column, const std::vector<std::string>& candidates) {
    std::string nearest = config::nearest_word(column, candidates);
    if (!nearest.empty()) {
        return nearest;
    }
    const auto begins = [&](const std::string& name) { return name.starts_with(column); };
    const auto found = std::find_if(candidates.begin(), candidates.end(), begins);
    return std::count_if(candidates.begin(), candidates.end(), begins) == 1 ? *found : "";
}

}  // namespace

void warn_of_unknown_columns(const config::Table& table, const std::vector<std::string>& known,
                             config::Warnings& warnings) {
    std::vector<std::string> absent;
    std::copy_if(known.begin(), known.end(), std::back_inserter(absent),
                 [&](const std::string& name) { return !table.has(name); });
    for (const std::string& column : table.columns()) {
        if (holds(known, column) || holds(of_the_user, column)) {
            continue;
        }
        const std::string meant = meant_by(column, absent);
        warnings.add(joined(table.file(), ": column ", config::in_quotes(column), " is not read; ",
                            meant.empty() ? std::string{"rename it if it is one of those in "
                                                        "validation/README.md, or leave it out"}
                                          : joined("if it is ", config::in_quotes(meant),
                                                   ", give it that name, or leave it out")));
    }
}

}  // namespace coupling::validation::forest_cases
