#include "coupling/inputs/tables/prepare.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <set>
#include <utility>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "config/text/reading.hpp"
#include "coupling/inputs/climate/delivered.hpp"
#include "coupling/inputs/formats/column_names.hpp"
#include "coupling/inputs/tables/meant_columns.hpp"
#include "coupling/inputs/tables/words.hpp"

namespace coupling::tables {
namespace {

using config::joined;

/// Several climates have their names behind the role.
bool is_of_climate(const std::string& role) {
    return role == "climate" || role.starts_with("climate ");
}

bool is_of_places(const std::string& role) {
    return role == "trees" || role == "logs" || role == "observed_stops";
}

/// Names and ids are texts of the user, whatever they are; conditions of a target profile may be a dash.
void take_missing_values(config::Table& table, const std::string& role, Findings& findings) {
    const auto keep = [&](const std::string& column) {
        return names_things(column) ||
               (role == "target_profile" && (column == "minimal" || column == "ideal"));
    };
    const std::map<std::string, std::size_t> counts = table.take_missing_values(keep);
    std::size_t all = 0;
    std::string spellings;
    for (const auto& [spelling, count] : counts) {
        all += count;
        spellings += joined(spellings.empty() ? "" : ", ", config::in_quotes(spelling));
    }
    if (all > 0) {
        findings.notes.push_back(
            joined(table.file(), ": ", counted(all, "field"), " with ", spellings, " read as empty"));
    }
}

void take_units(config::Table& table, const std::string& role, Findings& findings) {
    for (const formats::UnitChange& change : formats::take_other_units(table, role)) {
        findings.notes.push_back(joined(table.file(), ": numbers in other units: ", change.column, " = ",
                                        config::in_quotes(change.found), change.sum));
    }
}

/// Returns the columns that it read.
std::vector<std::string> take_places(config::Table& table, const std::string& role, bool has_own_shapes,
                                     Findings& findings) {
    if (role == "trees" || role == "logs") {
        const bool had_places = table.find("x_m") || table.find("x1_m");
        const std::size_t moved = formats::take_coordinates(table, role, has_own_shapes);
        if (moved > 0) {
            findings.warnings.push_back(
                {config::ExitCode::data,
                 {table.file()},
                 joined(counted(moved, "row"), " whose attributes name another place than the shape"),
                 "one place for each: the shape counts",
                 "delete the columns of coordinates if they are old"});
        }
        return had_places && !has_own_shapes ? std::vector<std::string>{} : std::vector<std::string>{"wkt"};
    }
    if (!is_of_shapes(role) || table.find("wkt") || !table.find("x_m") || !table.find("y_m")) {
        return {};
    }
    config::Problems problems;
    std::vector<std::string> points;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const bool is_empty = table.text(row, "x_m").empty() && table.text(row, "y_m").empty();
        if (!is_empty) {
            table.number(row, "x_m", {}, problems);
            table.number(row, "y_m", {}, problems);
        }
        points.push_back(
            is_empty ? "" : joined("POINT (", table.text(row, "x_m"), " ", table.text(row, "y_m"), ")"));
    }
    problems.throw_if_any();
    table.add_column("wkt", std::move(points), "x_m");
    return {"x_m", "y_m"};
}

/// "12", or the first of several numbers and how many more.
std::string some_numbers(const std::vector<std::string>& numbers) {
    constexpr std::size_t most = 5;
    std::string text;
    for (std::size_t i = 0; i < std::min(most, numbers.size()); ++i) {
        text += joined(i == 0 ? "" : ", ", numbers[i]);
    }
    return numbers.size() > most ? joined(text, ", ... (", std::to_string(numbers.size()), " in all)") : text;
}

/// The number by which messages call a row: that of a feature, or the line of a text.
std::string number_of(const config::Table& table, std::size_t row, std::string_view column) {
    return std::to_string(table.place(row, column).line);
}

bool is_empty_shape(std::string_view wkt) {
    return wkt.empty() || config::in_lower_case(config::trimmed(wkt)).ends_with("empty");
}

void leave_out_rows_without_shape(config::Table& table, const std::string& role, bool has_own_shapes,
                                  Findings& findings) {
    const bool by_places = is_of_places(role) && has_own_shapes;
    if (!table.find("wkt") || (!is_of_shapes(role) && !by_places)) {
        return;
    }
    const auto has_no_place = [&](std::size_t row) {
        for (const char* column : {"x_m", "x1_m"}) {
            if (by_places && table.find(column) && !table.text(row, column).empty()) {
                return false;
            }
        }
        return is_empty_shape(table.text(row, "wkt"));
    };
    std::vector<std::string> numbers;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        if (has_no_place(row)) {
            numbers.push_back(number_of(table, row, "wkt"));
        }
    }
    if (numbers.empty() || numbers.size() == table.rows()) {
        return;  // a layer without any shape is refused as such
    }
    table.remove_rows(has_no_place);
    const bool one = numbers.size() == 1;
    const std::string what = has_own_shapes ? (one ? "feature " : "features ") : (one ? "line " : "lines ");
    findings.warnings.push_back({config::ExitCode::data,
                                 {table.file()},
                                 joined(what, some_numbers(numbers), " without a shape: left out"),
                                 "a shape in each row",
                                 "draw the shape, or delete the row"});
}

