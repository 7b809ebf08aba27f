#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <numeric>

#include "config/errors/warnings.hpp"
#include "config/text/joined.hpp"
#include "coupling/results/report/markup.hpp"
#include "coupling/validation/forest_cases/comparison.hpp"
#include "coupling/validation/forest_cases/succession_trial/comparison.hpp"
#include "forest/climate/series.hpp"

namespace coupling::validation::forest_cases {
namespace {

using config::joined;
using report::fixed;
using succession_trial::SuccessionRun;
using succession_trial::SuccessionSite;
using succession_trial::SuccessionState;

struct BeltData {
    forest::SpeciesTable species;
    succession_trial::SuccessionCase tables;
    std::vector<std::string> published;  ///< of each group: what the literature has
    std::vector<std::string> sources;
    BeltSettings settings;
    forest::YearWindow judged;
};

std::string group_words(std::string name) {
    for (std::size_t at = name.find('_'); at != std::string::npos; at = name.find('_')) {
        name.replace(at, 1, " and ");
    }
    return name;
}

bool has_other_climate(const SuccessionSite& site) {
    return site.warmer_k != 0.0 || site.rain_factor != 1.0;
}

/// "1200 m", or "1200 m, +4 K, rain x 0.7".
std::string site_words(const SuccessionSite& site) {
    std::string words = joined(std::to_string(std::lround(site.elevation_m)), " m");
    if (site.warmer_k != 0.0) {
        words += joined(", ", site.warmer_k > 0.0 ? "+" : "", report::tick_text(site.warmer_k), " K");
    }
    if (site.rain_factor != 1.0) {
        words += joined(", rain x ", report::tick_text(site.rain_factor));
    }
    return words;
}

std::string at_words(const SuccessionSite& site) {
    return joined("at ", site_words(site));
}

void add_figures(Comparison& comparison, const BeltData& data) {
    for (const SuccessionSite& site : data.tables.sites) {
        for (const succession_trial::StandMeasure& measure : succession_trial::stand_measures()) {
            comparison.figures.push_back({joined(measure.name, ":", site.name),
                                          joined(measure.label, " ", at_words(site)), measure.unit});
        }
        for (const double from_cm : succession_trial::death_class_from_cm) {
            const std::string cm = std::to_string(std::lround(from_cm));
            comparison.figures.push_back(
                {joined("death_rate_from_", cm, "cm:", site.name),
                 joined("deaths a year of trees from ", cm, " cm on, in their class, ", at_words(site)),
                 "-"});
        }
        for (const succession_trial::SpeciesGroup& native : data.tables.natives) {
            if (native.site == site.name) {
                const std::string of = joined(":", native.name, ":", site.name);
                const std::string species =
                    joined(data.species[native.species.front()].latin_name, " ", at_words(site));
                comparison.figures.push_back(
                    {joined("kept", of), joined("replicates with thick ", species), "-"});
                comparison.figures.push_back({joined("alive", of), joined("replicates with ", species), "-"});
            }
        }
        for (const succession_trial::SpeciesGroup& group : data.tables.groups) {
            if (group.site == site.name) {
                const std::string of = joined(":", group.name, ":", site.name);
                comparison.figures.push_back(
                    {joined("share", of), joined("share of ", group_words(group.name), " ", at_words(site)),
                     "-"});
                comparison.figures.push_back(
                    {joined("margin", of), joined("lead of ", group_words(group.name), " ", at_words(site)),
                     "-"});
            }
        }
    }
}

/// The species by what they make up over all places, greatest first, each with its style: the colours go to
/// the first ones, grey to the others together.
class Palette {
public:
    static constexpr std::size_t colours = 7;

    Palette(const BeltData& data, const std::vector<std::vector<double>>& biomass_tpha) {
        std::vector<double> sums(data.species.size(), 0.0);
        for (const std::vector<double>& site : biomass_tpha) {
            std::transform(site.begin(), site.end(), sums.begin(), sums.begin(), std::plus<>{});
        }
        order_.resize(sums.size());
        std::iota(order_.begin(), order_.end(), std::size_t{0});
        std::stable_sort(order_.begin(), order_.end(),
                         [&](std::size_t a, std::size_t b) { return sums[a] > sums[b]; });
        for (std::size_t rank = 0; rank < std::min(colours, order_.size()); ++rank) {
            names_.push_back(data.species.all()[order_[rank]].latin_name);
        }
        if (order_.size() > colours) {
            names_.emplace_back("other species");
        }
    }

