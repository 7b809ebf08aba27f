#include "coupling/inputs/parameters/parameter_widths.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

#include "config/data/shipped_tables.hpp"
#include "config/text/joined.hpp"
#include "coupling/inputs/reading/declared_tables.hpp"

namespace coupling {

struct ParameterWidthRow {
    std::string parameter;
    double width = 0.0;
    std::string goes_with;
    std::optional<double> correlation;
};

const config::Schema<ParameterWidthRow>& parameter_width_columns() {
    using R = ParameterWidthRow;
    // clang-format off
    static const config::Schema<R> columns{
        {.role = "parameters", .setting = "run.parameters", .row = "parameter"},
        {{"parameter", &R::parameter, "of `bannwald info parameter_widths`; losses_on.NAME for one ground type or code", {.unique = true, .advice = "delete one of the rows"}},
         {"width", &R::width, "standard deviation of ln(factor); 0: taken as known", {.range = {0.0, 2.0}}},
         {"goes_with", &R::goes_with, "another parameter; empty: independent", {.optional = true}},
         {"correlation", &R::correlation, "with that one, of the logarithms", {.range = {-0.99, 0.99}, .optional = true}},
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

/// With what others may go: what is drawn of every fall, with and without a forest.
constexpr std::array<std::string_view, 6> partners{"losses",     "friction", "stopping",
                                                   "jump_angle", "sideways", "block_size"};

/// A row of a file that names another parameter.
struct Link {
    std::size_t row;
    std::string parameter;
    std::string goes_with;
};

/// What others go with has no correlation of its own: then any values of the correlations are possible.
void refuse_chain(const Link& link, const std::vector<ParameterWidth>& widths, config::RowProblems& wrong) {
    constexpr const char* expected = "a parameter that goes with none";
    if (link.goes_with == link.parameter || !find_width(widths, link.goes_with)->goes_with.empty()) {
        wrong.refuse(link.row, "goes_with",
                     config::joined(config::in_quotes(link.goes_with), ", which goes with another one"),
                     expected, "name that one in both rows");
        return;
    }
    const auto other = std::find_if(widths.begin(), widths.end(), [&](const ParameterWidth& one) {
        return one.goes_with == link.parameter;
    });
    if (other != widths.end()) {
        wrong.refuse(link.row, "goes_with",
                     config::joined(config::in_quotes(link.parameter), " goes with ",
                                    config::in_quotes(link.goes_with), ", and ",
                                    config::in_quotes(other->parameter), " with it"),
                     expected, config::joined("give ", other->parameter, " a row without goes_with"));
    }
}

}  // namespace

std::vector<ParameterWidth> shipped_parameter_widths() {
    const config::Table table = config::read_shipped_table("parameter_widths.csv");
    config::RowProblems wrong{table};
    std::vector<ParameterWidth> widths;
    for (const auto& row : parameter_width_columns().rows(table, wrong)) {
        widths.push_back({row.parameter, row.width, table.text(row.row, "source"), row.goes_with,
                          row.correlation.value_or(0.0)});
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
    std::vector<Link> linked;
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
        if (row.goes_with.empty() == row.correlation.has_value()) {
            const bool is_alone = row.goes_with.empty();
            wrong.refuse(row.row, is_alone ? "goes_with" : "correlation",
                         is_alone ? "a correlation with nothing" : "goes_with without a correlation",
                         "both goes_with and correlation, or neither");
            continue;
        }
        if (!row.goes_with.empty() &&
            std::find(partners.begin(), partners.end(), row.goes_with) == partners.end()) {
            wrong.refuse(row.row, "goes_with", config::in_quotes(row.goes_with),
                         "losses, friction, stopping, jump_angle, sideways or block_size",
                         "what is drawn of every fall: other draws stay the same without a forest");
            continue;
        }
        set_width(widths,
                  {row.parameter, row.width, table.file(), row.goes_with, row.correlation.value_or(0.0)});
        if (!row.goes_with.empty()) {
            linked.push_back({row.row, row.parameter, row.goes_with});
        }
    }
    for (const Link& link : linked) {
        refuse_chain(link, widths, wrong);
    }
    wrong.throw_first();
}

double width_of(const std::vector<ParameterWidth>& widths, const std::string& parameter) {
    const ParameterWidth* found = find_width(widths, parameter);
    return found == nullptr ? 0.0 : found->width;
}

const ParameterWidth* find_width(const std::vector<ParameterWidth>& widths, const std::string& parameter) {
    const auto found = std::find_if(widths.begin(), widths.end(),
                                    [&](const ParameterWidth& one) { return one.parameter == parameter; });
    return found == widths.end() ? nullptr : &*found;
}

}  // namespace coupling
