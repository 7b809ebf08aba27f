#include "coupling/inputs/zone_blocks.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "config/text/numbers.hpp"

namespace coupling {
namespace {

constexpr config::NumberRange period_range{.low = 0.0, .high = 1e6, .low_excluded = true};
constexpr config::NumberRange zone_range{.low = 1.0, .high = 4e9};

std::string name_of_zone(std::uint32_t zone) {
    return zone == all_other_zones ? "all other zones" : "zone " + std::to_string(zone);
}

/// Whether a row says how large its rocks are; adds a problem if not.
bool says_size(const config::Table& table, std::size_t row, config::Problems& problems) {
    for (const char* column : {"diameter_m", "mass_t", "volume_m3"}) {
        if (has_value(table, row, column)) {
            return true;
        }
    }
    problems.add(config::ExitCode::data, table.place(row, "return_period_years"), "no size of the rocks",
                 "diameter_m, mass_t or volume_m3");
    return false;
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
            reading.doubt(here.place,
                          name_of_zone(here.zone) + ": rocks of " + config::to_text(size_m) + " m with " +
                              config::to_text(here.return_period_years) + " years, of " +
                              config::to_text(size_before_m) + " m with " +
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

}  // namespace

std::vector<ZoneBlocks> read_zone_blocks(Reading& reading) {
    const config::Table table = reading.table("hazard.blocks", "blocks", reading.scenario().hazard.blocks);
    config::Problems problems;
    table.require({"return_period_years"}, problems);
    problems.throw_if_any();
    doubt_columns(table, reading);
    std::vector<ZoneBlocks> blocks;
    std::map<std::pair<std::uint32_t, double>, std::size_t> rows;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const auto period = table.number(row, "return_period_years", period_range, problems);
        const auto zone = has_value(table, row, "zone") ? table.whole(row, "zone", zone_range, problems)
                                                        : std::optional<long long>{all_other_zones};
        const bool has_size = says_size(table, row, problems);
        SourceStart start = read_source_start(table, row, reading.scenario(), problems);
        if (!period || !zone || !has_size || !start.law) {
            continue;
        }
        const std::pair key{static_cast<std::uint32_t>(*zone), *period};
        if (!rows.emplace(key, row).second) {
            problems.add(
                config::ExitCode::data, table.place(row, "return_period_years"),
                name_of_zone(key.first) + " a second time with " + config::to_text(*period) + " years",
                "one row for a zone and a return period");
            continue;
        }
        blocks.push_back({*period, key.first, std::move(start), table.place(row, "return_period_years")});
    }
    if (table.rows() == 0) {
        problems.add(config::ExitCode::data, {table.file()}, "no rows",
                     "rocks of at least one zone with one return period");
    }
    config::Problems shown;
    add_first(shown, problems, table.file());
    shown.throw_if_any();
    doubt_falling_sizes(blocks, reading);
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
    const double wanted = reading.scenario().hazard.return_period_years;
    input.by_zone = true;
    input.starts.clear();
    for (const ZoneBlocks& entry : blocks) {
        if (entry.return_period_years == wanted) {
            input.start_of_zone[entry.zone] = input.starts.size();
            input.starts.push_back(entry.start);
        }
    }
    if (input.starts.empty()) {
        config::fail(config::ExitCode::settings,
                     reading.scenario().options->place_of("hazard.return_period_years"),
                     "hazard.return_period_years " + config::to_text(wanted),
                     "one of hazard.blocks: " + in_words(return_periods_of(blocks)));
    }
    for (const char* key : {"release.diameter_kind", "release.diameter_m", "release.diameter_classes_m"}) {
        if (reading.scenario().options->was_set(key)) {
            reading.note(std::string{key} + " has no effect: hazard.blocks says how large the rocks are");
        }
    }
}

}  // namespace coupling