/// A column in which a GIS numbers the features of a file: nothing that a user wrote, and another file has
/// the same numbers.
bool counts_features(const std::string& column) {
    constexpr std::array counters{"fid", "ogc_fid", "objectid", "gid"};
    return std::find(counters.begin(), counters.end(), config::in_lower_case(column)) != counters.end();
}

/// Ids that are missing become the numbers of the features, or of the rows of a text. Where `id_opening`
/// tells several files apart, numbers of features that stand in a column begin with it, too.
void number_what_has_no_id(config::Table& table, const std::string& role, bool has_own_shapes,
                           const std::string& id_opening, Findings& findings) {
    const std::string id = role == "targets" ? "target_id" : role == "nets" || role == "works" ? "name" : "";
    if (id.empty() || !table.find("wkt")) {
        return;
    }
    const bool has_column = table.find(id).has_value();
    const bool is_counter = has_column && counts_features(table.found_columns()[*table.find(id)]);
    if (!has_own_shapes && (!has_column || id == "name")) {
        return;  // a text has no numbers of features: its reader asks for the column, and for names of nets
    }
    std::set<std::string> taken;
    for (std::size_t row = 0; has_column && row < table.rows(); ++row) {
        taken.insert(table.text(row, id));
    }
    std::vector<std::string> ids;
    std::size_t filled = 0;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        std::string own = has_column ? table.text(row, id) : "";
        if (own.empty()) {
            const std::string number =
                joined(id_opening, has_own_shapes ? number_of(table, row, "wkt") : std::to_string(row + 1));
            own = taken.contains(number) ? joined("feature_", number) : number;
            ++filled;
        } else if (is_counter) {
            own = joined(id_opening, own);
        }
        ids.push_back(std::move(own));
    }
    if (!has_column) {
        table.add_column(id, std::move(ids), "wkt");
        findings.notes.push_back(
            joined(table.file(), ": no column for ", id, ": numbers of the features are taken"));
        return;
    }
    if (filled > 0 || is_counter) {
        for (std::size_t row = 0; row < table.rows(); ++row) {
            table.set_text(row, id, ids[row]);
        }
    }
    if (filled > 0) {
        findings.notes.push_back(joined(table.file(), ": ", counted(filled, "row"), " without ", id,
                                        filled == 1 ? ": the number of the feature is taken"
                                                    : ": the numbers of the features are taken"));
    }
}

}  // namespace

bool is_of_shapes(const std::string& role) {
    constexpr std::array roles{
        "targets",          "nets", "works",           "stands",       "source_shapes",  "tree_area",
        "surface_polygons", "mesh", "collapse_source", "regime lines", "regime polygons"};
    return std::find(roles.begin(), roles.end(), role) != roles.end();
}

