#include <algorithm>
#include <cmath>
#include <memory>

#include "config/text/joined.hpp"
#include "coupling/results/report/markup.hpp"
#include "coupling/validation/forest_cases/comparison.hpp"
#include "coupling/validation/forest_cases/yield_trial/comparison.hpp"

namespace coupling::validation::forest_cases {
namespace {

using config::joined;
using forest::StandFigures;
using forest::TreeLight;
using report::fixed;
using yield_trial::YieldCase;
using yield_trial::YieldComparison;
using yield_trial::YieldSite;
using yield_trial::YieldTableRow;

struct YieldData {
    forest::SpeciesTable species = forest::SpeciesTable::shipped();
    YieldCase tables;
    std::vector<int> ages_years;
};

/// A site in both kinds of light, at every age.
struct SiteOutcome {
    std::vector<YieldComparison> space;
    std::vector<YieldComparison> layers;
};

std::string whole(double value) {
    return std::to_string(std::lround(value));
}

std::string place_of(const YieldSite& site, int age_years) {
    return joined(":", site.name, ":", std::to_string(age_years));
}

std::string words_of(const YieldData& data, const YieldSite& site) {
    return joined(data.species[site.species].latin_name, " at ", whole(site.elevation_m), " m");
}

/// A figure by the name it has in yield_trial::yield_figures().
struct YieldMeasure {
    const char* name;
    const char* label;
    const char* unit;
    bool of_table;  ///< simulated / table
};
constexpr std::array<YieldMeasure, 8> yield_measures{{{"volume_ratio", "volume / table", "-", true},
                                                      {"dbh_ratio", "mean DBH / table", "-", true},
                                                      {"height_ratio", "mean height / table", "-", true},
                                                      {"stems_ratio", "stems / table", "-", true},
                                                      {"volume_m3pha", "volume", "m3/ha", false},
                                                      {"dbh_cm", "mean DBH", "cm", false},
                                                      {"height_m", "mean height", "m", false},
                                                      {"stems_pha", "stems", "1/ha", false}}};
constexpr const char* layers_volume = "layers_volume_m3pha";

void add_figures(Comparison& comparison, const YieldData& data, const YieldSite& site) {
    for (const int age_years : data.ages_years) {
        const std::string words = joined(", ", words_of(data, site), ", age ", std::to_string(age_years));
        for (const YieldMeasure& measure : yield_measures) {
            if (!measure.of_table || !site.table.empty()) {
                comparison.figures.push_back(
                    {measure.name + place_of(site, age_years), joined(measure.label, words), measure.unit});
            }
        }
        comparison.figures.push_back(
            {layers_volume + place_of(site, age_years), joined("volume in light by layers", words), "m3/ha"});
    }
}

/// The site's own data alone.
SiteOutcome grow(const YieldData& data, std::size_t site, TreeLight light) {
    const YieldCase one{
        {data.tables.sites[site]}, data.tables.rows, data.tables.climates, data.tables.parameters};
    std::vector<YieldComparison> found = compare_yields(one, data.species, light, data.ages_years);
    return light == TreeLight::in_space ? SiteOutcome{std::move(found), {}}
                                        : SiteOutcome{{}, std::move(found)};
}

double lorey_as_mean_m(const StandFigures& figures) {
    return yield_trial::mean_per_lorey_height * figures.lorey_height_m;
}

/// Sites with a table, in the order of their elevation.
std::vector<std::size_t> with_table(const YieldData& data) {
    std::vector<std::size_t> sites;
    for (std::size_t i = 0; i < data.tables.sites.size(); ++i) {
        if (!data.tables.sites[i].table.empty()) {
            sites.push_back(i);
        }
    }
    std::stable_sort(sites.begin(), sites.end(), [&](std::size_t a, std::size_t b) {
        return data.tables.sites[a].elevation_m < data.tables.sites[b].elevation_m;
    });
    return sites;
}

std::string roman(double site_class) {
    static const std::array<const char*, 5> names{"I", "II", "III", "IV", "V"};
    const double index = site_class - 1.0;
    const bool is_whole = index >= 0.0 && index < 5.0 && index == std::floor(index);
    return is_whole ? names[static_cast<std::size_t>(index)] : report::tick_text(site_class);
}

/// Volumes at an age over elevation; the classes of the table as level lines, that of each site as a dot.
Plot over_elevation(const YieldData& data, const std::vector<SiteOutcome>& found, std::size_t age) {
    const std::vector<std::size_t> sites = with_table(data);
    const YieldSite& first = data.tables.sites[sites.front()];
    const double low_m = first.elevation_m - 250.0;
    const double high_m = data.tables.sites[sites.back()].elevation_m + 500.0;
    Plot plot{.title = joined("Age ", std::to_string(data.ages_years[age])),
              .x = {"Elevation, m", low_m, high_m},
              .y = {"Volume, m3/ha", 0.0, 0.0},
              .series = {},
              .labels = {},
              .caption = ""};
    PlotSeries ours{"Bannwald", "default", PlotSeries::Form::line, {}, {}};
    PlotSeries layers{"Bannwald, light by layers", "other0", PlotSeries::Form::line, {}, {}};
    PlotSeries table{"table, class of the site", "published", PlotSeries::Form::dots, {}, {}};
    double most = 0.0;
    for (const std::size_t site : sites) {
        if (data.tables.sites[site].table != first.table) {
            continue;
        }
        const double at_m = data.tables.sites[site].elevation_m;
        ours.points.push_back({at_m, found[site].space[age].simulated.volume_m3pha});
        layers.points.push_back({at_m, found[site].layers[age].simulated.volume_m3pha});
        table.points.push_back({at_m, found[site].space[age].published->volume_m3pha});
        most = std::max({most, ours.points.back().y, layers.points.back().y, table.points.back().y});
    }
    for (const YieldTableRow& row : data.tables.rows) {
        if (row.table == first.table && row.age_years == data.ages_years[age]) {
            plot.series.push_back({"classes of the table",
                                   "level",
                                   PlotSeries::Form::line,
                                   {{low_m, row.volume_m3pha}, {high_m - 170.0, row.volume_m3pha}},
                                   {}});
            plot.labels.push_back({high_m - 170.0, row.volume_m3pha, roman(row.site_class)});
            most = std::max(most, row.volume_m3pha);
        }
    }
    plot.y = report::Axis::from_zero(plot.y.title, most);
    plot.series.push_back(std::move(layers));
    plot.series.push_back(std::move(ours));
    plot.series.push_back(std::move(table));
    return plot;
}

/// A figure of stands over their age, ours and the table's.
Plot over_age(const YieldData& data, const std::vector<SiteOutcome>& found, std::string title,
              std::string unit, double (*simulated)(const StandFigures&), double YieldTableRow::*published) {
    const double from = data.ages_years.front();
    const double to = data.ages_years.back();
    Plot plot{.title = std::move(title),
              .x = {"Age, years", from - 10.0, to + 20.0},
              .y = {std::move(unit), 0.0, 0.0},
              .series = {},
              .labels = {},
              .caption = ""};
    double most = 0.0;
    for (const std::size_t site : with_table(data)) {
        PlotSeries ours{"Bannwald", "default", PlotSeries::Form::line, {}, {}};
        PlotSeries table{"table, class of the site", "published", PlotSeries::Form::dots, {}, {}};
        for (const YieldComparison& one : found[site].space) {
            const double age = one.age_years;
            ours.points.push_back({age, simulated(one.simulated)});
            table.points.push_back({age, (*one.published).*published});
            most = std::max({most, ours.points.back().y, table.points.back().y});
        }
        plot.labels.push_back(
            {to + 1.5, ours.points.back().y, joined(whole(data.tables.sites[site].elevation_m), " m")});
        plot.series.push_back(std::move(ours));
        plot.series.push_back(std::move(table));
    }
    plot.y = report::Axis::from_zero(plot.y.title, most);
    return plot;
}

PlainTable beside_the_table(const YieldData& data, const std::vector<SiteOutcome>& found,
                            const std::vector<std::size_t>& ages) {
    PlainTable table{
        .caption = "Simulated / table; volume by layers: trees without places",
        .head = {"site", "fertility", "class", "age, years", "stems, 1/ha", "mean DBH, cm", "mean height, m",
                 "basal area, m2/ha", "volume, m3/ha", "volume by layers, m3/ha"},
        .rows = {}};
    for (const std::size_t i : with_table(data)) {
        const YieldSite& site = data.tables.sites[i];
        for (const std::size_t a : ages) {
            const StandFigures& ours = found[i].space[a].simulated;
            const YieldTableRow& theirs = *found[i].space[a].published;
            const auto pair = [](double one, double other, int decimals) {
                return joined(fixed(one, decimals), " / ", fixed(other, decimals));
            };
            table.rows.push_back({words_of(data, site), report::tick_text(site.fertility),
                                  roman(site.site_class), std::to_string(data.ages_years[a]),
                                  pair(ours.stems_pha, theirs.stems_pha, 0),
                                  pair(ours.mean_dbh_cm, theirs.mean_dbh_cm, 1),
                                  pair(lorey_as_mean_m(ours), theirs.mean_height_m, 1),
                                  pair(ours.basal_area_m2pha, theirs.basal_area_m2pha, 1),
                                  pair(ours.volume_m3pha, theirs.volume_m3pha, 0),
                                  fixed(found[i].layers[a].simulated.volume_m3pha, 0)});
        }
    }
    return table;
}

/// Sites without a table at the last of the ages shown.
PlainTable without_table(const YieldData& data, const std::vector<SiteOutcome>& found, std::size_t age) {
    PlainTable table{
        .caption = joined("Sites that no table is laid beside, age ", std::to_string(data.ages_years[age])),
        .head = {"site", "fertility", "stems, 1/ha", "mean DBH, cm", "mean height, m", "basal area, m2/ha",
                 "volume, m3/ha", "volume by layers, m3/ha"},
        .rows = {}};
    for (std::size_t i = 0; i < data.tables.sites.size(); ++i) {
        const YieldSite& site = data.tables.sites[i];
        if (!site.table.empty()) {
            continue;
        }
        const StandFigures& ours = found[i].space[age].simulated;
        table.rows.push_back(
            {words_of(data, site), report::tick_text(site.fertility), fixed(ours.stems_pha, 0),
             fixed(ours.mean_dbh_cm, 1), fixed(lorey_as_mean_m(ours), 1), fixed(ours.basal_area_m2pha, 1),
             fixed(ours.volume_m3pha, 0), fixed(found[i].layers[age].simulated.volume_m3pha, 0)});
    }
    return table;
}

Outcome compare(const YieldData& data, const std::vector<std::size_t>& shown, const Work& work) {
    const std::size_t sites = data.tables.sites.size();
    std::vector<SiteOutcome> found(sites);
    each_piece(work, 2 * sites, [&](std::size_t piece) {
        const std::size_t site = piece / 2;
        if (piece % 2 == 0) {
            found[site].space = grow(data, site, TreeLight::in_space).space;
        } else {
            found[site].layers = grow(data, site, TreeLight::by_layers).layers;
        }
    });
    Outcome outcome;
    for (const SiteOutcome& site : found) {
        for (const auto& [name, value] : yield_figures(site.space)) {
            outcome.values[name] = value;
        }
        for (const YieldComparison& one : site.layers) {
            outcome.values[joined(layers_volume, ":", one.site, ":", std::to_string(one.age_years))] =
                one.simulated.volume_m3pha;
        }
    }
    if (!with_table(data).empty()) {
        const YieldSite& first = data.tables.sites[with_table(data).front()];
        const std::string& latin = data.species[first.species].latin_name;
        PlotGroup elevation{joined(latin, " over elevation"), {}, false};
        for (const std::size_t age : shown) {
            elevation.plots.push_back(over_elevation(data, found, age));
        }
        PlotGroup age{joined(latin, " over age, by elevation"), {}, false};
        age.plots.push_back(over_age(
            data, found, "Volume", "Volume, m3/ha",
            [](const StandFigures& figures) { return figures.volume_m3pha; }, &YieldTableRow::volume_m3pha));
        age.plots.push_back(over_age(data, found, "Mean height", "Mean height, m", lorey_as_mean_m,
                                     &YieldTableRow::mean_height_m));
        outcome.plots = {std::move(elevation), std::move(age)};
        outcome.tables.push_back(beside_the_table(data, found, shown));
    }
    outcome.tables.push_back(without_table(data, found, shown.back()));
    return outcome;
}

/// Every site needs the rows of its table at every age.
void check_rows(const YieldData& data, const CaseFiles& files) {
    config::Problems problems;
    for (const YieldSite& site : data.tables.sites) {
        for (const int age_years : data.ages_years) {
            const bool there =
                std::any_of(data.tables.rows.begin(), data.tables.rows.end(), [&](const YieldTableRow& row) {
                    return row.table == site.table && row.site_class == site.site_class &&
                           row.age_years == age_years;
                });
            if (!site.table.empty() && !there) {
                problems.add(config::ExitCode::data, {files.shown("yield_tables.csv")},
                             joined("no row of table ", config::in_quotes(site.table), " for site ",
                                    site.name, " at age ", std::to_string(age_years)));
            }
        }
    }
    problems.throw_if_any();
}

/// Places of some ages among all.
std::vector<std::size_t> places_of(const std::vector<int>& some, const std::vector<int>& all) {
    std::vector<std::size_t> places;
    for (const int age_years : some) {
        const auto found = std::find(all.begin(), all.end(), age_years);
        if (found == all.end()) {
            config::fail(config::ExitCode::settings, {},
                         joined("yield.drawn_ages_years ", std::to_string(age_years)),
                         "ages of yield.ages_years");
        }
        places.push_back(static_cast<std::size_t>(found - all.begin()));
    }
    return places;
}

}  // namespace

Comparison read_yield(const CaseFiles& files, const std::vector<int>& ages_years,
                      const std::vector<int>& drawn_ages_years, const forest::Parameters& parameters) {
    auto data = std::make_shared<YieldData>();
    config::Warnings warnings;
    data->tables = {yield_trial::read_yield_sites(table_of(files, "sites.csv"), data->species),
                    yield_trial::read_yield_rows(table_of(files, "yield_tables.csv")),
                    forest::read_climate(table_of(files, "climate.csv"), warnings), parameters};
    data->ages_years = ages_years;
    check_rows(*data, files);
    const std::vector<std::size_t> drawn = places_of(drawn_ages_years, ages_years);
    Comparison comparison;
    for (const YieldSite& site : data->tables.sites) {
        add_figures(comparison, *data, site);
    }
    comparison.extent = joined(std::to_string(data->tables.sites.size()), " plantations up to age ",
                               std::to_string(ages_years.back()), ", in two kinds of light");
    comparison.pieces = 2 * data->tables.sites.size();
    comparison.run = [data, drawn](const Work& work) { return compare(*data, drawn, work); };
    return comparison;
}

}  // namespace coupling::validation::forest_cases
