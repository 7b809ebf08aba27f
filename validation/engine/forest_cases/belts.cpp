#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>

#include "config/errors/warnings.hpp"
#include "config/text/joined.hpp"
#include "coupling/inputs/reading/reading.hpp"
#include "forest/climate/series.hpp"
#include "validation/engine/forest_cases/belts/plots.hpp"
#include "validation/engine/forest_cases/belts/tables.hpp"
#include "validation/engine/forest_cases/shared/unknown_columns.hpp"

namespace coupling::validation::forest_cases {
namespace {

using belts::BeltData;
using belts::Found;
using belts::group_words;
using belts::Palette;
using belts::site_words;
using config::joined;
using succession_trial::SuccessionRun;
using succession_trial::SuccessionSite;
using succession_trial::SuccessionState;

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
        years.plots.push_back(belts::over_years(data, found, palette, site, most_tpha));
    }
    // A line over elevation needs two places whose climate follows elevation alone.
    if (std::count_if(sites.begin(), sites.end(), std::not_fn(belts::has_other_climate)) >= 2) {
        const auto belts_of = [&](bool shares) {
            return belts::over_elevation(data, found, palette, shares);
        };
        outcome.plots.push_back({"Belts", {belts_of(true), belts_of(false)}, false});
    }
    outcome.plots.push_back(std::move(years));
    outcome.tables = belts::tables_of(data, found, palette, outcome.values);
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
    const config::Table sites = table_of(files, "sites.csv");
    warn_of_unknown_columns(sites, succession_trial::site_columns(), warnings);
    warn_of_unknown_columns(expected, {"site", "group", "species", "published", "source"}, warnings);
    data->tables = {succession_trial::read_succession_sites(sites),
                    succession_trial::read_species_groups(expected, data->species),
                    forest::read_climate_of_one_place(table_of(files, "climate.csv"), warnings),
                    forest::LapseRates::shipped(), parameters};
    if (files.has("native.csv")) {
        const config::Table natives = table_of(files, "native.csv");
        warn_of_unknown_columns(natives, {"site", "species"}, warnings);
        data->tables.natives = succession_trial::read_natives(natives, data->species);
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
    comparison.warnings = warnings.all();
    add_figures(comparison, *data);
    comparison.extent =
        joined(counted(data->tables.sites.size(), "place"), ", ", counted(settings.replicates, "replicate"),
               " of ", std::to_string(settings.side_patches * settings.side_patches),
               " patches (100 m2) over ", std::to_string(settings.years), " years");
    comparison.pieces = data->tables.sites.size() * settings.replicates;
    comparison.run = [data](const Work& work) { return compare(*data, work); };
    return comparison;
}

}  // namespace coupling::validation::forest_cases
