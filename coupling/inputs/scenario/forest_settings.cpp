#include "coupling/inputs/scenario/forest_settings.hpp"

#include <algorithm>
#include <cmath>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"

namespace coupling {
namespace {

using config::joined;

void declare_run(config::Options& options, ForestSettings& s) {
    options.count(
        "run.first_year", s.first_year,
        {.unit = "yr",
         .low = 0.0,
         .high = 9999.0,
         .meaning = "calendar year of the first simulated year; 0: first year of the climate window",
         .source = "choice",
         .needs = {{"run.years"}}});
    options.count("run.rockfall_every", s.rockfall_every,
                  {.unit = "yr",
                   .low = 0.0,
                   .high = 1000.0,
                   .meaning = "rocks fall every n-th simulated year; 0: the forest alone",
                   .source = "choice",
                   .needs = {{"run.years"}}});
    options.count("run.replicates", s.replicates,
                  {.low = 1.0,
                   .high = 10'000.0,
                   .meaning = "how often the years are simulated, each time with chance of its own",
                   .source = "choice"});
}

void declare_forest(config::Options& options, ForestSettings& s) {
    options.number("forest.latitude_deg", s.latitude_deg,
                   {.unit = "deg",
                    .low = 0.0,
                    .high = 75.0,
                    .meaning = "latitude of the slope, north; needed for run.years > 0"});
    options.file("forest.species", s.species,
                 {.meaning = "CSV with the columns of the shipped species table, instead of it"});
    options.text(
        "forest.region_species", s.region_species,
        {.meaning = "species whose seeds come from outside, such as PIAB, ABAL; none: all of the table",
         .source = "choice"});
    options.text(
        "forest.browsing_by_species", s.browsing_by_species,
        {.meaning = "factors on forest.browsing_pressure for some species, such as ABAL 1.5, FASY 0.7; "
                    "none: 1 for all",
         .source = "choice",
         .needs = {{"forest.regeneration"}}});
    options.choice(
        "forest.edges", s.edges,
        {{"mirror", forest::Edges::mirror},
         {"open", forest::Edges::open},
         {"periodic", forest::Edges::torus}},
        {.meaning = "what shades the rim of the area: the forest goes on as in a mirror, ends, or "
                    "goes on as at the opposite side (periodic: an even plot within a large forest)",
         .source = "choice"});
}

void declare_stands(config::Options& options, ForestSettings& s) {
    options.file("stands.map", s.stand_map,
                 {.meaning = "grid of stand numbers, any cell size; 0 or NODATA: no forest"});
    options.file("stands.polygons", s.stand_polygons,
                 {.meaning = "instead: CSV with stand, wkt (POLYGON); neither: all the terrain is stand 1"});
    options.count("stands.number", s.stand_number,
                  {.low = 0.0,
                   .high = 4e9,
                   .meaning = "instead of a map: all the terrain is this one of the stands of stands.records "
                              "and stands.dbh_classes; 0: stand 1, the only one"});
    options.file(
        "stands.records", s.stand_records,
        {.meaning = "CSV with stand, species, stems_pha, basal_area_m2pha, mean_dbh_cm, mean_height_m, "
                    "age_years, structure; instead of trees.file, or beside it with stands.tree_area"});
    options.file(
        "stands.cover", s.stand_cover,
        {.meaning = "grid of crown cover, in percent or as a share: the stems of a stand are placed in "
                    "proportion to it, none where it is 0; their number stays that of the records"});
    options.file(
        "stands.tree_area", s.tree_area,
        {.meaning = "CSV with wkt (POLYGON): inside, trees are those of trees.file, elsewhere those of "
                    "stands.records"});
    options.file(
        "stands.dead_wood", s.dead_wood,
        {.meaning = "CSV with stand, species, kind (snag, stump, log), volume_m3pha, dbh_cm, length_m, "
                    "decay_class, log_angle_deg, anchored: dead wood at the start"});
    options.file(
        "stands.dbh_classes", s.dbh_classes,
        {.meaning = "CSV with stand, species, dbh_from_cm, dbh_to_cm, stems_pha, height_m, age_years: stems "
                    "by diameter class, for stands that stands.records does not have"});
    options.file(
        "stands.target_profile", s.target_profile,
        {.meaning = "CSV with stand, site_type, hazard, criterion, minimal, ideal: the target profile (NaiS) "
                    "of each stand for nais.csv; empty: the shipped one for the size of the rocks"});
    options.count(
        "stands.spin_up_years", s.spin_up_years,
        {.unit = "yr",
         .low = 0.0,
         .high = 300.0,
         .meaning =
             "years that the forest grows before the start, only to make the dead wood and the saplings "
             "that no file gives; the trees of the start stay those of the inventory"});
    options.file(
        "stands.saplings", s.saplings,
        {.meaning = "CSV with stand, species, height_m, stems_pha, age_years: trees below 1 cm at the "
                    "start"});
}

void declare_soil(config::Options& options, ForestSettings& s) {
    options.file("soil.map", s.soil_map, {.meaning = "grid of soil codes, any cell size"});
    options.file(
        "soil.types", s.soil_types,
        {.meaning =
             "CSV with code, water_capacity_mm, texture_class, fertility, nitrogen_kg_per_ha_year, ph"});
    options.text(
        "soil.type", s.soil_type,
        {.meaning = "soil where no map says: scree, shallow, normal, deep, or a code of soil.types"});
}

void declare_regimes(config::Options& options, ForestSettings& s) {
    options.text("regimes.list", s.regimes,
                 {.meaning = "regimes to compare, such as none, pfm1, my_regime.csv: shipped names or files",
                  .source = "choice",
                  .files = config::NamesFiles::several});
    options.file(
        "regimes.timber_prices", s.timber_prices,
        {.meaning = "CSV of prices by species and diameter, with regimes.work_costs; none: shipped"});
    options.file("regimes.work_costs", s.work_costs,
                 {.meaning = "CSV of the costs of planting, tending and fencing"});
    options.number(
        "regimes.machine_m3_per_hour", s.machine_m3ph,
        {.unit = "m3/h",
         .low = 0.1,
         .high = 100.0,
         .meaning = "stem wood that a machine (cable yarder, forwarder) brings out in an hour: makes the "
                    "machine hours of removed wood",
         .source = "choice; cable yarders in the Alps mostly 5 to 12 (Spinelli et al. 2015 [lit*])"});
}

void declare_decision(config::Options& options, DecisionSettings& s) {
    options.number("decision.protection_at_least", s.protection_at_least_percent,
                   {.unit = "%",
                    .low = 0.0,
                    .high = 100.0,
                    .meaning = "protection that a regime must keep in all years with rocks after the start",
                    .source = "choice"});
    options.number("decision.probability", s.probability,
                   {.low = 0.01,
                    .high = 0.99,
                    .meaning = "probability with which it must keep it, as a share of replicates",
                    .source = "choice"});
    options.number("decision.discount_percent", s.discount_percent,
                   {.unit = "%",
                    .low = 0.0,
                    .high = 20.0,
                    .meaning = "interest a year by which money of later years counts less",
                    .source = "choice"});
    options.number(
        "decision.years_beyond", s.years_beyond,
        {.unit = "yr",
         .low = 0.0,
         .high = 200.0,
         .meaning = "years after the last one for which its protection stays, in percent-years lost",
         .source = "choice"});
}

void declare_feedback(config::Options& options, ForestSettings& s) {
    options.flag("feedback.on", s.feedback,
                 {.meaning = "rocks break, uproot and wound trees, which changes the years after",
                  .source = "choice"});
    options.number(
        "feedback.rocks_per_year", s.rocks_per_year,
        {.unit = "1/yr",
         .low = 0.0,
         .high = 1e6,
         .meaning = "rocks that really fall in a year on the whole slope; a share of the simulated ones",
         .source = "needed with feedback.on",
         .needs = {{"feedback.on"}}});
}

void declare_climate(config::Options& options, ForestSettings& s) {
    options.file(
        "climate.file", s.climate,
        {.meaning = "CSV with year, month, tmin_c, tmax_c, prec_mm, rad_mj_m2_d; needed for run.years > 0"});
    options.number("climate.elevation_m", s.climate_elevation_m,
                   {.unit = "m",
                    .low = -500.0,
                    .high = 9000.0,
                    .meaning = "height of the place of the series, where it has no column elev_m"});
    options.choice(
        "climate.sequence", s.order,
        {{"once", ClimateOrder::once}, {"repeat", ClimateOrder::repeat}, {"random", ClimateOrder::random}},
        {.meaning = "climate of simulated years: their own, then the window again, or drawn from it",
         .source = "choice"});
    options.count(
        "climate.window_first_year", s.window_first_year,
        {.unit = "yr", .low = 0.0, .high = 9999.0, .meaning = "years before are left out; 0: none"});
    options.count("climate.window_last_year", s.window_last_year,
                  {.unit = "yr", .low = 0.0, .high = 9999.0, .meaning = "years after are left out; 0: none"});
    options.number(
        "climate.temperature_change_k", s.temperature_change_k,
        {.unit = "K", .low = -15.0, .high = 15.0, .meaning = "added to the temperatures of all months"});
    options.number("climate.precipitation_change", s.precipitation_change,
                   {.low = 0.0, .high = 5.0, .meaning = "factor on the precipitation of all months"});
    options.file("climate.change", s.climate_change,
                 {.meaning = "instead of the two: CSV with month, temperature_k, precipitation (factor)"});
    options.whole_numbers(
        "climate.dry_years", s.dry_years,
        {.unit = "yr",
         .low = 0.0,
         .high = 9999.0,
         .meaning = "calendar years with a dry, warm season from April to September, in all "
                    "replicates, regimes and climates"});
    options.number("climate.dry_season_k", s.dry_season_k,
                   {.unit = "K",
                    .low = 0.0,
                    .high = 10.0,
                    .meaning = "added to the temperatures of April to September in climate.dry_years",
                    .source = "choice; Sonnblick 2003 and 2018: 2.3 and 2.9",
                    .needs = {{"climate.dry_years"}}});
    options.number("climate.dry_season_precipitation", s.dry_season_precipitation,
                   {.low = 0.0,
                    .high = 1.0,
                    .meaning = "factor on the precipitation of April to September in climate.dry_years",
                    .source = "choice; Sion 2003 and 2018: 0.84 and 0.74",
                    .needs = {{"climate.dry_years"}}});
    options.count(
        "climate.change_years", s.change_years,
        {.unit = "yr",
         .low = 0.0,
         .high = 1000.0,
         .meaning = "years in which the change grows evenly to its full size; 0: full from the start",
         .source = "choice"});
    options.number(
        "climate.co2_ppm", s.co2_ppm,
        {.unit = "ppm",
         .low = 0.0,
         .high = 2000.0,
         .meaning = "CO2 of the air in all years; 0: the record, after its end as in the last year",
         .source = "choice"});
    options.file(
        "climate.variants", s.climate_variants,
        {.meaning = "CSV of climates to compare: name and, of the settings above, what differs (file, "
                    "temperature_change_k, ...); none: one climate"});
}

void declare_output(config::Options& options, ForestSettings& s) {
    options.whole_numbers(
        "output.tree_list_years", s.tree_list_years,
        {.unit = "yr",
         .low = 0.0,
         .high = 1000.0,
         .meaning = "years of simulation (0 = start) with a list of trees; none: first and last",
         .needs = {{"run.years"}}});
    options.whole_numbers("output.map_years", s.map_years,
                          {.unit = "yr",
                           .low = 0.0,
                           .high = 1000.0,
                           .meaning = "years of simulation (0 = start) with maps; none: first and last",
                           .needs = {{"run.years"}}});
    options.flag(
        "output.living_trees_alone", s.living_trees_alone,
        {.meaning = "the same rocks fall once more through the living trees without snags, stumps and logs: "
                    "protection_living_percent in regimes_by_year.csv; costs about a third more time",
         .needs = {{"run.years"}}});
    options.flag(
        "output.all_removed_trees", s.list_all_removed,
        {.meaning = "removed_trees.csv lists each tree of 7 cm and more that left the forest, with its "
                    "cause; no: only those that rocks killed",
         .needs = {{"run.years"}}});
}

/// Adds problems at the line where a setting stands.
struct Checker {
    const config::Options& options;
    config::Problems& problems;

