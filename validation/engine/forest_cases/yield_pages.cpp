#include "validation/engine/forest_cases/yield_pages.hpp"

#include <algorithm>
#include <cmath>

#include "config/text/joined.hpp"
#include "coupling/results/text/markup.hpp"

namespace coupling::validation::forest_cases {

namespace {

using config::joined;
using report::fixed;
using yield_trial::SiteYields;
using yield_trial::YieldComparison;
using yield_trial::YieldSite;
using yield_trial::YieldTableRow;

std::string whole(double value) {
    return std::to_string(std::lround(value));
}

const YieldComparison* at_age(const SiteYields& yields, int age_years) {
    const auto found = std::find_if(yields.ages.begin(), yields.ages.end(),
                                    [&](const YieldComparison& one) { return one.age_years == age_years; });
    return found == yields.ages.end() ? nullptr : &*found;
}

/// Sites of one species with a table, in the order of their elevation.
std::vector<std::size_t> sites_with_table(const YieldData& data, forest::SpeciesId kind) {
    std::vector<std::size_t> sites;
    for (std::size_t i = 0; i < data.tables.sites.size(); ++i) {
        if (!data.tables.sites[i].table.empty() && data.tables.sites[i].species == kind) {
            sites.push_back(i);
        }
    }
    std::stable_sort(sites.begin(), sites.end(), [&](std::size_t a, std::size_t b) {
        return data.tables.sites[a].elevation_m < data.tables.sites[b].elevation_m;
    });
    return sites;
}

/// A figure over age: simulated as a line, the table as dots, one pair a site.
template <class Simulated>
Plot plot_over_age(const YieldData& data, const std::vector<SiteOutcome>& found,
                   const std::vector<std::size_t>& sites, std::string title, std::string unit,
                   Simulated simulated, double YieldTableRow::*published) {
    const double from = data.ages_years.front();
    const double to = data.ages_years.back();
    Plot plot{.title = std::move(title),
              .x = {"Age, years", from - 10.0, to + 25.0},
              .y = {std::move(unit), 0.0, 0.0},
              .series = {},
              .labels = {},
              .caption = ""};
    double most = 0.0;
    for (const std::size_t site : sites) {
        PlotSeries ours{"Bannwald, thinned as the table", "default", PlotSeries::Form::line, {}, {}};
        PlotSeries table{"table, class of the site", "published", PlotSeries::Form::dots, {}, {}};
        for (const YieldComparison& one : found[site].thinned.ages) {
            const double age = one.age_years;
            ours.points.push_back({age, simulated(one)});
            table.points.push_back({age, (*one.published).*published});
            most = std::max({most, ours.points.back().y, table.points.back().y});
        }
        plot.labels.push_back({ours.points.back().x + 1.5, ours.points.back().y,
                               joined(whole(data.tables.sites[site].elevation_m), " m")});
        plot.series.push_back(std::move(ours));
        plot.series.push_back(std::move(table));
    }
    plot.y = report::Axis::from_zero(plot.y.title, most);
    return plot;
}

PlotGroup plots_of(const YieldData& data, const std::vector<SiteOutcome>& found, forest::SpeciesId kind,
                   const std::vector<std::size_t>& sites) {
    PlotGroup group{joined(data.species[kind].latin_name, " over age, by elevation"), {}, false};
    group.plots.push_back(plot_over_age(
        data, found, sites, "Volume", "Volume, m3/ha",
        [](const YieldComparison& one) { return one.simulated.figures.volume_m3pha; },
        &YieldTableRow::volume_m3pha));
    group.plots.push_back(plot_over_age(
        data, found, sites, "Mean diameter", "Mean DBH, cm",
        [](const YieldComparison& one) { return one.simulated.figures.mean_dbh_cm; },
        &YieldTableRow::mean_dbh_cm));
    group.plots.push_back(plot_over_age(
        data, found, sites, "Mean height", "Mean height, m",
        [](const YieldComparison& one) { return one.simulated.mean_height_m; },
        &YieldTableRow::mean_height_m));
    return group;
}

PlainTable beside_the_table(const YieldData& data, const std::vector<SiteOutcome>& found) {
    PlainTable table{.caption = "Simulated / table, thinned to the stems of the table",
                     .head = {"site", "fertility", "class", "age, years", "stems, 1/ha", "mean DBH, cm",
                              "mean height, m", "basal area, m2/ha", "volume, m3/ha"},
                     .rows = {}};
    const auto pair = [](double one, double other, int decimals) {
        return joined(fixed(one, decimals), " / ", fixed(other, decimals));
    };
    for (std::size_t i = 0; i < found.size(); ++i) {
        const YieldSite& site = data.tables.sites[i];
        for (const YieldComparison& one : found[i].thinned.ages) {
            const bool drawn = std::find(data.drawn_ages_years.begin(), data.drawn_ages_years.end(),
                                         one.age_years) != data.drawn_ages_years.end();
            if (!one.published || !drawn) {
                continue;
            }
            const forest::StandFigures& ours = one.simulated.figures;
            const YieldTableRow& theirs = *one.published;
            table.rows.push_back({words_of(data, site), report::tick_text(site.soil.fertility),
                                  site.site_class, std::to_string(one.age_years),
                                  pair(ours.stems_pha, theirs.stems_pha, 0),
                                  pair(ours.mean_dbh_cm, theirs.mean_dbh_cm, 1),
                                  pair(one.simulated.mean_height_m, theirs.mean_height_m, 1),
                                  pair(ours.basal_area_m2pha, theirs.basal_area_m2pha, 1),
                                  pair(ours.volume_m3pha, theirs.volume_m3pha, 0)});
        }
    }
    return table;
}

/// Stands left alone at the last of the ages drawn that they reach.
PlainTable left_alone(const YieldData& data, const std::vector<SiteOutcome>& found) {
    PlainTable table{.caption =
                         "Stands left alone. The self-thinning line is an input of the model: stems beside "
                         "it show that it is kept, not that it is right",
                     .head = {"site", "fertility", "age, years", "stems, 1/ha", "mean DBH, cm",
                              "basal area, m2/ha", "volume, m3/ha", "volume by layers, m3/ha",
                              "top height, m", "slenderness of the 100 thickest, m/m",
                              "most stems / line [input]", "stems / line at 25 cm [input]"},
                     .rows = {}};
    for (std::size_t i = 0; i < found.size(); ++i) {
        const YieldSite& site = data.tables.sites[i];
        for (auto age = data.drawn_ages_years.rbegin(); age != data.drawn_ages_years.rend(); ++age) {
            const YieldComparison* const one = at_age(found[i].twin, *age);
            if (one == nullptr) {
                continue;
            }
            const forest::StandFigures& ours = one->simulated.figures;
            const YieldComparison* const layers = at_age(found[i].layers, *age);
            const std::optional<double>& at_25cm = found[i].twin.density_at_25cm;
            table.rows.push_back(
                {words_of(data, site), report::tick_text(site.soil.fertility), std::to_string(*age),
                 fixed(ours.stems_pha, 0), fixed(ours.mean_dbh_cm, 1), fixed(ours.basal_area_m2pha, 1),
                 fixed(ours.volume_m3pha, 0), fixed(layers->simulated.figures.volume_m3pha, 0),
                 fixed(ours.dominant_height_m, 1), fixed(one->simulated.dominant_slenderness, 0),
                 fixed(found[i].twin.greatest_density, 2), at_25cm ? fixed(*at_25cm, 2) : "not reached"});
            break;
        }
    }
    return table;
}

}  // namespace

std::string words_of(const YieldData& data, const YieldSite& site) {
    return joined(data.species[site.species].latin_name, " at ", whole(site.elevation_m), " m");
}

void add_yield_pages(Outcome& outcome, const YieldData& data, const std::vector<SiteOutcome>& found) {
    std::vector<forest::SpeciesId> drawn;
    for (const YieldSite& site : data.tables.sites) {
        if (!site.table.empty() && std::find(drawn.begin(), drawn.end(), site.species) == drawn.end()) {
            drawn.push_back(site.species);
            outcome.plots.push_back(
                plots_of(data, found, site.species, sites_with_table(data, site.species)));
        }
    }
    outcome.tables.push_back(beside_the_table(data, found));
    if (data.twins) {
        outcome.tables.push_back(left_alone(data, found));
    }
}

}  // namespace coupling::validation::forest_cases
