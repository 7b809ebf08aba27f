#include "coupling/inputs/places/exposure_checks.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <utility>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/plausible/overlapping_areas.hpp"
#include "coupling/inputs/reading/declared_tables.hpp"
#include "coupling/inputs/scenario/target_settings.hpp"

namespace coupling {
namespace {

using config::joined;

using Rows = std::vector<config::Read<TargetRow>>;

/// "HouseValue", "house_value", "house value": "house" and "value".
std::vector<std::string> words_of_column(const std::string& name) {
    std::vector<std::string> words(1);
    bool was_small = false;
    for (const char letter : name) {
        const auto byte = static_cast<unsigned char>(letter);
        if (std::isalpha(byte) == 0 || (was_small && std::isupper(byte) != 0)) {
            words.emplace_back();
        }
        if (std::isalpha(byte) != 0) {
            words.back() += static_cast<char>(std::tolower(byte));
        }
        was_small = std::islower(byte) != 0;
    }
    return words;
}

/// Equal but for one letter that is added, left out, another one, or exchanged with its neighbour.
bool is_nearly(const std::string& a, const std::string& b) {
    const std::string& less = a.size() <= b.size() ? a : b;
    const std::string& more = a.size() <= b.size() ? b : a;
    const auto [at, there] = std::mismatch(less.begin(), less.end(), more.begin());
    if (at == less.end()) {
        return more.size() - less.size() <= 1;
    }
    const std::string rest(at, less.end());
    const std::string other(there, more.end());
    if (more.size() == less.size() + 1) {
        return rest == other.substr(1);
    }
    const bool is_swap = rest.size() > 1 && other.size() > 1 && rest[0] == other[1] && rest[1] == other[0] &&
                         rest.substr(2) == other.substr(2);
    return more.size() == less.size() && (rest.substr(1) == other.substr(1) || is_swap);
}

}  // namespace

bool has_word_like(const std::string& column, const std::string& wanted) {
    const std::vector<std::string> words = words_of_column(column);
    return std::any_of(words.begin(), words.end(),
                       [&](const std::string& word) { return is_nearly(word, wanted); });
}

namespace {

/// Columns without which deaths or damage are not known, and the word for what each holds.
constexpr std::array<std::pair<const char*, const char*>, 6> deciding_columns{
    {{"house_value", "value"},
     {"persons", "persons"},
     {"hours_per_day", "hours"},
     {"vehicles_per_day", "vehicles"},
     {"speed_kmph", "speed"},
     {"persons_per_vehicle", "persons"}}};

/// Warns of a column that nobody reads and that is called like one that the file lacks: "value" beside
/// house_value. What is counted from it would only be missing.
void judge_alike_columns(const config::Table& table, Reading& reading) {
    // One called alike is enough, but for a file with houses, whose persons are not those of vehicles.
    const bool has_houses = table.has("house_value") || table.has("hours_per_day");
    const auto is_there = [&](const auto& wanted) {
        return std::any_of(deciding_columns.begin(), deciding_columns.end(), [&](const auto& deciding) {
            return table.has(deciding.first) &&
                   (deciding.first == wanted.first ||
                    (deciding.second == std::string_view{wanted.second} &&
                     !(has_houses && wanted.first == std::string_view{"persons"})));
        });
    };
    for (const config::ColumnUse::Column& column : table.use()->columns) {
        const auto wanted =
            std::find_if(deciding_columns.begin(), deciding_columns.end(), [&](const auto& deciding) {
                return !is_there(deciding) && has_word_like(column.found, deciding.second);
            });
        if (column.is_read || column.is_made || wanted == deciding_columns.end()) {
            continue;
        }
        reading.warn(
            {table.file()},
            joined("column ", config::in_quotes(column.found), ", which is not read, and no ", wanted->first),
            joined("a column ", wanted->first, ", if that is what it holds"),
            "rename it in the file, or the risk leaves out what it says", config::Effect::answer);
    }
}

/// Warns of houses worth so little that the figure looks like thousands: deaths stay, money is 1000 times too
/// small.
void judge_house_values(const config::Table& table, const std::vector<config::Read<TargetRow>>& rows,
                        Reading& reading) {
    // [choice] A barn may be worth less than 10 000 in a currency of the Alps; half of all houses are not,
    // and nothing that is counted as a house is worth less than 2 000.
    constexpr double most_of_thousands = 10'000.0;
    constexpr double least_value = 2'000.0;
    std::vector<const config::Read<TargetRow>*> cheap;
    std::size_t houses = 0;
    bool is_any_too_cheap = false;
    for (const config::Read<TargetRow>& row : rows) {
        if (row.house_value && *row.house_value > 0.0) {
            ++houses;
            is_any_too_cheap = is_any_too_cheap || *row.house_value < least_value;
            if (*row.house_value < most_of_thousands) {
                cheap.push_back(&row);
            }
        }
    }
    if (!is_any_too_cheap && 2 * cheap.size() < std::max<std::size_t>(houses, 1)) {
        return;
    }
    reading.warn(table.place(cheap.front()->row, "house_value"),
                 joined(counted(cheap.size(), "house"), " worth less than 10000, such as ",
                        config::in_quotes(cheap.front()->id), " with ",
                        config::to_text(*cheap.front()->house_value), ": house_value looks like thousands"),
                 "whole money in risk.currency", "multiply house_value by 1000 there if these are thousands",
                 config::Effect::answer);
}

/// "3 of 61 targets": the ones found, in words.
std::string some_of(std::size_t some, std::size_t all) {
    return joined(std::to_string(some), " of ", counted(all, "target"));
}

/// Warns of targets of which the file says nothing: a road without traffic has no risk, and its total is none
/// of the road.
void judge_silent_targets(const config::Table& table, const Rows& rows, Reading& reading) {
    const auto is_silent = [](const TargetRow& row) { return !row.is_road() && !row.is_house(); };
    const auto silent = static_cast<std::size_t>(std::count_if(rows.begin(), rows.end(), is_silent));
    // A list of which all are silent is refused where no other list says anything.
    const bool is_only_list = tables_in(reading.targets().file).size() == 1;
    if (silent == 0 || (silent == rows.size() && is_only_list)) {
        return;
    }
    // A line before areas: a road is what a risk is asked for.
    const auto is_silent_line = [&](const TargetRow& row) {
        return is_silent(row) && row.shape.kind == config::Shape::Kind::line;
    };
    const auto line = std::find_if(rows.begin(), rows.end(), is_silent_line);
    const auto first = line != rows.end() ? line : std::find_if(rows.begin(), rows.end(), is_silent);
    reading.warn(
        table.place(first->row, "wkt"),
        joined(some_of(silent, rows.size()), " without vehicles, persons or value, such as ",
               config::in_quotes(first->id), ": the risk leaves out what happens there"),
        "vehicles_per_day, speed_kmph and persons_per_vehicle of a road, persons or house_value of a "
        "house",
        "fill them in, or give such targets a file without risk.assess", config::Effect::answer);
}

/// Warns of a speed that is a usual one in metres per second: 13.9 for 50 km/h.
void judge_speeds(const config::Table& table, const Rows& rows, Reading& reading) {
    constexpr double kmph_per_mps = 3.6;
    constexpr double limits_apart_kmph = 10.0;  // [choice] speed limits go by tens
    constexpr double rounded_kmph = 0.4;        // of one decimal in m/s
    constexpr double whole_kmph = 0.05;
    constexpr double fastest_mps = 40.0;
    const auto off = [](double value, double of) { return std::abs(std::remainder(value, of)); };
    for (const config::Read<TargetRow>& row : rows) {
        if (!row.speed_kmph || *row.speed_kmph > fastest_mps || off(*row.speed_kmph, 1.0) < whole_kmph) {
            continue;
        }
        const double as_kmph = kmph_per_mps * *row.speed_kmph;
        if (off(as_kmph, limits_apart_kmph) < rounded_kmph) {
            reading.warn(
                table.place(row.row, "speed_kmph"),
                joined("a speed of ", config::to_text(*row.speed_kmph), " km/h, which looks like ",
                       config::to_text(std::round(as_kmph)), " km/h in m/s"),
                "a speed in km/h",
                "multiply it by 3.6: slow vehicles stay longer below the slope, and the risk is too large",
                config::Effect::answer);
        }
    }
}

/// Warns of more persons than fit into a house.
void judge_persons(const config::Table& table, const Rows& rows, Reading& reading) {
    // [choice] One person on ten square metres of ten floors.
    constexpr double most_per_m2 = 1.0;
    constexpr double least_persons = 20.0;
    for (const config::Read<TargetRow>& row : rows) {
        if (!row.persons || *row.persons < least_persons || row.shape.kind != config::Shape::Kind::polygon) {
            continue;
        }
        const double plan_m2 = plausible::area_m2(row.shape);
        if (*row.persons > most_per_m2 * plan_m2) {
            reading.warn(table.place(row.row, "persons"),
                         joined(config::to_text(*row.persons), " persons in a house of ",
                                config::to_text(std::round(plan_m2)), " m2"),
                         "who live or work there, at most one on each square metre",
                         "correct persons: deaths grow with them", config::Effect::answer);
        }
    }
}

/// Warns of houses that lie over each other: a rock there hits both, and each counts.
void judge_doubled_houses(const config::Table& table, const Rows& rows, Reading& reading) {
    std::vector<const config::Shape*> areas;
    std::vector<const config::Read<TargetRow>*> houses;
    for (const config::Read<TargetRow>& row : rows) {
        if (row.is_house() && row.shape.kind == config::Shape::Kind::polygon) {
            areas.push_back(&row.shape);
            houses.push_back(&row);
        }
    }
    constexpr double least_share = 0.1;  // [choice] of the smaller one; walls that touch share a little
    const std::vector<plausible::Overlap> pairs = plausible::overlapping(areas, least_share);
    if (pairs.empty()) {
        return;
    }
    const config::Read<TargetRow>& second = *houses[pairs.front().second];
    reading.warn(
        table.place(second.row, "wkt"),
        joined("houses over each other, such as ", config::in_quotes(houses[pairs.front().first]->id),
               " and ", config::in_quotes(second.id), ": rocks that hit both are counted for both"),
        "houses beside each other", "delete one of them, or draw their outlines again",
        config::Effect::answer);
}

}  // namespace

void judge_exposure(const config::Table& table, const Rows& rows, Reading& reading) {
    judge_alike_columns(table, reading);
    judge_silent_targets(table, rows, reading);
    judge_house_values(table, rows, reading);
    judge_speeds(table, rows, reading);
    judge_persons(table, rows, reading);
    judge_doubled_houses(table, rows, reading);
}

void judge_exposed_beyond(const std::vector<std::string>& ids, const config::Place& place, Reading& reading) {
    if (ids.empty()) {
        return;
    }
    reading.warn(place,
                 joined(counted(ids.size(), "target"),
                        " with persons, vehicles or value wholly beyond the "
                        "terrain, such as ",
                        config::in_quotes(ids.front()), ": the risk leaves out what happens there"),
                 "a terrain that holds every target whose risk is asked for",
                 "take a larger terrain, or leave them out of the file", config::Effect::answer);
}

}  // namespace coupling
