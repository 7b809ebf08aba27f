#include "coupling/program/actions/describe_forest.hpp"

#include <algorithm>
#include <array>
#include <iomanip>
#include <numeric>
#include <set>
#include <sstream>

#include "coupling/inputs/forest/forest_site.hpp"
#include "coupling/inputs/reading/reading.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/program/actions/listing.hpp"
#include "coupling/results/text/markup.hpp"
#include "forest/climate/summary.hpp"
#include "forest/inventory/tables.hpp"

namespace coupling {

namespace {

struct Range {
    double low = 0.0;
    double high = 0.0;
    double mean = 0.0;
};

template <class Value>
Range range_over(const forest::PatchGrid& grid, const Value& value) {
    Range range{value(grid.patches().front()), value(grid.patches().front()), 0.0};
    for (const forest::Patch& patch : grid.patches()) {
        range.low = std::min(range.low, value(patch));
        range.high = std::max(range.high, value(patch));
        range.mean += value(patch) / static_cast<double>(grid.size());
    }
    return range;
}

Range heights_of(const forest::PatchGrid& grid) {
    return range_over(grid, [](const forest::Patch& patch) { return patch.ground_m; });
}

void say_ground(const forest::PatchGrid& grid, std::ostream& out) {
    const Range height = heights_of(grid);
    const Range slope = range_over(grid, [](const forest::Patch& patch) { return patch.slope.in_degrees(); });
    std::set<std::uint32_t> stands;
    std::vector<forest::Soil> soils;
    for (const forest::Patch& patch : grid.patches()) {
        stands.insert(patch.management_unit);
        if (std::find(soils.begin(), soils.end(), patch.soil) == soils.end()) {
            soils.push_back(patch.soil);
        }
    }
    const Range water =
        range_over(grid, [](const forest::Patch& patch) { return patch.soil.water_capacity_mm; });
    std::ostringstream text;
    text << report::hectares(grid.area_ha()) << " ha (" << grid.size() << " patches of 10 m), " << std::fixed
         << std::setprecision(0) << height.low << " to " << height.high << " m, mean slope " << slope.mean
         << " degrees";
    say(out, "forest", text.str());
    say(out, "stands", std::to_string(stands.size()));
    text.str("");
    text << counted(soils.size(), "type") << " with ";
    if (water.high > water.low) {
        text << water.low << " to ";
    }
    text << water.high << " mm of water";
    say(out, "soil", text.str());
}

const char* in_words(ClimateOrder order) {
    switch (order) {
        case ClimateOrder::repeat:
            return "its own years, then the same again";
        case ClimateOrder::random:
            return "years drawn by chance";
        case ClimateOrder::once:
            break;
    }
    return "its own years";
}

void say_climate(const ForestSite& forest, const SiteClimate& named, std::ostream& out) {
    const ClimateSource& climate = named.source;
    const double height_m = heights_of(forest.grid).mean;
    const forest::ClimateSeries here =
        at_elevation(climate.series, height_m - *climate.series.elevation_m, climate.lapse_rates);
    double temperature_degc = 0.0;
    double precipitation_mm = 0.0;
    for (const forest::ClimateYear& year : here.years) {
        const forest::ClimateSummary summary = forest::summary_of(year);
        temperature_degc += summary.mean_degc / static_cast<double>(here.years.size());
        precipitation_mm += summary.prec_mm / static_cast<double>(here.years.size());
    }
    std::ostringstream text;
    text << (forest.climates.size() > 1 ? named.name + ": " : "") << here.first_year() << " to "
         << here.last_year() << ", " << in_words(climate.order) << "; " << std::fixed << std::setprecision(1)
         << temperature_degc << " degC and " << std::setprecision(0) << precipitation_mm << " mm a year at "
         << height_m << " m";
    if (climate.changes()) {
        const auto mean = [](const std::array<double, 12>& months) {
            return std::accumulate(months.begin(), months.end(), 0.0) / 12.0;
        };
        text << ", before the change of " << std::showpos << std::setprecision(1)
             << mean(climate.change.temperature_k) << std::noshowpos << " K and of rain to "
             << std::setprecision(0) << 100.0 * mean(climate.change.precipitation) << " %";
    }
    say(out, "climate", text.str());
}

void say_start(const Scenario& scenario, const ForestSite& forest, std::ostream& out) {
    const forest::Stand start = forest.start(scenario.run.seed, 0);
    std::ostringstream text;
    if (start.trees().empty()) {
        text << "bare ground";
    } else {
        const forest::StandFigures figures =
            figures_of(start.trees(), forest.species.table, forest.grid.area_ha());
        const auto by_species =
            figures_by_species(start.trees(), forest.species.table, forest.grid.area_ha());
        const auto species =
            std::count_if(by_species.begin(), by_species.end(),
                          [](const forest::StandFigures& of_one) { return of_one.stems_pha > 0.0; });
        text << start.stems_standing() << (forest.listed.empty() ? " from records" : " of the list") << ", "
             << species << " species: " << std::fixed << std::setprecision(0) << figures.stems_pha
             << " stems/ha, " << std::setprecision(1) << figures.basal_area_m2pha << " m2/ha, "
             << std::setprecision(0) << figures.volume_m3pha << " m3/ha";
    }
    if (!forest.obstacles.empty()) {
        text << "; " << forest.obstacles.size() << " outside the forest";
    }
    say(out, "trees", text.str());
}

}  // namespace

void describe_forest(const Scenario& scenario, const Site& site, const decades::Management& management,
                     std::ostream& out) {
    const ForestSite& forest = *site.forest;
    say_ground(forest.grid, out);
    for (const SiteClimate& climate : forest.climates) {
        say_climate(forest, climate, out);
    }
    say_start(scenario, forest, out);
    std::string regimes;
    for (const Regime& regime : management.regimes) {
        regimes += (regimes.empty() ? "" : ", ") + regime.name() + " (" +
                   counted(regime.interventions().size(), "intervention") + ")";
    }
    say(out, "regimes", regimes);
    const std::size_t replicates = scenario.forest.replicates;
    say(out, "members",
        counted(management.regimes.size(), "regime") + " x " + counted(forest.climates.size(), "climate") +
            " x " + counted(replicates, "replicate") + ", " + std::to_string(forest.first_year()) + " to " +
            std::to_string(forest.first_year() + static_cast<int>(scenario.run.years) - 1));
}

}  // namespace coupling
