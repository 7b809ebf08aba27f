#include <algorithm>
#include <memory>

#include "config/text/joined.hpp"
#include "validation/engine/forest_cases/shared/comparison.hpp"
#include "validation/engine/forest_cases/shared/plot_checks.hpp"
#include "validation/engine/forest_cases/shared/slip_checks.hpp"
#include "validation/engine/forest_cases/shared/unknown_columns.hpp"
#include "validation/engine/forest_cases/yield_checks.hpp"
#include "validation/engine/forest_cases/yield_pages.hpp"

namespace coupling::validation::forest_cases {
namespace {

using config::joined;
using forest::TreeLight;
using yield_trial::Agreement;
using yield_trial::SiteYields;
using yield_trial::Treatment;
using yield_trial::YieldSite;

/// A figure of a stand at an age, by its name in yield_trial.
struct YieldMeasure {
    const char* name;
    const char* label;
    const char* unit;
    bool of_table;  ///< compared with the table
};
constexpr std::array<YieldMeasure, 8> yield_measures{{{"volume_ratio", "volume / table", "-", true},
                                                      {"dbh_ratio", "mean DBH / table", "-", true},
                                                      {"height_ratio", "mean height / table", "-", true},
                                                      {"stems_ratio", "stems / table", "-", true},
                                                      {"volume_m3pha", "volume", "m3/ha", false},
                                                      {"dbh_cm", "mean DBH", "cm", false},
                                                      {"height_m", "mean height", "m", false},
                                                      {"stems_pha", "stems", "1/ha", false}}};
constexpr std::array<YieldMeasure, 4> twin_measures{
    {{"top_height_ratio", "top height / table, left alone", "-", true},
     {"twin_volume_m3pha", "volume, left alone", "m3/ha", false},
     {"twin_stems_pha", "stems, left alone", "1/ha", false},
     {"slenderness", "slenderness of the 100 thickest, left alone", "m/m", false}}};
constexpr const char* layers_volume = "layers_volume_m3pha";

/// Ages that the fit has seen, and those that it has not.
struct AgePart {
    const char* name;
    const char* label;
    int from_years;
    int to_years;
};
constexpr std::array<AgePart, 3> age_parts{{{"to_100", "ages up to 100", 0, 100},
                                            {"beyond_100", "ages above 100", 101, 10'000},
                                            {"all", "all ages", 0, 10'000}}};

std::vector<forest::SpeciesId> species_with_table(const YieldData& data) {
    std::vector<forest::SpeciesId> kinds;
    for (const YieldSite& site : data.tables.sites) {
        if (!site.table.empty() && std::find(kinds.begin(), kinds.end(), site.species) == kinds.end()) {
            kinds.push_back(site.species);
        }
    }
    return kinds;
}

std::string code_of(const YieldData& data, forest::SpeciesId kind) {
    return code_in_figures(data.species[kind]);
}

void add_figures(Comparison& comparison, const YieldData& data, const YieldSite& site) {
    const std::string of_site = words_of(data, site);
    for (const int age_years : ages_of(data.tables, site, data.ages_years)) {
        const std::string place = joined(":", site.name, ":", std::to_string(age_years));
        const std::string words = joined(", ", of_site, ", age ", std::to_string(age_years));
        for (const YieldMeasure& measure : yield_measures) {
            if (!measure.of_table || !site.table.empty()) {
                comparison.figures.push_back(
                    {measure.name + place, joined(measure.label, words), measure.unit});
            }
        }
        if (!data.twins) {
            continue;
        }
        for (const YieldMeasure& measure : twin_measures) {
            if (!measure.of_table || !site.table.empty()) {
                comparison.figures.push_back(
                    {measure.name + place, joined(measure.label, words), measure.unit});
            }
        }
        comparison.figures.push_back(
            {layers_volume + place, joined("volume in light by layers, left alone", words), "m3/ha"});
    }
    if (data.twins) {
        comparison.figures.push_back({joined("greatest_density:", site.name),
                                      joined("most stems / self-thinning line, ", of_site), "-"});
        comparison.figures.push_back({joined("density_at_25cm:", site.name),
                                      joined("stems / self-thinning line at a mean DBH of 25 cm, ", of_site),
                                      "-"});
    }
}

void add_shares(Comparison& comparison, const YieldData& data) {
    for (const AgePart& part : age_parts) {
        comparison.figures.push_back(
            {joined("share_within:all:", part.name),
             joined("volume, DBH and height within 15 % of the table, all species, ", part.label), "-"});
        for (const forest::SpeciesId kind : species_with_table(data)) {
            comparison.figures.push_back(
                {joined("share_within:", code_of(data, kind), ":", part.name),
                 joined("the same, ", data.species[kind].latin_name, ", ", part.label), "-"});
        }
    }
}

void add_share_values(Outcome& outcome, const YieldData& data, const std::vector<SiteOutcome>& found) {
    for (const AgePart& part : age_parts) {
        Agreement all;
        for (const forest::SpeciesId kind : species_with_table(data)) {
            Agreement own;
            for (std::size_t i = 0; i < found.size(); ++i) {
                if (data.tables.sites[i].species == kind) {
                    own += agreement_of(found[i].thinned, part.from_years, part.to_years);
                }
            }
            outcome.values[joined("share_within:", code_of(data, kind), ":", part.name)] = own.share();
            all += own;
        }
        outcome.values[joined("share_within:all:", part.name)] = all.share();
    }
}

Outcome compare(const YieldData& data, const Work& work) {
    const std::size_t sites = data.tables.sites.size();
    const std::size_t ways = data.twins ? 3 : 1;
    std::vector<SiteOutcome> found(sites);
    each_piece(work, ways * sites, [&](std::size_t piece) {
        SiteOutcome& of = found[piece / ways];
        const std::size_t way = piece % ways;
        SiteYields& here = way == 0 ? of.thinned : way == 1 ? of.twin : of.layers;
        here = compare_yields(data.tables, data.tables.sites[piece / ways], data.species,
                              way == 0 ? Treatment::as_the_table : Treatment::left_alone,
                              way == 2 ? TreeLight::by_layers : TreeLight::in_space, data.ages_years);
    });
    Outcome outcome;
    const auto note = [&outcome](const std::vector<std::pair<std::string, double>>& figures) {
        for (const auto& [name, value] : figures) {
            outcome.values[name] = value;
        }
    };
    for (const SiteOutcome& site : found) {
        note(yield_figures(site.thinned));
        if (data.twins) {
            note(twin_figures(site.twin));
        }
        for (const yield_trial::YieldComparison& one : site.layers.ages) {
            outcome.values[joined(layers_volume, ":", one.site, ":", std::to_string(one.age_years))] =
                one.simulated.figures.volume_m3pha;
        }
    }
    add_share_values(outcome, data, found);
    add_yield_pages(outcome, data, found);
    return outcome;
}

/// Ages drawn over elevation must be ages that are compared.
void check_drawn(const std::vector<int>& some, const std::vector<int>& all) {
    for (const int age_years : some) {
        if (std::find(all.begin(), all.end(), age_years) == all.end()) {
            config::fail(config::ExitCode::settings, {},
                         joined("yield.drawn_ages_years ", std::to_string(age_years)),
                         "ages of yield.ages_years");
        }
    }
}

/// There must be an age, and a stand without a table is a plantation of 12 years at its start.
void check_ages(const YieldData& data, const CaseFiles& files) {
    if (data.ages_years.empty()) {
        config::fail(config::ExitCode::data, {files.shown("sites.csv")}, "no age to compare stands at",
                     "a site with a table of two ages or more, or yield.ages_years",
                     "name the table and class of each site as yield_tables.csv has them");
    }
    constexpr int planted_years = 12;
    for (const YieldSite& site : data.tables.sites) {
        if (site.table.empty() && data.ages_years.front() <= planted_years) {
            config::fail(config::ExitCode::data, {files.shown("sites.csv")},
                         joined("site ", site.name, " without a table at age ",
                                std::to_string(data.ages_years.front())),
                         "ages above 12 years, at which it is planted");
        }
    }
}

void check_latitudes(const YieldData& data, const config::Table& sites, const CaseFiles& files) {
    const bool is_given = sites.has("latitude_deg");
    config::Problems problems;
    for (std::size_t row = 0; row < (is_given ? sites.rows() : std::min<std::size_t>(1, sites.rows()));
         ++row) {
        const double latitude_deg = data.tables.sites[row].latitude.in_degrees();
        const config::Place place = is_given ? sites.place(row, "latitude_deg") : config::Place{sites.file()};
        const std::string field =
            is_given ? joined("latitude_deg ", sites.text(row, "latitude_deg"))
                     : joined("no column latitude_deg, so that ", config::to_text(latitude_deg), " is taken");
        const std::size_t before = problems.list().size();
        for (const forest::ClimateSeries& climate : data.tables.climates) {
            check_temperature_seasons(latitude_deg, place, field, climate, files.shown("climate.csv"),
                                      problems);
            if (problems.list().size() > before) {
                break;  // once for a site
            }
        }
    }
    problems.throw_if_any();
}

}  // namespace

Comparison read_yield(const CaseFiles& files, const YieldSettings& settings,
                      const forest::Parameters& parameters) {
    auto data = std::make_shared<YieldData>();
    config::Warnings warnings;
    data->species = species_of(files);
    const config::Table sites = table_of(files, "sites.csv");
    warn_of_unknown_columns(sites, yield_trial::site_columns(), warnings);
    const config::Table rows = table_of(files, "yield_tables.csv");
    warn_of_unknown_columns(rows, yield_trial::row_columns(), warnings);
    data->tables = {yield_trial::read_yield_sites(sites, data->species), yield_trial::read_yield_rows(rows),
                    forest::read_climate(table_of(files, "climate.csv"), warnings), parameters};
    warn_of_yield_rows(rows, data->tables.rows, warnings);
    check_latitudes(*data, sites, files);
    for (std::size_t row = 0; row < sites.rows() && sites.has("latitude_deg"); ++row) {
        warn_of_latitude(data->tables.sites[row].latitude.in_degrees(), sites.place(row, "latitude_deg"),
                         warnings);
    }
    data->ages_years = settings.ages_years.empty() ? ages_of_tables(data->tables)
                                                   : rising("yield.ages_years", settings.ages_years);
    config::Problems problems;
    check_sites(sites, data->tables, data->ages_years, files.shown("yield_tables.csv"), problems);
    problems.throw_if_any();
    check_ages(*data, files);
    data->drawn_ages_years = settings.drawn_ages_years.empty()
                                 ? usual_drawn_ages(data->tables, data->ages_years)
                                 : rising("yield.drawn_ages_years", settings.drawn_ages_years);
    data->twins = settings.twins;
    check_drawn(data->drawn_ages_years, data->ages_years);
    Comparison comparison;
    comparison.warnings = warnings.all();
    for (const YieldSite& site : data->tables.sites) {
        add_figures(comparison, *data, site);
    }
    add_shares(comparison, *data);
    comparison.extent =
        joined(std::to_string(data->tables.sites.size()), " stands up to age ",
               std::to_string(data->ages_years.back()),
               settings.twins ? ", thinned as their tables and left alone, the latter in two kinds of light"
                              : ", thinned as their tables");
    comparison.pieces = (settings.twins ? 3 : 1) * data->tables.sites.size();
    comparison.run = [data](const Work& work) { return compare(*data, work); };
    return comparison;
}

}  // namespace coupling::validation::forest_cases