Findings prepare(config::Table& table, const std::string& role, bool has_own_shapes,
                 const std::string& id_opening) {
    Findings findings;
    if (const std::size_t above = table.lines_above().size(); above > 0) {
        findings.notes.push_back(
            joined(table.file(), ": lines above the header, passed over: ", std::to_string(above)));
    }
    if (table.lacks_first_name()) {
        findings.notes.push_back(
            joined(table.file(), ": the first column has no name and is left out (row names of R?)"));
    }
    if (!is_of_climate(role)) {  // whose units are told by more than headers
        take_units(table, role, findings);
    }
    findings.errors = formats::name_columns(table, role);
    take_missing_values(table, role, findings);
    if (is_of_climate(role)) {
        findings.errors.clear();  // other units are converted, and refused where they cannot be
        climate::Delivered delivered = climate::take_delivered(table);
        std::move(delivered.notes.begin(), delivered.notes.end(), std::back_inserter(findings.notes));
        std::move(delivered.warnings.begin(), delivered.warnings.end(),
                  std::back_inserter(findings.warnings));
    }
    std::vector<std::string> read_here = take_places(table, role, has_own_shapes, findings);
    leave_out_rows_without_shape(table, role, has_own_shapes, findings);
    number_what_has_no_id(table, role, has_own_shapes, id_opening, findings);
    for (config::Problem& warning : formula_warnings(table)) {
        findings.warnings.push_back(std::move(warning));
    }
    table.forget_use();
    if (has_own_shapes) {
        read_here.emplace_back("wkt");  // shapes are no column that the user named
    }
    if (table.rows() == 0) {
        read_here = table.columns();  // there is nothing that could be lost
    }
    for (const std::string& column : read_here) {
        if (const auto place = table.find(column)) {
            table.count_as_named(table.found_columns()[*place]);
        }
    }
    return findings;
}

Findings findings_of_use(const config::ColumnUse& use) {
    constexpr std::size_t most = 40;  // a line that people still read [choice]
    Findings findings;
    std::vector<const config::ColumnUse::Column*> renamed;
    std::string unread;
    std::size_t count = 0;
    for (const config::ColumnUse::Column& column : use.columns) {
        if (column.is_made || counts_features(column.found) ||
            column.name.ends_with(formats::superseded_by_shape)) {
            continue;
        }
        const config::ColumnForm form = config::form_of(column.found);
        const bool is_repeated = std::any_of(use.columns.begin(), use.columns.end(), [&](const auto& other) {
            return other.found == joined(column.found, " (2)");
        });
        if (column.is_read && is_repeated) {
            findings.errors.push_back({config::ExitCode::data,
                                       {use.file},
                                       joined("column ", config::in_quotes(column.found), " a second time"),
                                       "each column once"});
        }
        if (!column.is_read) {
            unread += ++count > most ? "" : joined(count == 1 ? "" : ", ", config::in_quotes(column.found));
            const auto wanted = std::find_if(
                use.missing.begin(), use.missing.end(),
                [&](const std::string& name) { return config::is_other_unit(form, config::form_of(name)); });
            if (wanted != use.missing.end()) {
                findings.errors.push_back(config::other_unit_problem(use.file, column.found, *wanted));
            }
        } else if (!config::is_same_column(form, config::form_of(column.name))) {
            renamed.push_back(&column);
        }
    }
    if (renamed.size() == 1) {
        findings.notes.push_back(joined(use.file, ": column ", config::in_quotes(renamed[0]->found),
                                        " is taken as ", renamed[0]->name));
    } else if (!renamed.empty()) {
        std::string names;
        for (const config::ColumnUse::Column* column : renamed) {
            names += joined(names.empty() ? "" : ", ", config::in_quotes(column->found), " = ", column->name);
        }
        findings.notes.push_back(joined(use.file, ": columns that are read under another name: ", names));
    }
    if (count > 0) {
        findings.notes.push_back(
            joined(use.file, ": columns that are not read: ", unread,
                   count > most ? joined(" and ", std::to_string(count - most), " more") : ""));
    }
    return findings;
}

void add_remarks(const Findings& findings, std::vector<std::string>& remarks) {
    config::Problems problems;
    for (const config::Problem& error : findings.errors) {
        problems.add(error);
    }
    problems.throw_if_any();
    remarks.insert(remarks.end(), findings.notes.begin(), findings.notes.end());
    for (const config::Problem& warning : findings.warnings) {
        remarks.push_back(joined("warning: ", config::to_string(warning)));
    }
}

}  // namespace coupling::tables
