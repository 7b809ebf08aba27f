#include "coupling/inputs/places/exposure_checks.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <utility>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/plausible/overlapping_areas.hpp"

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

/// Warns where no line of a list has vehicles beside houses with persons: a road would have no risk, and the
/// total be none of it. Beside a road with traffic a line without is another thing, such as a river; so is a
/// list that says nothing of any target.
void judge_silent_lines(const config::Table& table, const Rows& rows, Reading& reading) {
    const auto is_silent = [](const TargetRow& row) { return !row.is_road() && !row.is_house(); };
    const auto is_silent_line = [&](const TargetRow& row) {
        return is_silent(row) && row.shape.kind == config::Shape::Kind::line;
    };
    const auto lines = static_cast<std::size_t>(std::count_if(rows.begin(), rows.end(), is_silent_line));
    const auto is_road = [](const TargetRow& row) { return row.is_road(); };
    if (lines == 0 || std::all_of(rows.begin(), rows.end(), is_silent) ||
        std::any_of(rows.begin(), rows.end(), is_road)) {
        return;
    }
    const auto first = std::find_if(rows.begin(), rows.end(), is_silent_line);
    reading.warn(table.place(first->row, "wkt"),
                 joined(counted(lines, "line"), " without vehicles, such as ", config::in_quotes(first->id),
                        ": the risk leaves out what happens there"),
                 "vehicles_per_day, speed_kmph and persons_per_vehicle of a road",
                 "fill them in; 0 vehicles where nobody drives", config::Effect::answer);
}

/// Warns where half of the speeds or more are usual ones in metres per second: 13.9 for 50 km/h.
void judge_speeds(const config::Table& table, const Rows& rows, Reading& reading) {
    constexpr double kmph_per_mps = 3.6;
    constexpr double limits_apart_kmph = 10.0;  // [choice] speed limits go by tens
    constexpr double rounded_kmph = 0.4;        // of one decimal in m/s
    constexpr double whole_kmph = 0.05;
    constexpr double fastest_mps = 40.0;
    const auto off = [](double value, double of) { return std::abs(std::remainder(value, of)); };
    std::size_t given = 0;
    std::vector<const config::Read<TargetRow>*> odd;
    for (const config::Read<TargetRow>& row : rows) {
        given += row.speed_kmph ? 1U : 0U;
        if (row.speed_kmph && *row.speed_kmph <= fastest_mps && off(*row.speed_kmph, 1.0) >= whole_kmph &&
            off(kmph_per_mps * *row.speed_kmph, limits_apart_kmph) < rounded_kmph) {
            odd.push_back(&row);
        }
    }
    if (odd.empty() || 2 * odd.size() < given) {
        return;
    }
    const double first_kmph = *odd.front()->speed_kmph;
    reading.warn(table.place(odd.front()->row, "speed_kmph"),
                 joined("a speed of ", config::to_text(first_kmph), " km/h, which looks like ",
                        config::to_text(std::round(kmph_per_mps * first_kmph)), " km/h in m/s"),
                 "a speed in km/h",
                 "multiply it by 3.6: slow vehicles stay longer below the slope, and the risk is too large",
                 config::Effect::answer);
}

/// Warns of more persons than fit into a house.
void judge_persons(const config::Table& table, const Rows& rows, Reading& reading) {
    // [choice] One person on ten square metres of ten floors.
    constexpr double most_per_m2 = 1.0;
    constexpr double least_persons = 20.0;
    const auto is_crowded = [&](const TargetRow& row) {
        return row.persons && *row.persons >= least_persons &&
               row.shape.kind == config::Shape::Kind::polygon &&
               *row.persons > most_per_m2 * plausible::area_m2(row.shape);
    };
    const auto first = std::find_if(rows.begin(), rows.end(), is_crowded);
    if (first == rows.end()) {
        return;
    }
    const auto crowded = static_cast<std::size_t>(std::count_if(first, rows.end(), is_crowded));
    reading.warn(table.place(first->row, "persons"),
                 joined(counted(crowded, "house"), " with more persons than square metres, such as ",
                        config::in_quotes(first->id), " with ", config::to_text(*first->persons)),
                 "who live or work there, at most one on each square metre",
                 "correct persons: deaths grow with them", config::Effect::answer);
}

/// Warns where all houses have 0 persons: no risk to people would be counted, with no word that none is.
void judge_empty_houses(const config::Table& table, const Rows& rows, Reading& reading) {
    const auto has_persons = [](const TargetRow& row) { return row.persons.has_value(); };
    const auto is_lived_in = [](const TargetRow& row) { return row.persons.value_or(0.0) > 0.0; };
    const auto first = std::find_if(rows.begin(), rows.end(), has_persons);
    const auto houses = static_cast<std::size_t>(std::count_if(rows.begin(), rows.end(), has_persons));
    if (houses < 2 || std::any_of(rows.begin(), rows.end(), is_lived_in)) {
        return;
    }
    reading.warn(table.place(first->row, "persons"),
                 joined("0 persons in each of ", std::to_string(houses), " houses"), "who live or work there",
                 "fill them in, or leave the column out where persons are not counted",
                 config::Effect::answer);
}

}  // namespace

void judge_exposure(const config::Table& table, const Rows& rows, Reading& reading) {
    judge_alike_columns(table, reading);
    judge_silent_lines(table, rows, reading);
    judge_house_values(table, rows, reading);
    judge_speeds(table, rows, reading);
    judge_persons(table, rows, reading);
    judge_empty_houses(table, rows, reading);
}

void judge_doubled_houses(const std::vector<ExposedHouse>& houses, Reading& reading) {
    std::vector<const config::Shape*> areas;
    for (const ExposedHouse& house : houses) {
        areas.push_back(&house.outline);
    }
    // [choice] Of the smaller one: walls that touch share a little. Equal outlines are dwellings of one
    // house, of which a note says that they count the same rocks.
    constexpr double least_share = 0.1;
    constexpr double same_outline = 0.98;
    std::vector<plausible::Overlap> pairs = plausible::overlapping(areas, least_share);
    std::erase_if(pairs, [&](const plausible::Overlap& pair) {
        return pair.share > same_outline &&
               plausible::area_m2(*areas[pair.first]) == plausible::area_m2(*areas[pair.second]);
    });
    if (pairs.empty()) {
        return;
    }
    const ExposedHouse& second = houses[pairs.front().second];
    reading.warn(second.place,
                 joined("houses that lie partly over each other, such as ",
                        config::in_quotes(houses[pairs.front().first].id), " and ",
                        config::in_quotes(second.id), ": rocks that hit both are counted for both"),
                 "houses beside each other",
                 "look at them on the map: delete what stands there twice, or draw the outlines again",
                 config::Effect::answer);
}

void judge_exposed_beyond(const std::vector<std::string>& ids, const config::Place& place, Reading& reading) {
    if (ids.empty()) {
        return;
    }
    reading.warn(place,
                 joined(counted(ids.size(), "target"),
                        " with persons, vehicles or value close beyond the terrain, such as ",
                        config::in_quotes(ids.front()), ": the risk leaves out what happens there"),
                 "a terrain that reaches beyond every target whose risk is asked for",
                 "take a larger terrain, or leave them out of the file", config::Effect::answer);
}

}  // namespace coupling
