#include "validation/engine/forest_cases/belts/plots.hpp"

#include <utility>

#include "config/text/joined.hpp"

namespace coupling::validation::forest_cases::belts {
namespace {

using config::joined;
using succession_trial::SuccessionSite;
using succession_trial::SuccessionState;

/// "F. sylvatica": what fits beside a layer.
std::string short_name(const std::string& latin) {
    const std::size_t blank = latin.find(' ');
    return latin.starts_with("other") || blank == std::string::npos
               ? latin
               : joined(latin.substr(0, 1), ".", latin.substr(blank));
}

/// Layers on top of each other at rising x; those that are thick at the end are named there.
void stack(Plot& plot, const Palette& palette, const std::vector<double>& x,
           const std::vector<std::vector<double>>& layers, double least_named) {
    std::vector<double> floors(x.size(), 0.0);
    for (std::size_t layer = 0; layer < palette.layers(); ++layer) {
        PlotSeries series{palette.name(layer), palette.style(layer), PlotSeries::Form::band, {}, {}};
        for (std::size_t i = 0; i < x.size(); ++i) {
            series.ranges.push_back({x[i], floors[i], floors[i] + layers[i][layer]});
            floors[i] = series.ranges.back().high;
        }
        const report::ChartRange& last = series.ranges.back();
        if (last.high - last.low > least_named) {
            plot.labels.push_back({last.x, 0.5 * (last.low + last.high), short_name(palette.name(layer))});
        }
        plot.series.push_back(std::move(series));
    }
}

}  // namespace

Plot over_years(const BeltData& data, const Found& found, const Palette& palette, std::size_t site,
                double most_tpha) {
    const SuccessionSite& at = data.tables.sites[site];
    const auto last = static_cast<double>(data.settings.years);
    constexpr double room_for_names = 1.35;
    Plot plot{.title = site_words(at),
              .x = {"Years since bare ground", 0.0, room_for_names * last},
              .y = report::Axis::from_zero("Biomass above ground, t/ha", most_tpha),
              .series = {},
              .labels = {},
              .caption = ""};
    std::vector<double> x{0.0};
    std::vector<std::vector<double>> layers{std::vector<double>(palette.layers(), 0.0)};
    for (const SuccessionState& state : found.runs[site * data.settings.replicates].states) {
        x.push_back(state.year);
        layers.push_back(palette.layered(mean_biomass_tpha(found.runs, at.name, {state.year, state.year})));
    }
    stack(plot, palette, x, layers, 0.06 * plot.y.high);
    return plot;
}

Plot over_elevation(const BeltData& data, const Found& found, const Palette& palette, bool shares) {
    std::vector<double> x;
    std::vector<std::vector<double>> layers;
    double most_tpha = 0.0;
    for (std::size_t site = 0; site < data.tables.sites.size(); ++site) {
        if (has_other_climate(data.tables.sites[site])) {
            continue;
        }
        const double all_tpha = sum_of(found.judged_tpha[site]);
        std::vector<double> here = palette.layered(found.judged_tpha[site]);
        for (double& value : here) {
            value *= shares && all_tpha > 0.0 ? 100.0 / all_tpha : 1.0;
        }
        x.push_back(data.tables.sites[site].elevation_m);
        layers.push_back(std::move(here));
        most_tpha = std::max(most_tpha, all_tpha);
    }
    const double room_for_names_m = 0.35 * (x.back() - x.front());
    Plot plot{.title = shares ? "Shares of the biomass" : "Biomass",
              .x = {"Elevation, m", x.front(), x.back() + room_for_names_m},
              .y = shares ? report::Axis{"Share of the biomass above ground, %", 0.0, 100.0}
                          : report::Axis::from_zero("Biomass above ground, t/ha", most_tpha),
              .series = {},
              .labels = {},
              .caption = joined("Mean over the years ", std::to_string(data.judged.first), " to ",
                                std::to_string(data.judged.last), " and all replicates; straight between ",
                                std::to_string(x.size()), " places.")};
    stack(plot, palette, x, layers, 0.06 * plot.y.high);
    return plot;
}

}  // namespace coupling::validation::forest_cases::belts
