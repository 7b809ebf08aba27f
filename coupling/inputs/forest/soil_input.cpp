#include "coupling/inputs/forest/soil_input.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/reading/declared_tables.hpp"
#include "coupling/inputs/scenario/forest_settings.hpp"
#include "forest/production/soil.hpp"

namespace coupling {

struct ForestSoilRow : forest::Soil {
    long long code = 0;
};

namespace {

using config::joined;

std::map<double, forest::Soil> read_types(Reading& reading) {
    std::map<double, forest::Soil> types;
    for (const ForestSoilRow& row : rows_of(soil_columns(), reading.forest().soil_types, reading)) {
        types.emplace(static_cast<double>(row.code), row);
    }
    return types;
}

/// The soil where no map says: a code of soil.types, or a shipped one. Nitrogen and pH of shipped types are
/// those of a middling forest soil (forest::Soil).
std::optional<forest::Soil> soil_elsewhere(const std::map<double, forest::Soil>& types, Reading& reading) {
    const std::string& name = reading.forest().soil_type;
    if (name.empty()) {
        return std::nullopt;
    }
    const auto code = config::parse_whole(name);
    const auto own = types.find(static_cast<double>(code.value_or(-1)));
    if (own != types.end()) {
        return own->second;
    }
    std::string known;
    for (const forest::SoilType& type : forest::shipped_soil_types()) {
        if (type.name == name) {
            forest::Soil soil;
            soil.water_capacity_mm = type.water_capacity_mm;
            soil.texture_class = type.soil_class;
            soil.fertility = type.fertility;
            return soil;
        }
        known += (known.empty() ? "" : ", ") + type.name;
    }
    config::fail(config::ExitCode::settings, reading.settings().options->place_of("soil.type"),
                 joined("soil.type ", config::in_quotes(name)),
                 joined("one of ", known, types.empty() ? "" : ", or a code of soil.types"),
                 "or describe the soil yourself with soil.map and soil.types");
}

void check_codes(const SoilCover& cover, Reading& reading) {
    std::map<double, std::size_t> unknown;
    std::map<double, std::size_t> first;
    for (std::size_t cell = 0; cell < cover.map->values.size(); ++cell) {
        const double code = cover.map->values[cell];
        if (!std::isnan(code) && !cover.types.contains(code)) {
            first.emplace(code, cell);
            ++unknown[code];
        }
    }
    std::string known;
    for (const auto& [code, soil] : cover.types) {
        known += (known.empty() ? "" : ", ") + config::to_text(code);
    }
    for (const auto& [code, cells] : unknown) {
        reading.refuse({cover.file},
                       joined("soil code ", config::to_text(code), " in ", counted(cells, "cell"),
                              ", the first in ", cell_in_words(cover.map->frame, first.at(code))),
                       joined("a code of ", reading.shown(reading.forest().soil_types),
                              known.empty() ? ", which has none" : ": ", known),
                       "add a row for this code, or correct the map");
    }
}

}  // namespace

const config::Schema<ForestSoilRow>& soil_columns() {
    using config::above;
    // clang-format off
    static const config::Schema<ForestSoilRow> columns{
        {.role = "soil_types", .setting = "soil.types", .row = "soil"},
        {{"code", &ForestSoilRow::code, "as in soil.map", {.range = {.low = 0.0}, .unique = true, .advice = "delete one of the rows, or give it a code of its own"}},
         {"water_capacity_mm", &ForestSoilRow::water_capacity_mm, "water that plants can take", {.range = {0.0, 600.0, above}}},
         {"texture_class", &ForestSoilRow::texture_class, "1 sand, 2 sandy loam, 3 clay loam, 4 clay", {.range = {1.0, 4.0}}},
         {"fertility", &ForestSoilRow::fertility, "0 poor, 1 rich", {.unit = "-", .range = {0.0, 1.0}}},
         {"nitrogen_kg_per_ha_year", &ForestSoilRow::nitrogen_kg_per_ha_year, "that plants can take", {.range = {0.0, 200.0}}},
         {"ph", &ForestSoilRow::ph, "of the upper soil", {.range = {2.5, 9.0}}}}};
    // clang-format on
    return columns;
}

double SoilCover::code_at(double x_m, double y_m) const {
    if (map) {
        const config::Cell cell = map->frame.cell_at(x_m, y_m);
        if (map->frame.contains(cell)) {
            return map->at(cell);
        }
    }
    return std::numeric_limits<double>::quiet_NaN();
}

std::optional<forest::Soil> SoilCover::at(double x_m, double y_m) const {
    const double code = code_at(x_m, y_m);
    if (std::isnan(code)) {
        return elsewhere;
    }
    const auto found = types.find(code);
    return found == types.end() ? std::nullopt : std::optional{found->second};
}

std::optional<SoilCover> read_soils(Reading& reading) {
    const ForestSettings& s = reading.forest();
    SoilCover cover;
    bool is_complete = true;
    bool has_types = false;
    if (!s.soil_types.empty()) {
        auto types = reading.attempt([&] { return read_types(reading); });
        is_complete = has_types = types.has_value();
        cover.types = types.value_or(std::map<double, forest::Soil>{});
    }
    if (is_complete) {
        const auto elsewhere = reading.attempt([&] { return soil_elsewhere(cover.types, reading); });
        is_complete = elsewhere.has_value();
        cover.elsewhere = elsewhere.value_or(std::nullopt);
    }
    if (!s.soil_map.empty()) {
        cover.file = reading.shown(s.soil_map);
        cover.map = reading.attempt([&] { return reading.grid("soil.map", "soil", s.soil_map); });
        if (cover.map && has_types) {
            check_codes(cover, reading);
        }
    }
    return is_complete && (s.soil_map.empty() || cover.map) ? std::optional{std::move(cover)} : std::nullopt;
}

}  // namespace coupling