    /// Layers of a stack, the lowest first.
    [[nodiscard]] std::size_t layers() const { return names_.size(); }
    [[nodiscard]] const std::string& name(std::size_t layer) const { return names_[layer]; }
    [[nodiscard]] std::string style(std::size_t layer) const {
        return joined("layer", std::to_string(layer));
    }
    /// Figures of all species as those of the layers.
    [[nodiscard]] std::vector<double> layered(const std::vector<double>& by_species) const {
        std::vector<double> sums(layers(), 0.0);
        for (std::size_t rank = 0; rank < order_.size(); ++rank) {
            sums[std::min(rank, layers() - 1)] += by_species[order_[rank]];
        }
        return sums;
    }

private:
    std::vector<std::size_t> order_;
    std::vector<std::string> names_;
};

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

/// What a case has found, by site.
struct Found {
    std::vector<SuccessionRun> runs;               ///< site by site, replicate by replicate
    std::vector<std::vector<double>> judged_tpha;  ///< by site and species, mean over the judged years
};

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

double sum_of(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0);
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

PlainTable biomass_table(const BeltData& data, const Found& found, const Palette& palette) {
    PlainTable table{
        .caption = joined("Biomass above ground, t/ha, and its share in %: mean over the years ",
                          std::to_string(data.judged.first), " to ", std::to_string(data.judged.last)),
        .head = {"place", "all, t/ha"},
        .rows = {}};
    for (std::size_t layer = 0; layer < palette.layers(); ++layer) {
        table.head.push_back(joined(palette.name(layer), ", t/ha (%)"));
    }
    for (std::size_t site = 0; site < data.tables.sites.size(); ++site) {
        const double all_tpha = sum_of(found.judged_tpha[site]);
        std::vector<std::string> row{site_words(data.tables.sites[site]), fixed(all_tpha, 0)};
        for (const double tpha : palette.layered(found.judged_tpha[site])) {
            row.push_back(
                joined(fixed(tpha, 0), " (", fixed(all_tpha > 0.0 ? 100.0 * tpha / all_tpha : 0.0, 0), ")"));
        }
        table.rows.push_back(std::move(row));
    }
    return table;
}

/// Structure of the stands in the judged years.
PlainTable structure_table(const BeltData& data, const std::map<std::string, double>& values) {
    PlainTable table{.caption = "Structure, and deaths in % of the trees of a diameter class a year",
                     .head = {"place", "stem wood, m3/ha", "basal area, m2/ha", "stems above 60 cm, 1/ha",
                              "top height, m", "dead wood, m3/ha", "drought index", "deaths from 10 cm",
                              "from 20 cm", "from 40 cm", "from 60 cm"},
                     .rows = {}};
    for (const SuccessionSite& site : data.tables.sites) {
        const auto figure = [&](const char* name, double factor, int decimals) {
            return fixed(factor * values.at(joined(name, ":", site.name)), decimals);
        };
        table.rows.push_back(
            {site_words(site), figure("volume_m3pha", 1.0, 0), figure("basal_area_m2pha", 1.0, 1),
             figure("stems_60cm_pha", 1.0, 0), figure("top_height_m", 1.0, 1),
             figure("dead_wood_m3pha", 1.0, 0), figure("drought_index", 1.0, 2),
             figure("death_rate_from_10cm", 100.0, 2), figure("death_rate_from_20cm", 100.0, 2),
             figure("death_rate_from_40cm", 100.0, 2), figure("death_rate_from_60cm", 100.0, 2)});
    }
    return table;
}

/// Figures of a site in some columns, by the name before ":SITE".
PlainTable table_by_site(const BeltData& data, const std::map<std::string, double>& values,
                         std::string caption, const std::vector<std::pair<std::string, std::string>>& columns,
                         int decimals) {
    PlainTable table{.caption = std::move(caption), .head = {"place"}, .rows = {}};
    for (const auto& [name, words] : columns) {
        table.head.push_back(words);
    }
    for (const SuccessionSite& site : data.tables.sites) {
        std::vector<std::string> row{site_words(site)};
        for (const auto& [name, words] : columns) {
            row.push_back(fixed(values.at(joined(name, ":", site.name)), decimals));
        }
        table.rows.push_back(std::move(row));
    }
    return table;
}

PlainTable dead_wood_table(const BeltData& data, const std::map<std::string, double>& values) {
    std::vector<std::pair<std::string, std::string>> columns{{"dead_wood_m3pha", "all, m3/ha"}};
    for (std::size_t i = 1; i <= forest::decay_class_count; ++i) {
        const std::string number = std::to_string(i);
        columns.emplace_back(joined("dead_wood_class", number, "_m3pha"), joined("class ", number));
    }
    return table_by_site(data, values, "Dead wood by decay class, 1 fresh to 5 falling to pieces", columns,
                         0);
}

PlainTable disturbance_table(const BeltData& data, const std::map<std::string, double>& values) {
    return table_by_site(data, values,
                         joined("Stem wood taken a year, m3/ha, from year ",
                                std::to_string(data.settings.disturbed_from_year), " on"),
                         {{"lost_to_wind_m3pha", "storms"},
                          {"lost_to_snow_m3pha", "wet snow"},
                          {"lost_to_beetle_m3pha", "bark beetles"}},
                         2);
}

/// Smallest and largest share of a group among the replicates of its site.
std::string spread_of(const BeltData& data, const Found& found, const succession_trial::SpeciesGroup& group) {
    double least = 1.0;
    double most = 0.0;
    const auto value = joined("share:", group.name, ":", group.site);
    for (const SuccessionRun& run : found.runs) {
        if (run.site == group.site) {
            for (const auto& [name, share] : succession_figures(data.tables, {&run, 1}, data.judged)) {
                least = name == value ? std::min(least, share) : least;
                most = name == value ? std::max(most, share) : most;
            }
        }
    }
    return joined(fixed(least, 2), " to ", fixed(most, 2));
}

PlainTable group_table(const BeltData& data, const Found& found,
                       const std::map<std::string, double>& values) {
    PlainTable table{.caption = "What grows there by the literature, and what grew here",
                     .head = {"place", "group", "share of the biomass [-]", "by replicate [-]",
                              "lead over the greatest other species [-]", "the literature"},
                     .rows = {}};
    for (std::size_t g = 0; g < data.tables.groups.size(); ++g) {
        const succession_trial::SpeciesGroup& group = data.tables.groups[g];
        for (const SuccessionSite& site : data.tables.sites) {
            if (site.name == group.site) {
                const std::string of = joined(":", group.name, ":", site.name);
                table.rows.push_back({site_words(site), group_words(group.name),
                                      fixed(values.at(joined("share", of)), 2), spread_of(data, found, group),
                                      fixed(values.at(joined("margin", of)), 2),
                                      joined(data.published[g], " (", data.sources[g], ")")});
            }
        }
    }
    return table;
}

Outcome compare(const BeltData& data, const Work& work) {
    const std::vector<SuccessionSite>& sites = data.tables.sites;
    Found found;
    found.runs.resize(sites.size() * data.settings.replicates);
    each_piece(work, found.runs.size(), [&](std::size_t piece) {
        const SuccessionSite& site = sites[piece / data.settings.replicates];
        succession_trial::SuccessionTrial trial = trial_at(data.tables, site);
        trial.years = static_cast<int>(data.settings.years);
        trial.side_patches = static_cast<int>(data.settings.side_patches);
        trial.disturbed_from_year = static_cast<int>(data.settings.disturbed_from_year);
        found.runs[piece] = {site.name,
                             grow_succession(trial, data.species,
                                             {data.settings.seed,
                                              static_cast<std::uint32_t>(piece % data.settings.replicates)})};
    });
    Outcome outcome;
    for (const auto& [name, value] : succession_figures(data.tables, found.runs, data.judged)) {
        outcome.values[name] = value;
    }
    double most_tpha = 0.0;
    for (const SuccessionSite& site : sites) {
        found.judged_tpha.push_back(mean_biomass_tpha(found.runs, site.name, data.judged));
    }
    for (const SuccessionRun& run : found.runs) {
        for (const SuccessionState& state : run.states) {
            most_tpha = std::max(most_tpha, state.biomass_tpha());
        }
    }
    const Palette palette{data, found.judged_tpha};
    PlotGroup years{"Succession from bare ground, by elevation", {}, true};
    for (std::size_t site = 0; site < sites.size(); ++site) {
        years.plots.push_back(over_years(data, found, palette, site, most_tpha));
    }
    // A line over elevation needs two places whose climate follows elevation alone.
    if (std::count_if(sites.begin(), sites.end(), std::not_fn(has_other_climate)) >= 2) {
        const auto belts = [&](bool shares) { return over_elevation(data, found, palette, shares); };
        outcome.plots.push_back({"Belts", {belts(true), belts(false)}, false});
    }
    outcome.plots.push_back(std::move(years));
    outcome.tables = {biomass_table(data, found, palette), structure_table(data, outcome.values),
                      dead_wood_table(data, outcome.values), group_table(data, found, outcome.values)};
    const forest::DisturbanceLaw& law = data.tables.parameters.disturbance;
    if (law.wind || law.snow || law.beetle) {
        outcome.tables.push_back(disturbance_table(data, outcome.values));
    }
    return outcome;
}

/// Years that criteria speak of: at least one state must lie in them.
forest::YearWindow judged_years(const BeltSettings& settings) {
    if (settings.judged_from_year > settings.years) {
        config::fail(config::ExitCode::settings, {},
                     joined("belts.judged_from_year ", std::to_string(settings.judged_from_year)),
                     "a year up to belts.years");
    }
    return {static_cast<int>(settings.judged_from_year), static_cast<int>(settings.years)};
}

}  // namespace

Comparison read_belts(const CaseFiles& files, const BeltSettings& settings,
                      const forest::Parameters& parameters) {
    auto data = std::make_shared<BeltData>();
    data->species = species_of(files);
    const config::Table expected = table_of(files, "expected.csv");
    config::Warnings warnings;
    data->tables = {succession_trial::read_succession_sites(table_of(files, "sites.csv")),
                    succession_trial::read_species_groups(expected, data->species),
                    forest::read_climate_of_one_place(table_of(files, "climate.csv"), warnings),
                    forest::LapseRates::shipped(), parameters};
    if (files.has("native.csv")) {
        data->tables.natives = succession_trial::read_natives(table_of(files, "native.csv"), data->species);
        for (succession_trial::SpeciesGroup& native : data->tables.natives) {
            native.name = code_in_figures(data->species[native.species.front()]);
        }
    }
    config::Problems problems;
    expected.require({"published", "source"}, problems);
    problems.throw_if_any();
    for (std::size_t row = 0; row < expected.rows(); ++row) {
        data->published.push_back(expected.text(row, "published"));
        data->sources.push_back(expected.text(row, "source"));
    }
    if (data->tables.sites.empty()) {
        config::fail(config::ExitCode::data, {files.shown("sites.csv")}, "no site", "one place or more");
    }
    std::stable_sort(
        data->tables.sites.begin(), data->tables.sites.end(),
        [](const SuccessionSite& a, const SuccessionSite& b) { return a.elevation_m < b.elevation_m; });
    for (const SuccessionSite& site : data->tables.sites) {
        static_cast<void>(trial_at(data->tables, site));  // says what its climate lacks
    }
    data->settings = settings;
    data->judged = judged_years(settings);
    Comparison comparison;
    add_figures(comparison, *data);
    comparison.extent =
        joined(std::to_string(data->tables.sites.size()), " places, ", std::to_string(settings.replicates),
               " replicates of ", std::to_string(settings.side_patches * settings.side_patches),
               " patches (100 m2) over ", std::to_string(settings.years), " years");
    comparison.pieces = data->tables.sites.size() * settings.replicates;
    comparison.run = [data](const Work& work) { return compare(*data, work); };
    return comparison;
}

}  // namespace coupling::validation::forest_cases
