#include <algorithm>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/assessments/hazard/hazard_colours.hpp"
#include "coupling/assessments/hazard/hazard_results.hpp"
#include "coupling/assessments/hazard/hazard_zones.hpp"
#include "coupling/assessments/hazard/target_layer.hpp"
#include "coupling/assessments/hazard/target_ranks.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/results/figures/json.hpp"
#include "coupling/results/finish.hpp"
#include "coupling/results/maps/rasters.hpp"
#include "coupling/results/tables/data_dictionary.hpp"
#include "coupling/results/text/writing_language.hpp"

namespace coupling::hazard {
namespace {

using config::joined;

namespace fs = std::filesystem;

/// The classes of return periods of the matrix, the most frequent one darkest.
std::vector<ClassColour> period_colours(const Matrix& matrix) {
    constexpr double longest_years = 1e9;
    std::vector<ClassColour> classes;
    for (std::size_t i = 0; i < matrix.frequencies(); ++i) {
        classes.push_back({std::min(longest_years, matrix.return_period_to_years()[i]),
                           matrix.frequency_name(i),
                           colour_at(Palette::reach, 1.0 - static_cast<double>(i) /
                                                               static_cast<double>(matrix.frequencies()))});
    }
    return classes;
}

std::vector<WrittenFile> write_slope(const SlopeHazard& slope, const HazardResults& results,
                                     const fs::path& folder) {
    const std::string place = joined("rasters/", name_of(slope.cover), "/");
    const std::string where = slope.cover == Cover::forest ? " with forest." : " on the bare slope.";
    make_folder(folder / place);
    const report::WritingLanguage of_legends{results.scenario.report.language};
    const std::string& projection = results.site.projection;
    std::vector<WrittenFile> files{
        write_raster(folder,
                     {joined(place, "Hazard_level"),
                      joined("Highest hazard level of all return periods,", where), slope.map.level},
                     projection, level_colours()),
        write_raster(
            folder,
            {joined(place, compared_stem(results)),
             joined("Highest hazard level by the rule for comparison,", where), slope.compared.level},
            projection, level_colours())};
    std::vector<ClassColour> periods;
    for (const FinishedPeriod& period : results.periods) {
        // Rasters hold the years in 32 bits: a class takes all up to a little above.
        periods.push_back({1.000001 * period.return_period_years,
                           joined(config::to_text(period.return_period_years), " years"),
                           colour_at(Palette::reach, 1.0 - static_cast<double>(periods.size()) /
                                                               static_cast<double>(results.periods.size()))});
    }
    files.push_back(write_raster(
        folder,
        {joined(place, "Hazard_return_period"),
         joined("Return period [years] of the rocks that give this level,", where), slope.map.ruling_years},
        projection, periods));
    for (std::size_t i = 0; i < results.periods.size(); ++i) {
        const std::string years = config::to_text(results.periods[i].return_period_years);
        files.push_back(write_raster(
            folder,
            {joined(place, "Intensity_", years),
             joined("Class of energy of the rocks with a return period of ", years, " years,", where),
             slope.map.intensity[i]},
            projection, intensity_colours(results.matrix)));
        files.push_back(write_raster(folder,
                                     {joined(place, "Arrival_return_period_", years),
                                      joined("Mean time [years] between two arrivals in the cell of rocks "
                                             "whose return period of release is ",
                                             years, " years,", where),
                                      slope.map.arrival_years[i]},
                                     projection, period_colours(results.matrix)));
    }
    return files;
}

/// "Road – 3 (100), 12 (300)": rocks that are too few for the level of a target, in brackets the return
/// period.
std::string few_in_words(const std::string& name, const std::vector<FewRocks>& few) {
    std::string words;
    for (const FewRocks& of_period : few) {
        words += joined(words.empty() ? joined(name, " – ") : ", ", std::to_string(of_period.rocks), " (",
                        config::to_text(of_period.return_period_years), ")");
    }
    return words;
}

Json ruled_level(const RuledLevel& ruled, HazardRule rule) {
    Json json{{"rule", rule_name(rule)}, {"level", level_name(ruled.level)}};
    if (!ruled.is_free()) {
        json["release_return_period_years"] = json_number(ruled.release_years);
        json["return_period_years"] = json_number(ruled.years);
        json["intensity"] = ruled.intensity + 1;
    }
    return json;
}

/// What an energy is, of how many rocks, and whether too few for a percentile; null where none hits.
void add_energy(Json& json, const std::string& name, const EnergyOfRocks& energy) {
    const bool is_there = energy.rocks > 0;
    json[name + "_kj"] = is_there ? json_number(energy.kj) : Json{};
    json[name + "_rocks"] = energy.rocks;
    json[name + "_is"] = is_there ? Json(statistic_name(energy)) : Json{};
}

Json target_json(const TargetHazard& target, const SlopeHazard& slope) {
    Json json = ruled_level(target.ruled, slope.map.rule);
    json["rocks"] = target.rocks;
    json["hit_every_years"] = target.rocks > 0 ? json_number(1.0 / target.hits_per_year) : Json{};
    add_energy(json, "energy", target.ruled.energy);
    add_energy(json, "highest_energy", target.highest);
    json["rests_on_few_rocks"] = target.rests_on_few_rocks(slope.map.rule);
    json["compared"] = ruled_level(target.compared, slope.compared.rule);
    return json;
}

}  // namespace

void write_summary(std::ostream& out, const HazardResults& results, const std::vector<WrittenFile>& files) {
    Json summary{{"program", "Bannwald"}, {"version", results.version}};
    std::uint64_t rocks = 0;
    Json periods = Json::array();
    for (const FinishedPeriod& period : results.periods) {
        rocks += period.rocks;
        Json left;
        for (const SlopeHazard& slope : results.slopes) {
            left[name_of(slope.cover)] = json_departures(period.departures[index_of(slope.cover)]);
        }
        periods.push_back({{"return_period_years", period.return_period_years},
                           {"folder", "../" + period.folder.filename().string()},
                           {"rocks", period.rocks},
                           {"smallest_diameter_m", json_number(period.diameters.smallest_m)},
                           {"largest_diameter_m", json_number(period.diameters.largest_m)},
                           {"left_terrain", std::move(left)}});
    }
    summary["run"] = {{"scenario", results.scenario.file.filename().string()},
                      {"kind", "hazard"},
                      {"rule", rule_name(results.scenario.hazard.rule)},
                      {"smallest_zone_m2", json_number(results.scenario.hazard.smallest_zone_m2)},
                      {"seed", results.scenario.run.seed},
                      {"rocks", rocks},
                      {"map", json_map_frame(results.site.map_frame)}};
    summary["return_periods"] = std::move(periods);
    summary["targets"] = Json::array();
    for (std::size_t i = 0; i < results.site.targets.size(); ++i) {
        Json target{{"id", results.site.targets[i].id}, {"name", results.site.targets[i].name}};
        for (const SlopeHazard& slope : results.slopes) {
            target[name_of(slope.cover)] = target_json(slope.targets[i], slope);
        }
        summary["targets"].push_back(std::move(target));
    }
    if (results.risk) {
        summary["risk"] = risk::risk_json(*results.risk, results.site);
    }
    summary["warnings"] = results.warnings.warnings();
    summary["notes"] = results.warnings.notes();
    write_json_summary(out, std::move(summary), results.inputs, results.scenario, files);
}

void warn_of_few_rocks(const HazardResults& results, config::Warnings& warnings) {
    constexpr std::size_t most_named = 5;
    for (const SlopeHazard& slope : results.slopes) {
        std::size_t found = 0;
        std::string names;
        for (const std::size_t target : ranked_targets(results)) {
            const std::vector<FewRocks>& few = slope.targets[target].few_rocks;
            if (!few.empty() && ++found <= most_named) {
                names +=
                    joined(names.empty() ? "" : " / ", few_in_words(results.site.targets[target].name, few));
            }
        }
        if (found == 0) {
            continue;
        }
        const HazardEnergy energy = results.scenario.hazard.energy;
        const bool by_class = slope.map.rule == HazardRule::cadanav;
        const std::string needed =
            by_class
                ? joined("how often they hit is known from about ", std::to_string(least_rocks_of_class),
                         " rocks of the same weight on")
                : joined("the ", stem_of(energy).substr(2), "th percentile needs at least ",
                         std::to_string(least_rocks(energy)), "; of fewer the largest energy stands for it");
        warnings.add(
            joined(slope.cover == Cover::forest ? "levels with forest" : "levels on the bare slope",
                   " may be too low or too high, at ", std::to_string(found), " of ",
                   std::to_string(slope.targets.size()), " targets (",
                   by_class ? "rocks of the class of energy that gives the level, in brackets the return "
                              "period in years that brings most of them: "
                            : "rocks that hit, in brackets their return period in years: ",
                   names, found > most_named ? " / …" : "", "): ", needed, "; raise release.rocks for more"));
    }
}

std::vector<WrittenFile> write_results(const HazardResults& results, const fs::path& folder,
                                       const WriteWatch& watch) {
    std::vector<WrittenFile> files{
        {"report.html",
         "The hazard map as a page: levels, targets, intensities. Opens offline in any browser."},
        {"summary.json", "Levels at the targets, settings, input hashes and warnings for scripts."}};
    const auto add = [&](const std::vector<WrittenFile>& more) {
        files.insert(files.end(), more.begin(), more.end());
    };
    add(write_tables(results, folder));
    std::vector<TableLayout> layouts = hazard_layouts();
    if (results.risk) {
        add(risk::write_tables(*results.risk, results.site, folder));
        layouts = together(layouts, risk::risk_layouts());
        if (results.risk->avoided) {
            add(risk::write_avoided(*results.risk, folder));
            layouts = together(layouts, risk::avoided_layouts());
        }
    }
    for (const SlopeHazard& slope : results.slopes) {
        watch("rasters");
        add(write_slope(slope, results, folder));
    }
    watch("hazard zones");
    std::vector<geopackage::AreaLayer> layers = zone_layers(results);
    if (!results.site.targets.empty()) {
        layers.push_back(target_layer(results));
    }
    finish_results(
        folder,
        {.scenario = results.scenario,
         .dictionary = {layouts, hazard_raster_columns(results)},
         .summary = [&](std::ostream& out, const auto& written) { write_summary(out, results, written); },
         .page = [&](std::ostream& out, const auto& written) { write_page(out, results, written); },
         .drawn = &results.site,
         .areas = layers},
        files, watch);
    return files;
}

}  // namespace coupling::hazard
