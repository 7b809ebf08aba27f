#include "coupling/inputs/parameters/parameter_widths.hpp"

#include <algorithm>

#include "config/data/shipped_tables.hpp"
#include "config/text/joined.hpp"
#include "coupling/inputs/reading/declared_tables.hpp"

namespace coupling {

struct ParameterWidthRow {
    std::string parameter;
    double width = 0.0;
};

const config::Schema<ParameterWidthRow>& parameter_width_columns() {
    using R = ParameterWidthRow;
    // clang-format off
    static const config::Schema<R> columns{
        {.role = "parameters", .setting = "run.parameters", .row = "parameter"},
        {{"parameter", &R::parameter, "of `bannwald info parameter_widths`; losses_on.NAME for one ground type or code", {.unique = true, .advice = "delete one of the rows"}},
         {"width", &R::width, "standard deviation of ln(factor); 0: taken as known", {.range = {0.0, 2.0}}},
         {"acts_on", "for readers of the table", {.optional = true}},
         {"source", "for readers of the table", {.optional = true}}}};
    // clang-format on
    return columns;
}

namespace {

constexpr std::string_view of_one_ground = "losses_on.";

/// Replaces the width of that name, or adds it.
void set_width(std::vector<ParameterWidth>& widths, const ParameterWidth& width) {
    const auto found = std::find_if(widths.begin(), widths.end(), [&](const ParameterWidth& one) {
        return one.parameter == width.parameter;
    });
    if (found == widths.end()) {
        widths.push_back(width);
    } else {
        *found = width;
    }
}

}  // namespace

std::vector<ParameterWidth> shipped_parameter_widths() {
    const config::Table table = config::read_shipped_table("parameter_widths.csv");
    config::RowProblems wrong{table};
    std::vector<ParameterWidth> widths;
    for (const auto& row : parameter_width_columns().rows(table, wrong)) {
        widths.push_back({row.parameter, row.width, table.text(row.row, "source")});
    }
    wrong.throw_first();
    return widths;
}

std::vector<std::string> parameter_names(const std::vector<ParameterWidth>& widths,
                                         const std::vector<std::string>& grounds) {
    std::vector<std::string> known;
    for (const ParameterWidth& width : widths) {
        known.push_back(width.parameter);
    }
    for (const std::string& ground : grounds) {
        known.push_back(config::joined(of_one_ground, ground));
    }
    return known;
}

void change_parameter_widths(std::vector<ParameterWidth>& widths, const config::Table& table,
                             const std::vector<std::string>& grounds, Reading& reading) {
    check_columns(table, parameter_width_columns(), reading);
    const std::vector<std::string> known = parameter_names(widths, grounds);
    config::RowProblems wrong{table};
    for (const auto& row : parameter_width_columns().rows(table, wrong)) {
        if (std::find(known.begin(), known.end(), row.parameter) == known.end()) {
            const std::string nearest = config::nearest_word(row.parameter, known);
            wrong.refuse(row.row, "parameter", config::in_quotes(row.parameter),
                         nearest.empty() ? "a parameter of `bannwald info parameter_widths`"
                                         : config::joined("a parameter of `bannwald info parameter_widths` (",
                                                          nearest, "?)"),
                         "write a known parameter, or delete the row");
            continue;
        }
        set_width(widths, {row.parameter, row.width, table.file()});
    }
    wrong.throw_first();
}

double width_of(const std::vector<ParameterWidth>& widths, const std::string& parameter) {
    const auto found = std::find_if(widths.begin(), widths.end(),
                                    [&](const ParameterWidth& one) { return one.parameter == parameter; });
    return found == widths.end() ? 0.0 : found->width;
}

}  // namespace coupling
