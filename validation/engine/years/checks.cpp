#include "validation/engine/years/checks.hpp"

#include <algorithm>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "validation/engine/years/result_tables.hpp"

namespace coupling::validation::years {
namespace {

using config::joined;

/// ", lines 4, 7 and 3 more".
std::string lines_in_words(const std::vector<std::string>& lines) {
    constexpr std::size_t most_named = 5;
    std::string words = lines.size() == 1 ? ", line" : ", lines";
    for (std::size_t i = 0; i < std::min(lines.size(), most_named); ++i) {
        words += joined(i == 0 ? " " : ", ", lines[i]);
    }
    return lines.size() > most_named
               ? joined(words, " and ", std::to_string(lines.size() - most_named), " more")
               : words;
}

}  // namespace

void run_check(geopackage::Database& database, const Query& query, const CaseFiles& files,
               config::Warnings& warnings) {
    const std::vector<std::vector<std::string>> rows = rows_of(database, query);
    if (rows.empty()) {
        return;
    }
    const geopackage::Statement statement = prepared(database, query);
    Fields first;
    for (std::size_t i = 0; i < rows.front().size(); ++i) {
        first[statement.name(static_cast<int>(i))] = rows.front()[i];
    }
    std::vector<std::string> lines;
    for (const std::vector<std::string>& row : rows) {
        if (!row.front().empty()) {  // else the whole file
            lines.push_back(row.front());
        }
    }
    const std::string found = filled(query.title, first, query.place);
    if (query.use == QueryUse::error) {
        const auto line = lines.empty() ? std::nullopt : config::parse_whole(lines.front());
        config::fail(config::ExitCode::data,
                     {files.shown(query.rows), static_cast<std::size_t>(line.value_or(0)), 0}, found,
                     filled(query.label, first, query.place));
    }
    warnings.add(joined(files.shown(query.rows), lines.empty() ? "" : lines_in_words(lines), ": ", found));
}

}  // namespace coupling::validation::years
