#include "forest/production/soil.hpp"

#include <algorithm>
#include <cmath>

#include "config/data/shipped_tables.hpp"
#include "config/text/numbers.hpp"
#include "forest/production/power.hpp"

namespace forest {

namespace {

constexpr double field_capacity_kpa = -15.0;
constexpr double wilting_kpa = -4000.0;
constexpr double kpa_per_cm_of_water = 0.098;

}  // namespace

void check(const SoilTexture& texture, const config::Place& place) {
    config::Problems problems;
    const auto expect_percent = [&](double percent, const std::string& name) {
        if (percent < 0.0 || percent > 100.0) {
            problems.add(config::ExitCode::data, place, name + " " + config::to_text(percent),
                         "a share in [0, 100] %");
        }
    };
    expect_percent(texture.sand_percent, "sand");
    expect_percent(texture.silt_percent, "silt");
    expect_percent(texture.clay_percent, "clay");
    const double sum = texture.sand_percent + texture.silt_percent + texture.clay_percent;
    if (problems.empty() && std::abs(sum - 100.0) > 1.0) {
        problems.add(config::ExitCode::data, place, "sand, silt and clay of " + config::to_text(sum) + " %",
                     "100 % together");
    }
    problems.throw_if_any();
}

double SoilRetention::potential_kpa(double water) const {
    return saturated_potential_kpa * power(water / saturated_water, -exponent);
}

double SoilRetention::water_at(double potential_kpa) const {
    const double share = power(potential_kpa / saturated_potential_kpa, -1.0 / exponent);
    return saturated_water * std::min(share, 1.0);
}

SoilRetention retention_of(const SoilTexture& texture) {
    const double sand = texture.sand_percent;
    const double suction_cm = power(10.0, 1.54 - 0.0095 * sand + 0.0063 * texture.silt_percent);
    return {-kpa_per_cm_of_water * suction_cm, 3.1 + 0.157 * texture.clay_percent - 0.003 * sand,
            0.505 - 0.00142 * sand - 0.00037 * texture.clay_percent};
}

double available_water_mm(const SoilTexture& texture, double depth_cm, double stone_share) {
    const SoilRetention retention = retention_of(texture);
    const double share = retention.water_at(field_capacity_kpa) - retention.water_at(wilting_kpa);
    constexpr double mm_per_cm = 10.0;
    return mm_per_cm * depth_cm * (1.0 - stone_share) * share;
}

int soil_class_of(const SoilTexture& texture) {
    if (texture.clay_percent >= 40.0) {
        return 4;
    }
    if (texture.sand_percent >= 70.0 && texture.clay_percent < 15.0) {
        return 1;
    }
    return texture.sand_percent >= 50.0 && texture.clay_percent < 20.0 ? 2 : 3;
}

std::vector<SoilType> read_soil_types(const config::Table& table) {
    config::Problems problems;
    table.require({"name", "water_capacity", "soil_class", "fertility"}, problems);
    problems.throw_if_any();
    std::vector<SoilType> types;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        types.push_back({table.text(row, "name"),
                         table.number(row, "water_capacity", {0.0, 600.0, true}, problems).value_or(0.0),
                         static_cast<int>(table.whole(row, "soil_class", {1.0, 4.0}, problems).value_or(3)),
                         table.number(row, "fertility", {0.0, 1.0}, problems).value_or(0.0)});
    }
    problems.throw_if_any();
    return types;
}

std::vector<SoilType> shipped_soil_types() {
    return read_soil_types(config::read_shipped_table("forest_soils.csv"));
}

}  // namespace forest
