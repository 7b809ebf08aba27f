#include "coupling/inputs/tables/needed_columns.hpp"

#include <algorithm>

#include "config/table/column_form.hpp"
#include "config/text/joined.hpp"
#include "coupling/inputs/formats/column_names.hpp"

namespace coupling {
namespace {

using config::joined;

constexpr std::size_t most_proposed = 3;  // a question that can still be answered [choice]

/// "'a'", "'a' or 'b'", "'a', 'b' or 'c'".
std::string alternatives(const std::vector<std::string>& columns) {
    std::string text;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        text += joined(i == 0 ? "" : i + 1 == columns.size() ? " or " : ", ", config::in_quotes(columns[i]));
    }
    return text;
}

}  // namespace

bool require_columns(const config::Table& table, std::string_view role,
                     const std::vector<std::string>& wanted, config::Problems& problems,
                     const std::map<std::string, std::string>& instead) {
    config::Problems plain;  // one for each that is missing, in their order
    if (table.require(wanted, plain)) {
        return true;
    }
    const std::vector<std::string> others = table.columns_beside(wanted);
    auto problem = plain.list().begin();
    for (const std::string& name : wanted) {
        if (table.has(name)) {
            continue;
        }
        config::Problem without_proposal = *problem++;
        const auto other_way = instead.find(name);
        const std::string or_else = other_way == instead.end() ? "" : joined(", or ", other_way->second);
        const config::ColumnForm form = config::form_of(name);
        const bool is_in_other_unit = std::any_of(
            others.begin(), others.end(),
            [&](const std::string& column) { return config::is_other_unit(config::form_of(column), form); });
        const std::vector<std::string> by_part = formats::columns_by_part(table, role, name);
        std::vector<std::string> proposed = by_part;
        const std::string nearest = config::nearest_word(name, others);
        if (!nearest.empty() && std::find(by_part.begin(), by_part.end(), nearest) == by_part.end()) {
            proposed.insert(proposed.begin(), nearest);
        }
        proposed.resize(std::min(proposed.size(), most_proposed));
        if (is_in_other_unit || proposed.empty()) {
            without_proposal.advice += or_else;
            problems.add(std::move(without_proposal));
        } else {
            problems.add(config::ExitCode::data, {table.file()},
                         joined("no column ", config::in_quotes(name), " (is ", alternatives(proposed),
                                " meant to be it?)"),
                         "", by_part.empty() ? "" : joined("rename it to ", name, or_else));
        }
    }
    return false;
}

void require_columns(const config::Table& table, const config::TableSchema& schema,
                     config::Problems& problems) {
    std::vector<std::string> needed;
    std::map<std::string, std::string> instead;
    for (const config::ColumnRules& column : schema.columns()) {
        if (column.is_needed()) {
            needed.push_back(column.name);
        }
        if (!column.rules.instead.empty()) {
            instead.emplace(column.name, column.rules.instead);
        }
    }
    require_columns(table, schema.rules().role, needed, problems, instead);
}

}  // namespace coupling
