#include "coupling/inputs/release/zone_blocks.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <utility>

#include "config/text/coordinates.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/reading/declared_tables.hpp"
#include "coupling/inputs/scenario/hazard_settings.hpp"
#include "rockfall/release/release.hpp"

namespace coupling {
namespace {

using config::joined;

std::string name_of_zone(std::uint32_t zone) {
    return zone == all_other_zones ? "all other zones" : "zone " + std::to_string(zone);
}

/// Longer return periods bring larger rocks: the other way round two rows may have been mistaken.
void doubt_falling_sizes(std::vector<ZoneBlocks> blocks, Reading& reading) {
    std::stable_sort(blocks.begin(), blocks.end(), [](const ZoneBlocks& a, const ZoneBlocks& b) {
        return std::pair{a.zone, a.return_period_years} < std::pair{b.zone, b.return_period_years};
    });
    for (std::size_t i = 1; i < blocks.size(); ++i) {
        const ZoneBlocks& before = blocks[i - 1];
        const ZoneBlocks& here = blocks[i];
        const double size_m = here.start.law->diameter.mean_m();
        const double size_before_m = before.start.law->diameter.mean_m();
        if (here.zone == before.zone && size_m < size_before_m) {
            reading.warn(here.place,
                         name_of_zone(here.zone) + ": rocks of " + config::metres_in_words(size_m) +
                             " m with " + config::to_text(here.return_period_years) + " years, of " +
                             config::metres_in_words(size_before_m) + " m with " +
                             config::to_text(before.return_period_years),
                         "rocks that do not get smaller with longer return periods");
        }
    }
}

std::string in_words(const std::vector<double>& periods) {
    std::string text;
    for (const double period : periods) {
        text += (text.empty() ? "" : ", ") + config::to_text(period);
    }
    return text;
}

void refuse_rocks_of_shapes(const SourceInput& input) {
    config::Problems problems;
    for (const SourceShape& shape : input.shapes) {
        const SourceStart& start = input.starts[shape.start];
        if (start.blocks || start.law) {
            problems.add(config::ExitCode::data, shape.place, "a source with rocks of its own",
                         "sources without: hazard.blocks says which rocks their zones have");
        }
    }
    config::Problems shown;
    add_first(shown, problems, input.file);
    shown.throw_if_any();
}

/// Refuses a table that says how often rocks break off instead of their return period.
void refuse_frequencies(const config::Table& table) {
    if (table.has("return_period_years")) {
        return;
    }
    for (const std::string& column : table.columns_beside({})) {
        std::string letters;
        for (const char letter : column) {
            letters += static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
        }
        for (const char* word :
             {"frequen", "fréquen", "probab", "wahrscheinlich", "häufigkeit", "haeufigkeit"}) {
            if (letters.find(word) != std::string::npos) {
                config::fail(config::ExitCode::data, {table.file()},
                             joined("the column ", config::in_quotes(column), " and no return_period_years"),
                             "years between two releases",
                             "add a column return_period_years: 100 divided by per cent a year, 1 divided by "
                             "a number a year");
            }
        }
    }
}

/// Of more releases a year than a slope is known for, years may not be what the column holds.
void note_frequent_releases(const std::vector<ZoneBlocks>& blocks, const std::string& file,
                            Reading& reading) {
    constexpr double most_a_year = 10.0;  // [choice]
    double a_year = 0.0;
    for (const ZoneBlocks& row : blocks) {
        a_year += 1.0 / row.return_period_years;
    }
    if (a_year > most_a_year) {
        reading.note(joined(file, ": ", config::to_text(std::round(a_year)),
                            " releases a year in all: return periods are years between two releases"));
    }
}

/// The fields of a row that rocks depend on, in an order of their own: columns may change places.
std::string fields_of(const config::Table& table, std::size_t row) {
    std::string text;
    for (const std::string& column : zone_block_columns().names()) {
        if (column != "return_period_years" && has_value(table, row, column)) {
            text += joined(column, " ", table.text(row, column), "\n");
        }
    }
    return text;
}

/// The rows of one return period, in order of zones: rows may change places too.
std::string hash_of_rows(std::vector<ZoneBlocks> rows) {
    std::sort(rows.begin(), rows.end(),
              [](const ZoneBlocks& a, const ZoneBlocks& b) { return a.zone < b.zone; });
    std::string text;
    for (const ZoneBlocks& row : rows) {
        text += joined("row\n", row.fields);
    }
    return hash_text(text);
}

std::set<std::uint32_t> zones_of(const SourceInput& input) {
    std::set<std::uint32_t> zones;
    if (input.everywhere) {
        zones.insert(1);
    }
    for (const SourceShape& shape : input.shapes) {
        zones.insert(shape.zone);
    }
    if (input.grid) {
        for (const double value : input.grid->values) {
            if (value > 0.0) {  // NaN is none
                zones.insert(static_cast<std::uint32_t>(value));
            }
        }
    }
    return zones;
}

/// Zones of which only the sources or only hazard.blocks know.
void warn_of_zones(const SourceInput& input, Reading& reading) {
    const std::string years = config::to_text(reading.hazard().return_period_years);
    const std::set<std::uint32_t> zones = zones_of(input);
    std::vector<std::uint32_t> without;
    std::copy_if(zones.begin(), zones.end(), std::back_inserter(without),
                 [&](std::uint32_t zone) { return !start_of(input, zone, 0); });
    if (!without.empty()) {
        constexpr std::size_t named = 3;
        std::string names;
        for (std::size_t i = 0; i < std::min(named, without.size()); ++i) {
            names += joined(i > 0 ? ", " : "", std::to_string(without[i]));
        }
        reading.warn(
            {input.file},
            joined(counted(without.size(), "zone"), " (", names, without.size() > named ? ", ..." : "",
                   ") without rocks of ", years, " years in hazard.blocks; none fall from there"),
            "a row for each zone and return period, or one without zone for all others");
    }
    for (const auto& [zone, start] : input.start_of_zone) {
        if (zone != all_other_zones && !zones.contains(zone)) {
            reading.warn(
                {reading.shown(reading.hazard().blocks)},
                joined("zone ", std::to_string(zone), " with rocks of ", years, " years but no source"),
                "zones of the sources");
        }
    }
}

}  // namespace

std::optional<std::size_t> start_of(const SourceInput& input, std::uint32_t zone, std::size_t own) {
    if (!input.by_zone) {
        return own;
    }
    auto found = input.start_of_zone.find(zone);
    if (found == input.start_of_zone.end()) {
        found = input.start_of_zone.find(all_other_zones);
    }
    return found == input.start_of_zone.end() ? std::nullopt : std::optional{found->second};
}

std::vector<ZoneBlocks> read_zone_blocks(Reading& reading) {
    const config::TableSchema& schema = zone_block_columns();
    const config::Table table =
        reading.table(schema.rules().setting, schema.rules().role, reading.hazard().blocks);
    refuse_frequencies(table);
    check_columns(table, schema, reading);
    config::RowProblems wrong{table};
    std::vector<ZoneBlocks> blocks;
    std::set<std::pair<std::uint32_t, double>> known;
    for (const config::Read<SourceRow>& row : zone_block_columns().rows(table, wrong)) {
        const std::uint32_t zone = row.zone.value_or(all_other_zones);
        if (!row.has_size()) {
            wrong.refuse(row.row, "return_period_years", "no size of the rocks",
                         "diameter_m, mass_t or volume_m3");
        }
        if (!known.emplace(zone, row.return_period_years).second) {
            wrong.refuse(row.row, "return_period_years",
                         name_of_zone(zone) + " a second time with " +
                             config::to_text(row.return_period_years) + " years",
                         "one row for a zone and a return period");
        }
        blocks.push_back({row.return_period_years, zone, read_source_start(row, reading, wrong),
                          table.place(row.row, "return_period_years"), fields_of(table, row.row)});
    }
    wrong.throw_first();
    doubt_falling_sizes(blocks, reading);
    note_frequent_releases(blocks, table.file(), reading);
    return blocks;
}

std::vector<double> return_periods_of(const std::vector<ZoneBlocks>& blocks) {
    std::vector<double> periods;
    for (const ZoneBlocks& entry : blocks) {
        periods.push_back(entry.return_period_years);
    }
    std::sort(periods.begin(), periods.end());
    periods.erase(std::unique(periods.begin(), periods.end()), periods.end());
    return periods;
}

void take_zone_blocks(SourceInput& input, Reading& reading) {
    const std::vector<ZoneBlocks> blocks = read_zone_blocks(reading);
    refuse_rocks_of_shapes(input);
    const double wanted = reading.hazard().return_period_years;
    input.by_zone = true;
    input.starts.clear();
    std::vector<ZoneBlocks> heeded;
    for (const ZoneBlocks& entry : blocks) {
        if (entry.return_period_years == wanted) {
            heeded.push_back(entry);
            input.start_of_zone[entry.zone] = input.starts.size();
            input.starts.push_back(entry.start);
        }
    }
    if (input.starts.empty()) {
        config::fail(config::ExitCode::settings,
                     reading.settings().options->place_of("hazard.return_period_years"),
                     "hazard.return_period_years " + config::to_text(wanted),
                     "one of hazard.blocks: " + in_words(return_periods_of(blocks)));
    }
    reading.use_part_of("return_periods", joined("rows of ", config::to_text(wanted), " years"),
                        hash_of_rows(std::move(heeded)));
    warn_of_zones(input, reading);
}

void doubt_zones_without_rocks(const std::vector<rockfall::ReleaseSource>& sources, Reading& reading) {
    std::map<std::uint32_t, std::uint64_t> rocks_of_zone;
    for (const rockfall::ReleaseSource& source : sources) {
        rocks_of_zone[source.zone] += source.rocks;
    }
    const auto empty = static_cast<std::size_t>(std::count_if(
        rocks_of_zone.begin(), rocks_of_zone.end(), [](const auto& entry) { return entry.second == 0; }));
    if (empty > 0) {
        reading.warn(reading.settings().options->place_of("release.rocks"),
                     joined("rocks of ", config::to_text(reading.hazard().return_period_years), " years for ",
                            std::to_string(rocks_of_zone.size() - empty), " of ",
                            counted(rocks_of_zone.size(), "zone"), "; none fall from the others"),
                     "more rocks, or blocks for each zone");
    }
}

}  // namespace coupling
