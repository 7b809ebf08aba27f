#include "coupling/assessments/hazard/target_layer.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "config/text/formatted.hpp"
#include "coupling/assessments/hazard/hazard_colours.hpp"

namespace coupling::hazard {
namespace {

using geopackage::ColumnType;

/// "" for what is not known and for no end.
std::string to_field(double value) {
    constexpr int digits = 6;
    return std::isfinite(value) ? config::with_digits(value, digits) : "";
}

/// A quantity of risk a year of a target on a slope; "" where it is not assessed.
std::string risk_field(const HazardResults& results, std::size_t target, Cover cover,
                       risk::Quantity quantity) {
    if (!results.risk) {
        return "";
    }
    const auto& exposed = results.risk->targets;
    const auto found = std::find_if(exposed.begin(), exposed.end(),
                                    [&](const risk::TargetRisk& one) { return one.target == target; });
    return found == exposed.end() ? "" : to_field(found->risk.slopes[index_of(cover)].at(quantity).value);
}

std::vector<std::vector<config::Point2>> absolute_parts(const rockfall::Target& target, const Site& site) {
    const Eigen::Vector2d origin_m = site.origin_m();
    std::vector<std::vector<config::Point2>> parts;
    for (const std::vector<Eigen::Vector2d>& part : target.parts) {
        parts.emplace_back();
        for (const Eigen::Vector2d& vertex : part) {
            parts.back().push_back({vertex.x() + origin_m.x(), vertex.y() + origin_m.y()});
        }
    }
    return parts;
}

}  // namespace

geopackage::AreaLayer target_layer(const HazardResults& results) {
    geopackage::AreaLayer layer{
        "target_levels",
        "Targets with their hazard level and risk, by slope.",
        {{"target_id", ColumnType::text, "id of the target"},
         {"name", ColumnType::text, "its name"},
         {"cover", ColumnType::text, "forest or bare"},
         {"rule", ColumnType::text, "hazard.rule"},
         {"level", ColumnType::text, "hazard level"},
         {"level_number", ColumnType::whole, "the same as a number"},
         {"hit_every_years", ColumnType::number,
          "mean time between two hits by rocks of all return periods; empty: none hits"},
         {"energy_kj", ColumnType::number, "as in hazard_targets.csv"},
         {"deaths_per_year", ColumnType::number, "risk; empty: not assessed"},
         {"money_per_year", ColumnType::number, "risk in risk.currency; empty: not assessed"}},
        {},
        "level",
        {}};
    for (std::size_t level = 0; level < levels; ++level) {
        layer.classes.push_back({level_names[level], level_names[level], level_colours()[level].colour});
    }
    for (const SlopeHazard& slope : results.slopes) {
        for (std::size_t i = 0; i < results.site.targets.size(); ++i) {
            const rockfall::Target& target = results.site.targets[i];
            const TargetHazard& hazard = slope.targets[i];
            layer.rows.push_back(
                {{target.id, target.name, name_of(slope.cover), rule_name(slope.map.rule),
                  level_name(hazard.ruled.level), std::to_string(static_cast<int>(hazard.ruled.level)),
                  to_field(1.0 / hazard.hits_per_year), to_field(hazard.ruled.energy.kj),
                  risk_field(results, i, slope.cover, risk::Quantity::deaths),
                  risk_field(results, i, slope.cover, risk::Quantity::money)},
                 absolute_parts(target, results.site),
                 !target.is_area});
        }
    }
    return layer;
}

}  // namespace coupling::hazard