    void refuse(const std::string& key, std::string found, std::string expected) {
        problems.add(config::ExitCode::settings, options.place_of(key), std::move(found),
                     std::move(expected));
    }
};

void check_years(const std::string& key, const std::vector<double>& asked_for, std::uint64_t years,
                 Checker& checker) {
    for (const double year : asked_for) {
        if (std::floor(year) != year || year > static_cast<double>(years)) {
            const bool is_whole = std::floor(year) == year;
            const std::string last = std::to_string(years);
            checker.refuse(key,
                           joined(key, " with year ", config::to_text(year),
                                  is_whole ? joined(", but the run ends with year ", last) : ""),
                           joined("whole years from 0 to ", last,
                                  is_whole ? joined(", or run.years of ", config::to_text(year)) : ""));
        }
    }
}

void check_climate(const ForestSettings& s, Checker& checker) {
    if (s.climate.empty() && s.climate_variants.empty()) {
        checker.refuse("climate.file", "run.years above 0 without climate.file",
                       "a table of monthly climate");
    }
    if (s.window_first_year > 0 && s.window_last_year > 0 && s.window_last_year < s.window_first_year) {
        checker.refuse(
            "climate.window_last_year",
            joined("climate.window_last_year ", std::to_string(s.window_last_year)),
            joined("no year before climate.window_first_year ", std::to_string(s.window_first_year)));
    }
    if (s.co2_ppm != 0.0 && s.co2_ppm < 100.0) {
        checker.refuse("climate.co2_ppm", joined("climate.co2_ppm ", config::to_text(s.co2_ppm)),
                       "0 for the record, or a number in [100, 2000] ppm");
    }
    if (s.co2_ppm != 0.0 && !s.parameters.processes.co2_response) {
        checker.refuse("climate.co2_ppm", "climate.co2_ppm without forest.co2_response",
                       "forest.co2_response = yes");
    }
    for (const std::string key : {"climate.temperature_change_k", "climate.precipitation_change"}) {
        if (!s.climate_change.empty() && checker.options.was_set(key)) {
            checker.refuse("climate.change", joined("climate.change beside ", key), "only one of them");
        }
    }
}

}  // namespace

void declare(config::Options& options, ForestSettings& settings) {
    declare_run(options, settings);
    declare_forest(options, settings);
    forest::declare(options, settings.parameters);
    declare_stands(options, settings);
    declare_soil(options, settings);
    declare_regimes(options, settings);
    declare_decision(options, settings.decision);
    declare_feedback(options, settings);
    declare_climate(options, settings);
    declare_output(options, settings);
}

void check(const ForestSettings& s, std::uint64_t years, bool listed_trees, const config::Options& options,
           config::Problems& problems) {
    Checker checker{options, problems};
    if (!s.stand_map.empty() && !s.stand_polygons.empty()) {
        checker.refuse("stands.polygons", "stands.polygons beside stands.map", "only one of them");
    }
    if (s.stand_number > 0 && (!s.stand_map.empty() || !s.stand_polygons.empty())) {
        checker.refuse("stands.number", "stands.number beside a map of stands", "only one of them");
    }
    if (!s.stand_cover.empty() && s.stand_records.empty() && s.dbh_classes.empty()) {
        checker.refuse("stands.cover", "stands.cover without stands.records or stands.dbh_classes",
                       "the stems that are to stand there: a cover says neither how many nor how thick");
    }
    if (years == 0) {
        if (s.rockfall_every == 0) {
            checker.refuse("run.rockfall_every", "neither rocks nor years",
                           "run.rockfall_every or run.years above 0");
        }
        if (s.replicates > 1) {
            checker.refuse("run.replicates", joined("run.replicates ", std::to_string(s.replicates)),
                           "1 where run.years is 0: more rocks narrow the figures of a standing forest");
        }
        return;
    }
    if (!options.was_set("forest.latitude_deg")) {
        checker.refuse("forest.latitude_deg", "run.years above 0 without forest.latitude_deg",
                       "a number in [0, 75] deg");
    }
    if (s.feedback && s.rocks_per_year <= 0.0) {
        checker.refuse("feedback.rocks_per_year", "feedback.on without feedback.rocks_per_year",
                       "how many rocks really fall in a year");
    }
    if (s.feedback && s.rockfall_every != 1) {
        checker.refuse("feedback.on",
                       "feedback.on with run.rockfall_every " + std::to_string(s.rockfall_every),
                       "run.rockfall_every = 1: damage is counted year by year");
    }
    if (s.timber_prices.empty() != s.work_costs.empty()) {
        checker.refuse(s.timber_prices.empty() ? "regimes.work_costs" : "regimes.timber_prices",
                       "only one of regimes.timber_prices and regimes.work_costs", "both, or neither");
    }
    if (s.spin_up_years > 0 && !s.dead_wood.empty() && !s.saplings.empty()) {
        checker.refuse("stands.spin_up_years",
                       "stands.spin_up_years beside both stands.dead_wood and stands.saplings",
                       "one of the files at most: spin-up makes what no file gives");
    }
    const bool has_records = !s.stand_records.empty() || !s.dbh_classes.empty();
    if (listed_trees && has_records && s.tree_area.empty()) {
        checker.refuse(s.stand_records.empty() ? "stands.dbh_classes" : "stands.records",
                       s.stand_records.empty() ? "stands.dbh_classes beside trees.file"
                                               : "stands.records beside trees.file",
                       "only one of them, or stands.tree_area with the polygons in which the list holds");
    }
    if (!s.tree_area.empty() && (!listed_trees || !has_records)) {
        checker.refuse("stands.tree_area", "stands.tree_area without both trees.file and stands.records",
                       "both of them: the list holds inside, the records elsewhere");
    }
    if (s.soil_map.empty() && s.soil_type.empty()) {
        checker.refuse("soil.type", "run.years above 0 without a soil",
                       "soil.type, or soil.map with soil.types");
    }
    if (!s.soil_map.empty() && s.soil_types.empty()) {
        checker.refuse("soil.map", "soil.map without soil.types", "both of them, or soil.type alone");
    }
    if (s.soil_map.empty() && !s.soil_types.empty() && !s.soil_type.empty() &&
        !config::parse_whole(s.soil_type)) {
        checker.refuse("soil.types",
                       joined("soil.types beside soil.type = ", s.soil_type, ", without soil.map"),
                       "a code of soil.types as soil.type, soil.map, or no soil.types");
    }
    check_climate(s, checker);
    check_years("output.tree_list_years", s.tree_list_years, years, checker);
    check_years("output.map_years", s.map_years, years, checker);
}

std::vector<int> chosen_years(const std::vector<double>& asked_for, std::uint64_t years) {
    std::vector<int> chosen(asked_for.begin(), asked_for.end());
    if (chosen.empty()) {
        chosen = {0, static_cast<int>(years)};
    }
    std::sort(chosen.begin(), chosen.end());
    chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
    return chosen;
}

}  // namespace coupling
